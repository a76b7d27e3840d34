from __future__ import annotations

import io

import footfall as ff


def test_warming_up_tells_each_step_and_the_time_it_took() -> None:
    out = io.StringIO()
    seconds = ff.warmup(out)
    lines = out.getvalue().splitlines()
    assert lines[0] == "footfall: preparing kernels, 1 of 3: motions"
    assert lines[-1] == f"footfall: kernels ready after {seconds:.1f} s"
    assert len(lines) == 4

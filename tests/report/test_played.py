"""How long phases lasted, seen from where the clip was in each frame."""

from __future__ import annotations

import numpy as np
import pytest

from footfall.report import played_phases
from footfall.support import Support, SupportSequence

WALK = SupportSequence.parse("R.4 D.1 L.4 D.1*")
KICK = SupportSequence.parse("D.5 L1 D.5")


def test_a_clip_at_half_its_speed_is_stretched_by_one_octave() -> None:
    phases = played_phases(np.arange(240) / 120.0 + 3.0, WALK, 60.0)
    assert [phase.support for phase in phases] == [
        Support.DOUBLE, Support.LEFT, Support.DOUBLE, Support.RIGHT, Support.DOUBLE, Support.LEFT,
    ]  # fmt: skip
    assert [phase.octaves for phase in phases] == pytest.approx([1.0] * 6)
    assert [phase.clip_seconds for phase in phases] == pytest.approx(
        [0.1, 0.4, 0.1, 0.4, 0.1, 0.4], abs=0.01
    )


def test_phases_cut_by_a_start_or_a_stop_are_left_out() -> None:
    times = np.full(200, np.nan)
    times[20:140] = np.arange(120) / 60.0
    phases = played_phases(times, KICK, 60.0)
    assert [(phase.support, phase.clock_seconds) for phase in phases] == [(Support.LEFT, 1.0)]


def test_what_never_played_has_no_phases() -> None:
    assert played_phases(np.full(50, np.nan), WALK, 60.0) == ()

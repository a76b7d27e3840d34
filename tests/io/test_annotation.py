from __future__ import annotations

from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from footfall.errors import FileFormatError
from footfall.io import load_supports, parse_supports, save_supports, supports_text
from footfall.support import Support, SupportPhase, SupportSequence

FILE = Path("walk.supports")
WALK = """# support phases from the first frame on: symbol and seconds
cyclic
R 0.383
D 0.117
L 0.383
D 0.117
"""


def test_a_walk_is_read() -> None:
    assert parse_supports(WALK, FILE) == SupportSequence.parse("R.383 D.117 L.383 D.117*")


@pytest.mark.parametrize(
    "text",
    [
        "R 1\nL .5\n",
        "once\nR 1\nL .5\n",
        "R 1\nL .5\nonce",
        "\n# a\r\n  R\t1.0 # first\r\n\r\nL 5e-1#second\r\nonce # not cyclic\r\n",
    ],
)
def test_blanks_comments_and_order_do_not_matter(text: str) -> None:
    assert parse_supports(text, FILE) == SupportSequence.parse("R1 L.5")


def test_a_loop_cut_inside_a_phase_begins_before_the_first_frame() -> None:
    sequence = parse_supports("cyclic\nD .1\nL .4\nD .2\nR .4\nD .05\n", FILE)
    assert sequence.start == -0.05
    assert [phase.support.symbol for phase in sequence.phases] == ["D", "L", "D", "R"]
    assert sequence.phases[0].duration == pytest.approx(0.15)
    assert sequence.support_at(0.0) is Support.DOUBLE
    assert sequence.boundaries[1] == pytest.approx(0.1)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "walk.supports: holds no phase; write one a line, such as R 0.383"),
        ("cyclic\n# R 1\n", "walk.supports: holds no phase; write one a line, such as R 0.383"),
        (
            "R\n",
            "walk.supports:1: 'R' is no support phase; write R, L, D or - and its seconds, "
            "such as R 0.383, or cyclic, or once",
        ),
        (
            "once\nX 1\n",
            "walk.supports:2: 'X 1' is no support phase; write R, L, D or - and its seconds, "
            "such as R 0.383, or cyclic, or once",
        ),
        (
            "R nan\n",
            "walk.supports:1: 'R nan' is no support phase; write R, L, D or - and its seconds, "
            "such as R 0.383, or cyclic, or once",
        ),
        (
            "R 1 L 1\n",
            "walk.supports:1: 'R 1 L 1' is no support phase; write R, L, D or - and its seconds, "
            "such as R 0.383, or cyclic, or once",
        ),
        ("R 0\n", "walk.supports:1: phase R lasts 0 s; it must last longer than zero"),
        ("R -1\n", "walk.supports:1: phase R lasts -1 s; it must last longer than zero"),
        ("R 1\n\nR 2\n", "walk.supports:3: R follows R; merge the two lines into one"),
        ("cyclic\nR 1\nL 1\nL 1\n", "walk.supports:4: L follows L; merge the two lines into one"),
        ("once\nR 1\nonce\n", "walk.supports:3: cyclic or once is said a second time; say it once"),
        ("once\ncyclic\n", "walk.supports:2: cyclic or once is said a second time; say it once"),
    ],
)
def test_what_breaks_the_rules_is_refused_with_its_line(text: str, message: str) -> None:
    with pytest.raises(FileFormatError) as caught:
        parse_supports(text, FILE)
    assert str(caught.value) == message


def test_what_was_read_is_written_as_it_was(tmp_path: Path) -> None:
    path = tmp_path / "walk.supports"
    for text in (WALK, WALK.replace("L 0.383\nD 0.117", "L 0.383\nD 0.1\nR 0.017")):
        path.write_text(text, encoding="utf-8")
        save_supports(load_supports(path), path)
        assert path.read_text(encoding="utf-8") == text


durations = st.integers(1, 5_000_000).map(lambda microseconds: microseconds / 1e6)


@st.composite
def sequences(draw: st.DrawFn) -> SupportSequence:
    symbols: list[str] = []
    for _ in range(draw(st.integers(1, 8))):
        symbols.append(draw(st.sampled_from([s for s in "RLD-" if symbols[-1:] != [s]])))
    cyclic = draw(st.booleans())
    if cyclic and len(symbols) > 1 and symbols[0] == symbols[-1]:
        symbols.pop()
    phases = tuple(SupportPhase(Support.from_symbol(s), draw(durations)) for s in symbols)
    cut = draw(st.integers(0, round(phases[0].duration * 1e6) - 1)) / 1e6
    return SupportSequence(phases, cyclic, -cut if cyclic else 0.0)


@settings(deadline=None, max_examples=300)
@given(sequences())
def test_writing_and_reading_is_the_identity(sequence: SupportSequence) -> None:
    text = supports_text(sequence)
    read = parse_supports(text, FILE)
    assert read.cyclic == sequence.cyclic
    assert [p.support for p in read.phases] == [p.support for p in sequence.phases]
    assert read.boundaries == pytest.approx(sequence.boundaries, abs=2e-6)
    assert supports_text(read) == text


@settings(deadline=None, max_examples=300)
@given(st.text(alphabet="RLD- 0123456789.e#\ncyliconce", max_size=80))
def test_any_text_is_read_or_refused(text: str) -> None:
    with suppress(FileFormatError):
        parse_supports(text, FILE)

from __future__ import annotations

import pytest

from footfall.view.text_width import shortened, text_width, wrapped


def test_letters_have_their_widths() -> None:
    assert text_width("ill", 10.0) < text_width("and", 10.0) < text_width("WMW", 10.0)
    assert text_width("and", 20.0) == 2.0 * text_width("and", 10.0)
    assert text_width("and", 10.0, bold=True) > text_width("and", 10.0)


def test_marks_that_combine_take_no_room_and_ideographs_a_whole_em() -> None:
    assert text_width("e\u0301", 10.0) == text_width("e", 10.0)
    assert text_width("歩", 10.0) == 10.0


@pytest.mark.parametrize("width", [0.0, 30.0, 60.0, 90.0])
def test_what_is_shortened_fits_or_is_nothing_but_an_ellipsis(width: float) -> None:
    told = shortened("walk backward", width, 14.0)
    assert told == "…" or text_width(told, 14.0) <= width
    assert told.endswith("…")
    assert "walk backward".startswith(told[:-1])


def test_what_fits_stays() -> None:
    assert shortened("walk", 100.0, 14.0) == "walk"


def test_lines_are_broken_between_words_and_hold_them_all() -> None:
    text = "one motion after the other, and a_word_that_is_longer_than_any_line"
    lines = wrapped(text, 120.0, 12.0)
    assert " ".join(lines) == text
    assert all(text_width(line, 12.0) <= 120.0 or " " not in line for line in lines)
    assert len(lines) > 2
    assert wrapped("", 120.0, 12.0) == [""]

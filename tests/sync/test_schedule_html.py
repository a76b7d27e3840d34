from __future__ import annotations

import re

import footfall as ff


def walking() -> ff.Character:
    clip, supports = ff.sample("walk")
    hero = ff.Character(clip.skeleton)
    hero.add("<walk>", clip, supports)
    hero.start("<walk>")
    hero.advance(0.1)
    return hero


def test_a_notebook_shows_every_slot_in_the_color_of_its_support() -> None:
    schedule = walking().schedule
    html = schedule._repr_html_()  # pyright: ignore[reportPrivateUsage]
    cells = re.findall(r'<td title="([a-z ]+)"[^>]*background-color:(#\w+)[^>]*>(.)</td>', html)
    symbols = "".join(symbol for _, _, symbol in cells)
    played = "".join(result.symbol for result in schedule.results)
    assert symbols == played * 2
    assert set(cells) == {
        ("right foot", "#e6912a", "R"),
        ("left foot", "#3b8fd0", "L"),
        ("both feet", "#35a47a", "D"),
    }


def test_names_are_escaped() -> None:
    html = walking().schedule._repr_html_()  # pyright: ignore[reportPrivateUsage]
    assert "&lt;walk&gt; (1)" in html
    assert "<walk>" not in html

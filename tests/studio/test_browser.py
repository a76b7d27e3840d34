"""The studio in a real browser: what a user does from loading to opening a saved take again."""

from __future__ import annotations

import statistics
import time
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.studio.browser import overflowing, overlapping, studio_in_browser, until

from footfall.io import load_supports, save_gltf
from footfall.samples import sample
from footfall.scenario.cue_sheet import load_scenario
from footfall.scenario.performance import perform

SIZES = [(1280, 800), (1920, 1080)]


def activity(page: Any, name: str) -> str:
    return page.evaluate(
        "(name) => studio.known.tick?.actions.find((each) => each.name === name)?.activity", name
    )


def look_at(page: Any, view: str) -> None:
    """Change the view, and wait until the page has it."""
    page.click(f"[data-show={view}]")
    page.wait_for_selector(f"body[data-view={view}]", timeout=60_000)


def edge(page: Any, foot: int, band: int, side: int) -> tuple[float, float]:
    """Return where an edge of a band is in the window."""
    x, y = page.evaluate(
        """([foot, band, side]) => {
          const at = studio.editor.layout();
          const area = document.querySelector("#timeline canvas").getBoundingClientRect();
          const lane = at.lanes[foot];
          return [area.left + at.x(studio.known.edit.bands[foot][band][side]),
            area.top + lane.top + lane.opinion + lane.tall / 2];
        }""",
        [foot, band, side],
    )
    return x, y


def resting_edge(page: Any, foot: int, band: int, side: int) -> tuple[float, float]:
    """Return where an edge is once the page has come to rest."""
    seen = [(-1.0, -1.0)]

    def rests() -> bool:
        drawn = page.evaluate(
            """() => {
              const {clientWidth, clientHeight} = document.querySelector("#timeline canvas");
              const {width, height} = studio.editor.layout();
              return width === clientWidth && height === clientHeight;
            }"""
        )
        seen.append(edge(page, foot, band, side))
        return drawn and seen[-1] == seen[-2]

    until(rests, "the page to come to rest")
    return seen[-1]


def test_a_motion_is_started_and_stopped_by_its_number(tmp_path: Path) -> None:
    with studio_in_browser(tmp_path, files=["sample:walk", "sample:run"]) as (studio, page):
        page.keyboard.press("1")
        until(lambda: activity(page, "walk") == "running", "the walk")
        assert page.inner_text(".card .go") == "Stop"
        assert studio.session.stage.begun
        page.keyboard.press(" ")
        until(lambda: page.evaluate("studio.known.state.paused"), "the pause")
        frame = studio.session.stage.performer.frame
        time.sleep(0.2)
        assert studio.session.stage.performer.frame == frame
        page.keyboard.press(" ")
        page.keyboard.press("1")
        until(lambda: activity(page, "walk") in ("fading out", "idle"), "the end of the walk")


@pytest.mark.full
def test_the_whole_story_of_a_user(tmp_path: Path) -> None:
    with studio_in_browser(
        tmp_path, files=["sample:walk", "sample:hop-right", "sample:hop-left"]
    ) as (
        studio,
        page,
    ):
        drag_an_edge_and_save(studio, page, tmp_path)
        see_why_it_waits(page)
        move_the_ground(studio, page)
        put_something_on_the_ground(studio, page)
        record_and_open_again(studio, page, tmp_path)


def drag_an_edge_and_save(studio: Any, page: Any, folder: Path) -> None:
    look_at(page, "supports")
    until(lambda: page.evaluate("Boolean(studio.known.edit)"), "the editor")
    before = page.evaluate("studio.known.edit.bands[0][0][1]")
    x, y = resting_edge(page, 0, 0, 1)
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 60, y, steps=6)
    page.mouse.up()
    until(
        lambda: page.evaluate("studio.known.edit.changed && studio.known.edit.canUndo"), "the edit"
    )
    until(lambda: list(folder.glob(".footfall-studio/*")), "the draft")
    moved = page.evaluate("studio.known.edit.bands[0][0][1]")
    assert moved < before - 0.02
    page.reload()
    until(lambda: page.evaluate("studio.known.edit?.changed"), "unsaved work after a reload")
    assert page.evaluate("studio.known.edit.bands[0][0][1]") == moved
    page.click("[data-do=save]")
    until(lambda: (folder / "walk.supports").exists(), "the annotation")
    until(lambda: not page.evaluate("studio.known.edit.changed"), "the saved state")
    assert not list(folder.glob(".footfall-studio/*"))
    saved = load_supports(folder / "walk.supports")
    assert saved == studio.session.motions.find("walk").motion.supports


def see_why_it_waits(page: Any) -> None:
    look_at(page, "stage")
    page.keyboard.press("2")
    until(lambda: activity(page, "hop-right") == "running", "the hop")
    # Nobody hops on both legs in turn: the other one waits until this one is stopped.
    page.keyboard.press("3")
    until(lambda: activity(page, "hop-left") == "waiting", "the wait")
    reason = page.inner_text("[data-name=hop-left] .reason")
    assert reason.startswith("waiting because impossible beside 'hop-right'")
    page.keyboard.press("2")
    until(lambda: activity(page, "hop-left") == "running", "the end of the wait")
    assert page.inner_text("[data-name=hop-left] .reason") == ""
    page.keyboard.press("3")
    page.keyboard.press("1")
    until(lambda: activity(page, "walk") == "running", "the walk")


def move_the_ground(studio: Any, page: Any) -> None:
    page.evaluate("studio.say('lift', {value: 0.25})")
    until(lambda: studio.session.stage.ground.height == 0.25, "the raised ground")
    stage = studio.session.stage

    def stands() -> bool:
        with studio.session.lock:
            points = stage.performer.foot_points
            return bool(abs((points[..., 1] - stage.performer.heights(points)).min()) < 0.01)

    until(stands, "a foot on the raised ground")


def put_something_on_the_ground(studio: Any, page: Any) -> None:
    page.select_option("#ground-kind", "stairs")
    page.fill("#ahead", "0.1")
    until(lambda: "10 %" in page.inner_text("#ahead-now"), "the tilted ground")
    parts = studio.session.stage.performer.ground.parts
    assert [type(part).__name__ for part in parts] == ["Plane", "Stairs", "Stairs"]
    page.select_option("#ground-kind", "level")
    until(lambda: studio.session.stage.asked.kind == "level", "the ground without stairs")
    page.fill("#ahead", "0")
    until(lambda: studio.session.stage.ground.slope == (0.0, 0.0), "the level ground")


def record_and_open_again(studio: Any, page: Any, folder: Path) -> None:
    page.click("#save summary")
    page.fill("#take", "first try")
    page.click("[data-form=scenario]")
    until(lambda: (folder / "first try.toml").exists(), "the scenario")
    scenario = load_scenario(folder / "first try.toml")
    performance = perform(scenario)
    assert performance.lifts[-1] == 0.25
    before = studio.session.stage.performer
    page.evaluate("studio.say('open', {file: 'first try.toml'})")
    stage = studio.session.stage
    until(lambda: stage.performer is not before and stage.begun, "the opened take")
    until(lambda: not studio.session.script, "the last cue of the replay")
    with studio.session.lock:
        frame = stage.performer.frame
        assert frame < performance.recording.frames
        told = performance.recording.world_positions[frame]
        np.testing.assert_array_equal(stage.performer.positions, told)
    for form in ("bvh", "glb", "picture"):
        page.click("#save summary")
        page.fill("#take", "first try")
        page.click(f"[data-form={form}]")
    for suffix in ("bvh", "glb", "png"):
        until((folder / f"first try.{suffix}").exists, suffix)
    assert (folder / "first try.png").read_bytes()[:4] == b"\x89PNG"


@pytest.mark.full
def test_a_character_in_its_skin_is_chosen_and_let_go(tmp_path: Path) -> None:
    save_gltf(sample("walk")[0], tmp_path / "hero.glb")
    with studio_in_browser(tmp_path, files=["sample:walk"]) as (studio, page):
        for body in ("hero.glb", "child", "hero.glb"):
            page.select_option("#body", body)
            until(lambda name=body: page.evaluate("studio.known.state.body") == name, body)
            page.keyboard.press("1")
            until(lambda: studio.session.stage.begun, "the walk")
            assert (studio.session.skin is None) == (body == "child")
        # The scene has drawn all that: an error of its page would fail this test.
        until(lambda: studio.session.stage.performer.frame > 60, "a second")


@pytest.mark.full
@pytest.mark.parametrize(("width", "height"), SIZES)
def test_nothing_is_cut_and_nothing_overlaps_in_any_view(
    tmp_path: Path, width: int, height: int
) -> None:
    pictures = Path("out") / "studio"
    pictures.mkdir(parents=True, exist_ok=True)
    with studio_in_browser(tmp_path, width=width, height=height) as (_, page):
        page.wait_for_timeout(4000)
        for key in "13":
            page.keyboard.press(key)
            page.wait_for_timeout(2500)
        page.check("#ghost")
        page.keyboard.press("6")
        page.wait_for_timeout(1500)
        page.keyboard.press(" ")
        for view in ("stage", "ground", "card", "menu", "supports", "crowd"):
            if view == "ground":
                page.select_option("#ground-kind", "stairs")
                page.fill("#aside", "0.06")
                page.keyboard.press(" ")
                page.wait_for_timeout(3200)
                page.keyboard.press(" ")
            elif view == "card":
                page.click(".card .more")
            elif view == "menu":
                page.click("#save summary")
            else:
                look_at(page, view)
            if view == "crowd":
                page.click("#pause")
                until(lambda: page.evaluate("Boolean(studio.known.herd)"), "the crowd")
                page.click("[aria-label='run, group B']")
                page.click("[aria-label='side-step, group D']")
                page.wait_for_timeout(6000)
            page.wait_for_timeout(2500)
            page.screenshot(path=pictures / f"{view}-{width}.png")
            assert overflowing(page) == [], view
            if view != "menu":
                assert overlapping(page) == [], view


@pytest.mark.full
def test_arrow_keys_and_sliders_steer_a_gait(tmp_path: Path) -> None:
    names = ["sample:walk-slow", "sample:walk", "sample:kick", "sample:run"]
    with studio_in_browser(tmp_path, files=names) as (studio, page):
        page.click("#open summary")
        page.click("#gait")
        page.wait_for_selector("[data-name=go] [data-steer=speed]")
        # A kick is no walk.
        assert page.inner_text("[data-name=go] .sequence") == "walk-slow, walk, run"
        page.click("[data-name=go] .go")
        until(lambda: activity(page, "go") == "running", "the gait")
        for _ in range(5):
            page.keyboard.press("ArrowUp")
        stage = studio.session.stage
        until(lambda: abs(stage.pair()[0].gait("go")[0] - 1.25) < 1e-6, "five steps of speed")
        page.fill("[data-name=go] [data-steer=speed]", "3")
        page.evaluate("document.activeElement.blur()")
        until(lambda: stage.pair()[0].gait("go")[0] == 3.0, "the speed of the slider")
        until(lambda: page.inner_text("[data-name=go] .steering output") == "3.00 m/s", "its text")
        page.keyboard.press("ArrowDown")
        until(lambda: abs(stage.pair()[0].gait("go")[0] - 2.9) < 1e-6, "a step less")
        cues = [cue.parameter for cue in stage.take.scenario.cues if cue.kind == "speed"]
        assert cues == pytest.approx([0.85, 0.95, 1.05, 1.15, 1.25, 3.0, 2.9])


DRAG = """async ([x, y]) => {
  const canvas = document.querySelector("#timeline canvas");
  const times = [];
  let heard = () => {};
  studio.on("edit", () => heard());
  for (let i = 0; i < 400; i++) {
    const start = performance.now();
    const answer = new Promise((resolve) => { heard = resolve; });
    const clientX = x - 30 - 25 * Math.sin(i / 3);
    canvas.dispatchEvent(new PointerEvent("pointermove", {clientX, clientY: y, bubbles: true}));
    await answer;
    times.push(performance.now() - start);
  }
  return times;
}"""
"""Moves the pointer 400 times; each time until the page has heard of the moved band [ms]."""


@pytest.mark.full
def test_a_drag_reaches_the_engine_within_fifty_milliseconds(tmp_path: Path) -> None:
    with studio_in_browser(tmp_path, files=["sample:walk"]) as (studio, page):
        look_at(page, "supports")
        until(lambda: page.evaluate("Boolean(studio.known.edit)"), "the editor")
        before = studio.session.editor.bands.feet[0][0].end
        x, y = resting_edge(page, 0, 0, 1)
        page.mouse.move(x, y)
        page.mouse.down()
        # The best of three rounds: what else the machine does is not the studio's.
        rounds = [sorted(page.evaluate(DRAG, [x, y])) for _ in range(3)]
        page.mouse.up()
        assert studio.session.editor.bands.feet[0][0].end != before
        times = min(rounds, key=lambda times: times[395])
        assert len(times) == 400
        print(
            f"400 drags: median {statistics.median(times):.1f} ms, p99 {times[395]:.1f} ms, "
            f"most {times[-1]:.1f} ms"
        )
        assert times[395] < 50.0

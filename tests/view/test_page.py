from __future__ import annotations

import base64
import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest
from tests import walking_figure
from tests.view import walking_pictures

from footfall.errors import ArgumentError, FileFormatError
from footfall.report import measure
from footfall.view import DemoPage, write_demo_page


def page(frames: int = 100) -> DemoPage:
    takes = walking_pictures.takes(frames)
    return DemoPage(
        title="Feet that <hold>",
        introduction="The same cues twice.",
        takes=takes,
        skeleton=walking_figure.skeleton(),
        timeline=walking_pictures.timeline(frames),
        reports={"cross-fade": measure(takes[0][1]), "footfall": measure(takes[1][1])},
    )


@pytest.fixture(scope="module")
def text(tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("page") / "index.html"
    write_demo_page(path, page())
    return path.read_text(encoding="utf-8")


def embedded(text: str) -> dict[str, Any]:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', text, re.S)
    assert found is not None
    return json.loads(found[1])


def unpacked(packed: str, kind: str) -> npt.NDArray[Any]:
    return np.frombuffer(base64.b64decode(packed), kind)


def test_it_needs_no_network(text: str) -> None:
    addresses = set(re.findall(r'https?://[^\s"\'<>)]+', text))
    assert addresses == {"http://www.w3.org/2000/svg"}
    assert not re.search(r"<script[^>]*\ssrc=|<link[^>]*stylesheet|@import|\bimport\b\s", text)


def test_what_was_given_is_escaped(text: str) -> None:
    assert "<h1>Feet that &lt;hold&gt;</h1>" in text
    assert "<hold>" not in text


def test_joints_are_embedded_to_a_tenth_of_a_millimeter(text: str) -> None:
    data = embedded(text)
    trace = walking_pictures.trace(0.0)
    take = data["takes"][1]
    shape = (take["frames"], take["joints"], 3)
    roots = unpacked(take["roots"], "<f4").reshape(-1, 1, 3)
    places = roots + unpacked(take["places"], "<i2").reshape(shape) * data["mesh"]["unit"]
    distances = np.linalg.norm(trace.positions[:, :, np.newaxis] - places[:, np.newaxis], axis=-1)
    assert distances.min(axis=1).max() < 1e-4


def test_every_triangle_moves_with_an_embedded_joint(text: str) -> None:
    data = embedded(text)
    joints = unpacked(data["mesh"]["joints"], "<u1")
    assert joints.max() == data["takes"][0]["joints"] - 1
    assert unpacked(data["mesh"]["triangles"], "<u2").max() == len(joints) - 1
    assert len(unpacked(data["mesh"]["positions"], "<i2")) == 3 * len(joints)


def test_feet_that_hold_have_slid_nowhere(text: str) -> None:
    slid = [unpacked(take["slid"], "<u2").max() / 1e4 for take in embedded(text)["takes"]]
    assert slid[0] > 0.03
    assert slid[1] < 0.001


def test_every_take_tells_what_it_stands_on_itself(text: str) -> None:
    takes = embedded(text)["takes"]
    assert [take["supports"] for take in takes] == [walking_figure.supports(100)] * 2


def test_the_table_has_a_row_a_method_ours_marked(text: str) -> None:
    rows = re.findall(r"<tr(?: class=\"own\")?><th>(.*?)</th>(.*?)</tr>", text)
    assert [name for name, _ in rows] == ["Plain cross-fade", "footfall"]
    assert [cells.count("<td>") for _, cells in rows] == [14, 14]
    assert text.count('<tr class="own"><th>footfall</th>') == 1


def test_twelve_seconds_of_two_takes_stay_small(tmp_path: Path) -> None:
    write_demo_page(tmp_path / "index.html", page(720))
    assert (tmp_path / "index.html").stat().st_size < 2_000_000


def test_the_same_page_has_the_same_bytes(text: str, tmp_path: Path) -> None:
    write_demo_page(tmp_path / "index.html", page())
    assert (tmp_path / "index.html").read_text(encoding="utf-8") == text


def test_a_page_needs_takes() -> None:
    with pytest.raises(ArgumentError) as caught:
        DemoPage("", "", (), walking_figure.skeleton(), walking_pictures.timeline(), {})
    assert str(caught.value) == "a page without takes; give at least one title and motion"


def test_nothing_is_written_into_a_missing_folder(tmp_path: Path) -> None:
    with pytest.raises(FileFormatError, match="there is no folder"):
        write_demo_page(tmp_path / "missing" / "index.html", page())


@pytest.mark.full
def test_it_plays_in_a_browser(tmp_path: Path) -> None:
    browser = shutil.which("chromium") or shutil.which("google-chrome")
    if browser is None:
        pytest.skip("no chromium on this machine")
    write_demo_page(tmp_path / "index.html", page())
    command = [
        browser,
        "--headless=new",
        "--no-sandbox",
        "--use-angle=swiftshader",
        "--enable-unsafe-swiftshader",
        "--virtual-time-budget=4000",
        "--dump-dom",
        f"{(tmp_path / 'index.html').as_uri()}?t=1.25",
    ]
    shown = subprocess.run(command, capture_output=True, text=True, timeout=120, check=True).stdout
    shown = shown.split("<script")[0]
    assert re.search(r'<output id="clock">1\.25 s</output>', shown)
    assert 'class="broken"' not in shown
    assert re.search(r'<canvas [^>]*width="\d+"', shown)
    assert re.search(r"planted feet have slid <b>[1-9]\d* cm</b>", shown)
    assert "planted feet have slid <b>0 cm</b>" in shown

from __future__ import annotations

import hashlib
import re
import sys
import threading
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
from tests.io.small_biped import BIPED

from footfall.datasets import PublicClip, fetch_clip, find_clip, public_clips
from footfall.datasets.public_clips import FREE
from footfall.errors import FileFormatError, MissingExtraError, UnknownNameError
from footfall.io import load
from footfall.io.motion_formats import READERS

CLIPS = public_clips()


class Quiet(SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: object) -> None:  # noqa: A002
        pass


@pytest.fixture
def server(tmp_path: Path) -> Iterator[str]:
    pytest.importorskip("pooch")
    (tmp_path / "served").mkdir()
    (tmp_path / "served" / "walk.bvh").write_text(BIPED)
    handler = partial(Quiet, directory=str(tmp_path / "served"))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as running:
        threading.Thread(target=running.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{running.server_port}"
        running.shutdown()


def clip(url: str) -> PublicClip:
    digest = hashlib.sha256(BIPED.encode()).hexdigest()
    return PublicClip("walk", "walk.bvh", f"{url}/walk.bvh", digest, len(BIPED), 0.1, "MIT", "us")


@pytest.mark.parametrize("entry", CLIPS, ids=lambda entry: entry.name)
def test_every_entry_is_pinned_free_and_readable(entry: PublicClip) -> None:
    assert re.fullmatch(
        r"https://raw\.githubusercontent\.com/[\w.-]+/[\w.-]+/[0-9a-f]{40}/.+", entry.url
    )
    assert re.fullmatch(r"[0-9a-f]{64}", entry.sha256)
    assert entry.license in FREE
    assert entry.file.endswith(tuple(READERS))
    assert entry.bytes > 0
    assert entry.seconds > 0.0


def test_no_two_entries_share_a_name_or_a_file() -> None:
    assert (
        len({entry.name for entry in CLIPS}) == len({entry.file for entry in CLIPS}) == len(CLIPS)
    )


def test_a_clip_is_fetched_once_and_read(server: str, tmp_path: Path) -> None:
    path = fetch_clip(clip(server), tmp_path / "cache")
    assert path == tmp_path / "cache" / "walk.bvh"
    assert load(path).frames == 2
    (tmp_path / "served" / "walk.bvh").unlink()
    assert fetch_clip(clip(server), tmp_path / "cache") == path


def test_a_damaged_file_in_the_cache_is_fetched_anew(server: str, tmp_path: Path) -> None:
    path = fetch_clip(clip(server), tmp_path / "cache")
    path.write_text("damaged")
    assert fetch_clip(clip(server), tmp_path / "cache").read_text() == BIPED


def test_what_has_another_digest_is_refused_and_not_kept(server: str, tmp_path: Path) -> None:
    changed = replace(clip(server), sha256="0" * 64)
    with pytest.raises(FileFormatError, match="must hold: its digest is another"):
        fetch_clip(changed, tmp_path / "cache")
    assert list((tmp_path / "cache").iterdir()) == []


def test_what_is_not_there_is_told_in_one_line(server: str, tmp_path: Path) -> None:
    with pytest.raises(FileFormatError) as caught:
        fetch_clip(replace(clip(server), url=f"{server}/none.bvh"), tmp_path / "cache")
    assert f"cannot be fetched from {server}/none.bvh: HTTP Error 404" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_a_server_that_is_not_there_is_told(tmp_path: Path) -> None:
    pytest.importorskip("pooch")
    with pytest.raises(FileFormatError, match=r"cannot be fetched from http://127\.0\.0\.1:9/"):
        fetch_clip(clip("http://127.0.0.1:9"), tmp_path / "cache")


def test_an_unknown_name_is_answered_with_those_there_are() -> None:
    with pytest.raises(UnknownNameError, match="no public clip named 'moonwalk'; there are: "):
        find_clip("moonwalk", CLIPS)
    assert find_clip(CLIPS[0].name, CLIPS) is CLIPS[0]


def test_without_the_library_the_way_to_get_it_is_told(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setitem(sys.modules, "pooch", None)
    with pytest.raises(MissingExtraError) as caught:
        fetch_clip(CLIPS[0], tmp_path)
    assert str(caught.value) == (
        f"fetching {CLIPS[0].name} needs pooch; pip install 'footfall[samples]'"
    )

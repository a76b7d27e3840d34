from __future__ import annotations

import re
import tomllib
from pathlib import Path

import pytest

import footfall
from footfall.errors import MissingExtraError
from footfall.extras import extra_module


def test_a_library_that_is_there_is_imported() -> None:
    assert extra_module("json.decoder", "this", extra="none").JSONDecoder is not None


def test_a_library_that_is_missing_is_named_with_the_way_to_get_it() -> None:
    with pytest.raises(MissingExtraError) as caught:
        extra_module("footfall_missing.part", "reading x.fbx", extra="fbx", library="ufbx")
    assert str(caught.value) == "reading x.fbx needs ufbx; pip install 'footfall[fbx]'"
    assert caught.value.extra == "fbx"


ROOT = Path(footfall.__file__).parent
PROJECT = Path(__file__).parents[1] / "pyproject.toml"
EXTRAS = set(tomllib.loads(PROJECT.read_text("utf-8"))["project"]["optional-dependencies"])


@pytest.mark.parametrize("extra", ["studio", "fbx", "usd", "robot", "dask", "figures"])
def test_the_package_has_the_extras_that_it_was_asked_for(extra: str) -> None:
    assert extra in EXTRAS


def test_every_hint_names_an_extra_that_there_is() -> None:
    named: set[str] = set()
    for path in ROOT.rglob("*.py"):
        text = path.read_text(encoding="utf-8")
        named |= set(re.findall(r'extra="(\w+)"', text)) | set(
            re.findall(r"footfall\[(\w+)\]", text)
        )
    assert len(named) >= 6
    assert named <= EXTRAS

from __future__ import annotations

import pytest

from footfall.errors import MissingExtraError
from footfall.extras import extra_module


def test_a_library_that_is_there_is_imported() -> None:
    assert extra_module("json.decoder", "this", extra="none").JSONDecoder is not None


def test_a_library_that_is_missing_is_named_with_the_way_to_get_it() -> None:
    with pytest.raises(MissingExtraError) as caught:
        extra_module("footfall_missing.part", "reading x.fbx", extra="fbx", library="ufbx")
    assert str(caught.value) == "reading x.fbx needs ufbx; pip install 'footfall[fbx]'"
    assert caught.value.extra == "fbx"

from __future__ import annotations

import math

import pytest

from footfall.adaptation import Plane
from footfall.errors import ArgumentError


def test_a_plane_lies_where_it_is_put() -> None:
    assert Plane().height == 0.0
    assert Plane(0.4).height == 0.4


@pytest.mark.parametrize("height", [math.nan, math.inf, -math.inf])
def test_a_plane_lies_somewhere(height: float) -> None:
    with pytest.raises(ArgumentError) as caught:
        Plane(height)
    assert str(caught.value) == f"ground at height {height}; it must be a finite number [m]"

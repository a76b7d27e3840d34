from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from tests.report.bodies import resting_feet, trace_of

from footfall.errors import ArgumentError

NAN = float("nan")


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"fps": 0.0}, "a trace has 0.0 frames per second; it must be > 0"),
        ({"fps": NAN}, "a trace has nan frames per second; it must be > 0"),
        (
            {"shares": np.ones(3)},
            "the shares of a trace have shape (3,), not (3, 3)",
        ),
        (
            {"shares": np.ones((4, 2))},
            "the shares of a trace have shape (4, 2), not (3, 2)",
        ),
        (
            {"moving": np.ones(2, dtype=np.bool_)},
            "the moving flags of a trace have shape (2,), not (3,)",
        ),
        (
            {"rates": np.array([1.0, NAN, 1.0])},
            "the rates of a trace are not finite, first in row 1",
        ),
        ({"ground": NAN}, "the ground heights of a trace are not finite, first in row 0"),
        (
            {"ground": np.zeros(3)},
            "the ground heights of a trace have shape (3,), not () or (3, 2, 2)",
        ),
        (
            {"surface_displacement": np.zeros((3, 2))},
            "the surface displacements of a trace have shape (3, 2), not (3, 3) or (3, 2, 2, 3)",
        ),
        (
            {"resting_levels": np.zeros(2)},
            "the resting levels of a trace have shape (2,), not (2, 2)",
        ),
    ],
)
def test_a_trace_that_cannot_be_measured_says_why(options: dict[str, Any], message: str) -> None:
    with pytest.raises(ArgumentError) as caught:
        trace_of(resting_feet(3), "LLL", **options)
    assert str(caught.value) == message


def test_a_trace_needs_a_frame() -> None:
    with pytest.raises(ArgumentError) as caught:
        trace_of(resting_feet(0), "")
    assert str(caught.value) == "a trace has no frames; at least one is needed"


def test_a_trace_needs_a_support_for_each_frame() -> None:
    with pytest.raises(ArgumentError) as caught:
        trace_of(resting_feet(3), "LL")
    assert str(caught.value) == "the supports of a trace have shape (2,), not (3,)"

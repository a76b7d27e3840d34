from __future__ import annotations

import numpy as np
import pytest
from tests.report.bodies import supports

from footfall.arrays import Flags
from footfall.report import Mismatch, carrying, support_mismatch
from footfall.support import Support


def still(frames: int) -> Flags:
    return np.zeros(frames, dtype=np.bool_)


def test_feet_that_do_what_was_commanded_do_not_mismatch() -> None:
    commanded = supports("LLLLLDDDDDRRRRR-----")
    assert support_mismatch(commanded, carrying(commanded), still(20)) == Mismatch(0.0, None)


def test_a_frame_counts_once_however_many_feet_are_wrong() -> None:
    commanded = supports("LLLLLLLLLL")
    contacts = carrying(commanded)
    contacts[4] = [False, False]
    contacts[5] = [False, True]
    assert support_mismatch(commanded, contacts, still(10)) == Mismatch(0.2, None)


@pytest.mark.parametrize(
    ("shift", "wrong"), [(-3, 1), (-2, 0), (-1, 0), (0, 0), (1, 0), (2, 0), (3, 1)]
)
def test_a_boundary_found_up_to_two_frames_off_is_right(shift: int, wrong: int) -> None:
    commanded = supports("LLLLLLLLRRRRRRRR")
    contacts = np.zeros((16, 2), dtype=np.bool_)
    contacts[: 8 + shift, 0] = True
    contacts[8 + shift :, 1] = True
    found = support_mismatch(commanded, contacts, still(16))
    assert found.overall == pytest.approx(wrong / 12)


def test_frames_in_which_weights_move_are_also_judged_apart() -> None:
    commanded = supports("LLLLLLLLLL")
    contacts = carrying(commanded)
    contacts[:2] = False
    moving = still(10)
    moving[:4] = True
    assert support_mismatch(commanded, contacts, moving) == Mismatch(0.2, 0.5)


def test_a_conflict_commands_nothing_and_is_not_judged() -> None:
    commanded = np.full(5, int(Support.CONFLICT))
    contacts = np.ones((5, 2), dtype=np.bool_)
    assert support_mismatch(commanded, contacts, still(5)) == Mismatch(None, None)

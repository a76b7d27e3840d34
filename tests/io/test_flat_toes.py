from __future__ import annotations

import numpy as np
import pytest
from tests import walking_figure

from footfall.geometry import from_axis_angle, multiply
from footfall.io.flat_toes import flat_toe_turns
from footfall.io.mannequin import mannequin
from footfall.skeleton import find_anatomy


@pytest.mark.parametrize("angle", [0.0, 0.9, -1.6])
def test_toes_lie_flat_however_a_rig_turns_their_frames(angle: float) -> None:
    clip = walking_figure.walk()
    turn = from_axis_angle(np.array([1.0, 0.0, 0.0]), angle)
    local = clip.local_rotations.copy()
    for toe in (4, 8):
        local[:, toe] = multiply(local[:, toe], turn)
    turned = clip.evolve(local_rotations=local)
    anatomy = find_anatomy(turned.skeleton)
    turns = flat_toe_turns(anatomy, *turned.world_poses())
    np.testing.assert_allclose(np.abs(turns @ turn), 1.0, atol=1e-9)
    plain, fitted = (
        mannequin(turned.skeleton, anatomy, each) for each in (None, np.stack([turn, turn]))
    )
    toes = np.isin(plain.joints, (4, 8))
    back = multiply(
        turn[np.newaxis],
        np.concatenate([np.zeros((int(toes.sum()), 1)), fitted.positions[toes]], axis=1),
    )
    there = multiply(back, turn * np.array([1.0, -1.0, -1.0, -1.0]))
    np.testing.assert_allclose(there[:, 1:], plain.positions[toes], atol=1e-12)

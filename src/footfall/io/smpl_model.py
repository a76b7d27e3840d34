"""Where the joints of a person stand, from the user's own file of a body model."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.arrays import Floats, Positions
from footfall.errors import FileFormatError
from footfall.io.numpy_archive import read_archive
from footfall.io.smpl_bodies import SMPL_PARENTS

__all__ = ["model_joints"]

_ARRAYS = ("J_regressor", "v_template", "shapedirs", "kintree_table")


def model_joints(path: Path, model: str, shape: Floats) -> Positions:
    """Return where the joints of a body model stand at rest [m].

    The joints are weighted sums of the vertices of the person's own shape (Loper et al. 2015,
    "SMPL", equation 10).

    Args:
        path: The model's ``.npz`` file, as its makers give it out.
        model: Which model the motion is for, a key of `SMPL_TREES`.
        shape: The person's shape coefficients, shape (coefficients,).

    Returns:
        Shape (joints, 3), in the model's own frame; the joints of the motion come first in it.

    Raises:
        FileFormatError: If the file is no such model, or of another one.
    """
    if path.suffix.lower() == ".pkl":
        raise FileFormatError(
            "is a pickle, which could run any program; fetch the model as .npz", path=path
        )
    arrays = read_archive(path, _ARRAYS)
    for name in _ARRAYS:
        if name not in arrays or arrays[name].dtype.kind not in "fiu":
            raise FileFormatError(f"is no body model: it has no numbers {name!r}", path=path)
    regressor, template, directions, tree = (arrays[name] for name in _ARRAYS)
    _check_shapes(regressor, template, directions, tree, path)
    parents = SMPL_PARENTS[model]
    found = tree[0].astype(np.int64)
    # The root's parent is written as the greatest number of its kind, or as -1.
    if len(found) < len(parents) or found[1 : len(parents)].tolist() != parents[1:].tolist():
        raise FileFormatError(f"is no model of the {model} joints that the motion has", path=path)
    count = min(len(shape), directions.shape[2])
    vertices = template + directions[:, :, :count].astype(np.float64) @ shape[:count]
    joints: Positions = regressor[: len(parents)].astype(np.float64) @ vertices
    if not (np.abs(joints) < 1e6).all():
        raise FileFormatError("holds numbers that are not finite", path=path)
    return joints


def _check_shapes(
    regressor: npt.NDArray[Any],
    template: npt.NDArray[Any],
    directions: npt.NDArray[Any],
    tree: npt.NDArray[Any],
    path: Path,
) -> None:
    vertices = template.shape[0] if template.ndim == 2 else 0
    fits = (
        template.shape == (vertices, 3)
        and directions.ndim == 3
        and directions.shape[:2] == (vertices, 3)
        and regressor.ndim == 2
        and regressor.shape[1] == vertices
        and tree.shape == (2, regressor.shape[0])
    )
    if not fits:
        raise FileFormatError(
            f"its arrays do not fit together: v_template {template.shape}, shapedirs "
            f"{directions.shape}, J_regressor {regressor.shape}, kintree_table {tree.shape}",
            path=path,
        )

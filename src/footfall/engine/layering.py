"""What a crowd lays over what plays: the commands for its layers, and their weights."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from footfall.arrays import Flags, Floats
from footfall.engine.commanding import Commanding
from footfall.engine.layer_record import LAYERS, LEAVES, LIES, NOTHING
from footfall.engine.rows import Rows, check_present
from footfall.errors import ArgumentError

__all__ = ["Layering"]

Seats = npt.NDArray[Any]
"""Records of `LayerSeat`."""


class Layering(Commanding):
    """The part of a crowd that lays motions over others."""

    def start_layer(self, layer: int, rows: Rows = None, *, weight: float = 1.0) -> None:
        """Lay a layer over whatever plays, at once; nothing waits for it and no foot moves by it.

        One that lies already goes to the new weight, and goes on. One that fades out comes back;
        but what is played once begins anew, beside what is left of it.

        Args:
            layer: Its id in the library.
            rows: Which characters: row numbers, a mask, or None for all.
            weight: How much of it, 0 to 1.

        Raises:
            ArgumentError: If the layer or a row does not exist, the weight is out of range, or a
                character has as many layers on as it can; then nobody gets it.
        """
        layer = self._check_layer(layer)
        if not 0.0 <= weight <= 1.0:
            raise ArgumentError(f"a layer with a weight of {weight}; it must be within 0..1")
        chosen = check_present(rows, self._characters)
        seats = self._characters["layers"][chosen]
        mine = (seats["layer"] == layer) & (seats["status"] != NOTHING)
        goes_on: Flags = mine & ((seats["status"] == LIES) | self.library.layers[layer].lasts)
        found: Flags = np.any(goes_on, axis=1)
        fitting: Flags = goes_on | (~found[:, np.newaxis] & (seats["status"] == NOTHING))
        full = ~fitting.any(axis=1)
        if full.any():
            raise ArgumentError(
                f"character {chosen[full][0]} already has {LAYERS} layers on; stop one first"
            )
        at = (np.arange(len(chosen)), fitting.argmax(axis=1))
        seats["layer"][at], seats["status"][at] = layer, LIES
        seats["time"][at] = np.where(found, seats["time"][at], 0.0)
        seats["before"][at] = np.where(found, _weights(seats[at]), 0.0)
        seats["goal"][at], seats["progress"][at] = weight, 0.0
        self._characters["layers"][chosen] = seats
        self._characters["layered"][chosen] = True

    def stop_layer(self, layer: int, rows: Rows = None) -> None:
        """Let a layer fade out.

        Args:
            layer: Its id in the library.
            rows: Which characters: row numbers, a mask, or None for all.

        Raises:
            ArgumentError: If the layer or a row does not exist.
        """
        layer = self._check_layer(layer)
        chosen = check_present(rows, self._characters)
        seats = self._characters["layers"][chosen]
        at = (seats["layer"] == layer) & (seats["status"] == LIES)
        seats["before"][at] = _weights(seats[at])
        seats["goal"][at], seats["progress"][at], seats["status"][at] = 0.0, 0.0, LEAVES
        self._characters["layers"][chosen] = seats

    def layer_weights(self, layer: int) -> Floats:
        """Return how much of a layer lies over each row by now, shape (rows,).

        Raises:
            ArgumentError: If the layer does not exist.
        """
        layer = self._check_layer(layer)
        seats = self._characters["layers"]
        mine = (seats["layer"] == layer) & (seats["status"] != NOTHING)
        total: Floats = np.where(mine, _weights(seats), 0.0).sum(axis=1)
        return total

    def _check_layer(self, layer: int) -> int:
        count = len(self.library.layers)
        if not 0 <= layer < count:
            there = f"0..{count - 1}" if count else "none; add_layer makes one"
            raise ArgumentError(f"layer {layer}; the library has {there}")
        self._refresh()
        return layer


def _weights(seats: Seats) -> Floats:
    """Return what the fades of some seats have come to, in the shape of the seats."""
    progress = seats["progress"].astype(np.float64)
    share = progress * progress * (3.0 - 2.0 * progress)
    weights: Floats = (1.0 - share) * seats["before"] + share * seats["goal"]
    return weights

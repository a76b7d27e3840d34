"""The motions of a cue sheet's layers, brought to the character that lays them."""

from __future__ import annotations

from footfall.engine import Character
from footfall.errors import FootfallError, ScenarioError
from footfall.motion import Clip
from footfall.scenario.cue_sheet import Scenario
from footfall.scenario.entries import ActionEntry
from footfall.scenario.motions import edited_motion

__all__ = ["add_layers"]


def add_layers(character: Character, scenario: Scenario) -> None:
    """Let a character know the layers of a cue sheet, after its actions.

    Raises:
        ScenarioError: If a motion cannot be read or edited as asked, or not be laid on this body.
    """
    for layer in scenario.layers:
        entry = ActionEntry(
            layer.name, layer.motion, cyclic=layer.cyclic, mirror=layer.mirror, crop=layer.crop
        )
        reference: Clip | None = None
        try:
            if layer.reference is not None:
                pose = ActionEntry(layer.name, layer.reference, mirror=layer.mirror)
                reference = edited_motion(pose, scenario).clip
            character.add_layer(
                layer.name,
                edited_motion(entry, scenario).clip,
                parts=layer.parts,
                reference=reference,
                fade_in=layer.fade_in,
                fade_out=layer.fade_out,
            )
        except FootfallError as error:
            raise ScenarioError(f"layer {layer.name!r}: {error}") from error

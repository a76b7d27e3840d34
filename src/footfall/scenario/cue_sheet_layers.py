"""The layers of a cue sheet, and the cues that lay them."""

from __future__ import annotations

from footfall.engine.layer import UPPER_BODY, parse_parts
from footfall.errors import FootfallError, ScenarioError
from footfall.scenario.cue_sheet_fields import Fields
from footfall.scenario.entries import Cue, LayerEntry

__all__ = ["layer_cues", "read_layers"]


def read_layers(fields: Fields) -> tuple[LayerEntry, ...]:
    """Return the layers of a whole file; none where it has none.

    Raises:
        ScenarioError: If a key is unknown or not what it must be.
    """
    if not fields.has("layer"):
        return ()
    return tuple(_layer(entry) for entry in fields.tables("layer"))


def layer_cues(fields: Fields, at: float, names: list[str]) -> list[Cue]:
    """Return what a cue asks of layers: a weight for each that it names.

    Args:
        fields: The cue.
        at: When it comes [s].
        names: The layers that there are.

    Raises:
        ScenarioError: If there is no such layer, or a weight is out of range.
    """
    weights = fields.table("layer")
    return [
        Cue(
            at,
            "layer",
            weights.one_of(name, names),
            parameter=weights.number(name, least=0.0, most=1.0, default=None),
        )
        for name in weights.names
    ]


def _layer(fields: Fields) -> LayerEntry:
    fields.know(*LayerEntry.__slots__)
    where = 'a file beside the scenario or "sample:walk"'
    parts = tuple(fields.texts("parts", "a body part")) if fields.has("parts") else UPPER_BODY
    try:
        parse_parts("it", parts)
    except FootfallError as error:
        raise ScenarioError(f"{fields.label('parts')}: {error}") from error
    return LayerEntry(
        name=fields.needed_text("name", 'a name for cues, such as "wave"'),
        motion=fields.needed_text("motion", where),
        parts=parts,
        reference=fields.text("reference", None),
        fade_in=fields.number("fade_in", least=0.0, most=60.0, default=0.3),
        fade_out=fields.number("fade_out", least=0.0, most=60.0, default=0.3),
        cyclic=fields.flag("cyclic", None),
        mirror=bool(fields.flag("mirror", False)),
        crop=fields.stretch("crop"),
    )

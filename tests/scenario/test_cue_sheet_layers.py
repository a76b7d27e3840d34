"""A cue sheet whose cues lay motions over others."""

from __future__ import annotations

import numpy as np
import pytest

from footfall.errors import ScenarioError
from footfall.scenario.cue_sheet import parse_scenario
from footfall.scenario.entries import Cue, LayerEntry
from footfall.scenario.performance import perform

BARE = """
duration = 2.0
[[action]]
name = "walk"
motion = "sample:walk"
[[cue]]
at = 0.0
start = "walk"
"""
LAYER = """
[[layer]]
name = "blow"
motion = "sample:punch"
parts = ["arms"]
reference = "sample:idle"
fade_in = 0.2
fade_out = 0.1
cyclic = false
mirror = true
crop = [0.2, 1.8]
"""
CUES = """
[[cue]]
at = 0.5
layer = { blow = 0.8 }
[[cue]]
at = 1.2
layer = { blow = 0 }
"""


def test_layers_and_their_cues_are_read() -> None:
    read = parse_scenario(BARE + LAYER + CUES)
    assert read.layers == (
        LayerEntry(
            "blow", "sample:punch", ("arms",), "sample:idle", 0.2, 0.1, False, True, (0.2, 1.8)
        ),
    )
    assert read.cues[1:] == (
        Cue(0.5, "layer", "blow", parameter=0.8),
        Cue(1.2, "layer", "blow", parameter=0.0),
    )
    assert parse_scenario(BARE).layers == ()


def test_a_layer_lies_from_its_cue_on_until_it_is_let_go() -> None:
    bare, laid = (perform(parse_scenario(text)).recording for text in (BARE, BARE + LAYER + CUES))
    names = bare.skeleton.names
    hand, foot = names.index("LeftHand"), names.index("LeftFoot")
    apart = np.linalg.norm(bare.world_positions - laid.world_positions, axis=-1)
    assert apart[:30, hand].max() == 0.0
    assert apart[40:70, hand].min() > 0.02
    assert apart[80:, hand].max() == 0.0
    assert apart[:, foot].max() == 0.0


BAD = {
    "name = 'walk'\nmotion = 'a.bvh'\n": (
        "layer[1].name is 'walk', as is that of action[0]; names must differ"
    ),
    "name = 'x'\n": 'layer[1].motion is missing; give a file beside the scenario or "sample:walk"',
    "name = 'x'\nmotion = 'a'\nparts = ['legs']\n": (
        "layer[1].parts: it is to turn the legs; a layer moves no foot: its parts are some of "
        "trunk, head, arms, left_arm and right_arm"
    ),
    "name = 'x'\nmotion = 'a'\npriority = 1\n": (
        "no key named 'priority' in layer[1]; there are: name, motion, parts, reference, fade_in, "
        "fade_out, cyclic, mirror, crop"
    ),
    "name = 'x'\nmotion = 'a'\n[[cue]]\nat = 1\nlayer = { walk = 1 }\n": (
        "cue[1].layer names 'walk'; there are: blow, x"
    ),
    "name = 'x'\nmotion = 'a'\n[[cue]]\nat = 1\nlayer = { x = 2 }\n": (
        "cue[1].layer.x is 2; it must be a number, 0 to 1"
    ),
}


@pytest.mark.parametrize("text", BAD)
def test_a_bad_layer_is_told(text: str) -> None:
    with pytest.raises(ScenarioError) as raised:
        parse_scenario(BARE + LAYER + "[[layer]]\n" + text, "a.toml")
    assert str(raised.value) == f"a.toml: {BAD[text]}"


def test_a_motion_that_is_not_there_is_told_with_the_file_and_the_layer() -> None:
    text = BARE + LAYER.replace("sample:punch", "sample:pinch")
    with pytest.raises(ScenarioError) as raised:
        perform(parse_scenario(text, "a.toml"))
    assert str(raised.value).startswith("a.toml: layer 'blow': no sample named 'pinch'; there are:")

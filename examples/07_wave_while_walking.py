"""A wave laid over a walk: a layer, which no foot and no schedule notices.

The picture shows the walk from its right side, without the wave and with it.
"""

import sys
from pathlib import Path

import numpy as np

import footfall as ff
from footfall.engine import Recorder
from footfall.geometry import multiply
from footfall.report import Trace
from footfall.skeleton import find_anatomy
from footfall.view import strip_svg


def waving(pose: ff.Clip) -> ff.Clip:
    """Return a wave of 0.8 s, again and again: the right arm up, its forearm to and fro."""
    time = np.linspace(0.0, 2.0 * np.pi, 49)
    rotations = np.repeat(pose.local_rotations[:1], len(time), axis=0)
    for joint, axis, angles in (
        ("RightArm", 3, 1.9 + 0.0 * time),
        ("RightForeArm", 3, 0.7 + 0.5 * np.sin(time)),
    ):
        turn = np.zeros((len(time), 4))
        turn[:, 0], turn[:, axis] = np.cos(angles / 2), -np.sin(angles / 2)
        index = pose.skeleton.names.index(joint)
        rotations[:, index] = multiply(turn, rotations[:, index])
    rotations[-1] = rotations[0]
    pelvis = np.repeat(pose.pelvis_positions[:1], len(time), axis=0)
    return ff.Clip(pose.skeleton, pelvis, rotations, 60.0, cyclic=True)


def main(folder: Path) -> None:
    """Walk twice, and write the picture."""
    pose, _ = ff.sample("idle")
    traces: list[tuple[str, Trace]] = []
    for title in ("a walk", "a walk and a wave"):
        hero = ff.Character(pose.skeleton)
        hero.add("walk", *ff.sample("walk"))
        hero.add_layer("wave", waving(pose), parts=["right_arm"], reference=pose, fade_in=0.6)
        hero.start("walk")
        recorder = Recorder(hero, 60)
        for frame in range(300):
            if title.endswith("wave") and frame in (60, 220):
                (hero.start_layer if frame == 60 else hero.stop_layer)("wave")
            hero.advance(1 / 60)
            recorder.keep()
        shown = recorder.finish()
        motion = shown.world_positions, shown.world_rotations
        traces.append((title, Trace(*motion, find_anatomy(pose.skeleton), 60, shown.supports)))
    picture = strip_svg(traces, pose.skeleton.parents)
    (folder / "07_wave_while_walking.svg").write_text(picture, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))

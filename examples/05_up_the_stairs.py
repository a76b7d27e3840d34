"""A walk over the level and up some stairs, its feet on every step.

The picture shows it from its right side, with the steps under it.
"""

import sys
from pathlib import Path

import footfall as ff
from footfall.adaptation import Plane, Stairs, Terrain
from footfall.engine.recording import Recorder
from footfall.report import Trace
from footfall.skeleton import find_anatomy
from footfall.view import strip_svg


def main(folder: Path) -> None:
    """Climb, and write the picture."""
    walk, supports = ff.sample("walk")
    stairs = Stairs((0.0, 0.0, 2.0), 5, rise=0.17, tread=0.65, landing=9.0)
    ground = Terrain((Plane(), stairs))
    hero = ff.Character(walk.skeleton, ground=ground)
    hero.add("walk", walk, supports)
    hero.start("walk")
    recorder = Recorder(hero, 60)
    for _ in range(540):
        hero.advance(1 / 60)
        recorder.keep()

    shown = recorder.finish()
    heights = shown.world_positions[:, 0, 1]
    print(f"the pelvis rose by {heights[-1] - heights[0]:.2f} m")
    trace = Trace(
        positions=shown.world_positions,
        rotations=shown.world_rotations,
        anatomy=find_anatomy(walk.skeleton),
        fps=60,
        supports=shown.supports,
    )
    picture = strip_svg([("up the stairs", trace)], walk.skeleton.parents, ground=ground)
    (folder / "05_up_the_stairs.svg").write_text(picture, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))

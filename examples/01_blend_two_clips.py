"""A walk becomes a run at an odd moment, and no foot slides.

The picture is the ground from above: prints are planted feet.
"""

import sys
from pathlib import Path

import footfall as ff
from footfall.engine.recording import Recorder
from footfall.motion import with_soles
from footfall.report import Trace
from footfall.skeleton import find_anatomy
from footfall.view import foot_traces_svg

FPS = 60


def main(folder: Path) -> None:
    """Play, and write the picture."""
    walk, supports = ff.sample("walk")
    hero = ff.Character(walk.skeleton)
    hero.add("walk", walk, supports)
    hero.add("run", *ff.sample("run"), priority=2.0, fade_in=0.4)

    recorder = Recorder(hero, FPS)
    for frame in range(300):
        if frame == 0:
            hero.start("walk")
        if frame == 131:
            print(hero.start("run"))
        if frame == 160:
            hero.stop("walk")
        hero.advance(1 / FPS)
        recorder.keep()

    shown = recorder.finish()
    trace = Trace(
        positions=shown.world_positions,
        rotations=shown.world_rotations,
        anatomy=with_soles(find_anatomy(walk.skeleton), *walk.world_poses()),
        fps=FPS,
        supports=shown.supports,
    )
    picture = foot_traces_svg([("a walk, then a run", trace)])
    (folder / "01_blend_two_clips.svg").write_text(picture, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))

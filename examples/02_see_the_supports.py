"""What holds a body up, found in a clip, beside what it was made with.

The picture shows the clip from its right side.
"""

import sys
from pathlib import Path

import footfall as ff
from footfall.report import clip_trace
from footfall.skeleton import find_anatomy
from footfall.view import strip_svg


def main(folder: Path) -> None:
    """Detect, compare, and write the picture."""
    clip, known = ff.sample("walk-to-hop")
    found = ff.detect_supports(clip)
    print(f"made with {known}")
    print(f"found     {found}")

    trace = clip_trace(clip, find_anatomy(clip.skeleton), found)
    picture = strip_svg([("a walk that becomes a hop", trace)], clip.skeleton.parents)
    (folder / "02_see_the_supports.svg").write_text(picture, encoding="utf-8")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))

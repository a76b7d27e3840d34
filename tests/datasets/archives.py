"""A small archive of motions, made from the project's own samples."""

from __future__ import annotations

from pathlib import Path

from footfall.io import save
from footfall.samples import sample

NAMES = ("walk", "run", "kick", "side-step", "jump", "hop-left")
FILES = tuple(
    sorted([f"gaits/{name}.bvh" for name in NAMES[:3]] + [f"{name}.npz" for name in NAMES[3:]])
)
BROKEN = "gaits/broken.bvh"


def make_archive(folder: Path, *, broken: bool = False) -> Path:
    """Write six motions below a folder, and a broken one, if wanted; return the folder."""
    (folder / "gaits").mkdir(parents=True)
    for file in FILES:
        save(sample(Path(file).stem)[0], folder / file)
    if broken:
        (folder / BROKEN).write_text("HIERARCHY\nno such thing\n")
    (folder / "readme.txt").write_text("no motion")
    return folder

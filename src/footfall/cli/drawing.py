"""The figures of the paper, drawn anew: `figures`."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from footfall.errors import FileFormatError
from footfall.figures import Cast, write_gallery

__all__ = ["figures"]


def figures(
    *,
    output: Annotated[Path, Parameter(name=("-o", "--output"))] = Path("figures"),
    motions: Path | None = None,
    animations: Annotated[bool, Parameter(negative="--no-animations")] = True,
) -> None:
    """Draw figures 2 to 18 of the paper anew, each computed by this library.

    Parameters
    ----------
    output
        The folder to write to; made if it is missing.
    motions
        A folder of your own motions, named after the parts they play, such as walk_fast.bvh;
        by default, and for the other parts, those made by the project.
    animations
        Whether the files that play, .glb and .html, are written too.
    """
    if output.exists() and not output.is_dir():
        raise FileFormatError("it is a file; name a folder", path=output)
    cast = Cast.of_samples() if motions is None else Cast.of_folder(motions)
    output.mkdir(parents=True, exist_ok=True)
    for figure in write_gallery(output, cast, animations=animations):
        print(f"{output / figure.stem}.svg")
        for fact in figure.facts:
            print(f"  {fact}")
    print(output / "README.md")

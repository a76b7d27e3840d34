"""Open the studio: `studio`."""

from __future__ import annotations

import time
import webbrowser
from pathlib import Path

from footfall.cli.demonstration import take_page
from footfall.errors import ArgumentError
from footfall.studio import open_studio

__all__ = ["studio"]


def studio(*files: str, host: str = "127.0.0.1", port: int = 8080, browser: bool = True) -> None:
    """See motions, steer a character, correct supports: in a browser.

    Files are written only to the folder it is started in, and below.

    Parameters
    ----------
    files
        .bvh, .bvh.gz or .npz files, folders of them, or sample:NAME; by default some samples.
    host
        The address to bind to.
    port
        Of the page, or the first free one after it; the 3D scene takes the next free one.
    browser
        Open the page in a browser.
    """
    if not 0 <= port <= 65000:
        raise ArgumentError(f"--port is {port}; it must be a number from 0 to 65000")
    with open_studio(_expanded(files), host=host, port=port, page_writer=take_page) as opened:
        print(f"studio: {opened.url}")
        print(f"ports: {opened.port} the page, {opened.scene_port} the 3D scene (forward both)")
        print(f"files are written to {opened.session.folder.root}; Ctrl+C ends it", flush=True)
        if browser:
            webbrowser.open(opened.url)
        try:
            while True:
                time.sleep(3600.0)
        except KeyboardInterrupt:
            print("\nclosed")


def _expanded(files: tuple[str, ...]) -> list[str]:
    """Return the files, with those of folders in place of them.

    Raises:
        ArgumentError: If a folder holds none.
    """
    found: list[str] = []
    for file in files:
        folder = Path(file)
        if not folder.is_dir():
            found.append(file)
            continue
        inside = sorted(
            str(path.resolve())
            for path in folder.rglob("*")
            if path.name.lower().endswith((".bvh", ".bvh.gz", ".npz"))
        )
        if not inside:
            raise ArgumentError(f"{file} holds no motion; put .bvh, .bvh.gz or .npz files there")
        found += inside
    return found

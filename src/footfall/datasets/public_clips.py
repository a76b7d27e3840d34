"""A few motions that others have published under free licenses, fetched into the user's cache.

None of them is part of this package. Where each is, what its bytes are, and under which license
stands in ``public_clips.toml``.
"""

from __future__ import annotations

import shutil
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any
from urllib.error import HTTPError
from urllib.request import urlopen

from footfall.errors import FileFormatError, UnknownNameError
from footfall.extras import extra_module

__all__ = ["PublicClip", "fetch_clip", "find_clip", "public_clips"]

TIMEOUT = 30.0
"""How long a server may be silent [s]."""

FREE = ("Apache-2.0", "CC0-1.0", "MIT")
"""Licenses under which a clip may be listed."""


@dataclass(frozen=True, slots=True)
class PublicClip:
    """A motion on the network."""

    name: str
    """What it is called here."""

    file: str
    """What its file is called in the cache."""

    url: str
    """Where it is; holds a commit, so that it never changes."""

    sha256: str
    """The digest of its bytes, in hexadecimal."""

    bytes: int
    """How many they are."""

    seconds: float
    """How long it lasts [s]."""

    license: str
    """Its license, by its SPDX name."""

    source: str
    """Who published it."""


def public_clips() -> tuple[PublicClip, ...]:
    """Return all motions of the catalog."""
    text = resources.files("footfall.datasets").joinpath("public_clips.toml").read_text("utf-8")
    entries: list[dict[str, Any]] = tomllib.loads(text)["clip"]
    return tuple(PublicClip(**entry) for entry in entries)


def find_clip(name: str, clips: Sequence[PublicClip]) -> PublicClip:
    """Return the motion with this name.

    Raises:
        UnknownNameError: If there is none.
    """
    for clip in clips:
        if clip.name == name:
            return clip
    raise UnknownNameError("public clip", name, (clip.name for clip in clips))


def fetch_clip(clip: PublicClip, folder: Path | None = None) -> Path:
    """Return the file of a motion; fetched unless it is there already, whole and as it must be.

    Args:
        clip: The motion.
        folder: Where to; None: the user's cache.

    Raises:
        FileFormatError: If it cannot be fetched, or what is fetched is not what it must be; then
            nothing is left behind.
        MissingExtraError: If Pooch is not installed.
    """
    pooch = extra_module("pooch", f"fetching {clip.name}", extra="samples")
    pooch.get_logger().setLevel("ERROR")
    target = (Path(pooch.os_cache("footfall")) if folder is None else folder) / clip.file
    try:
        fetched = pooch.retrieve(
            clip.url,
            f"sha256:{clip.sha256}",
            fname=target.name,
            path=target.parent,
            downloader=_download,
        )
    except ValueError as error:
        raise FileFormatError(
            f"is not what {clip.url} must hold: its digest is another; try again later, or report "
            "it",
            path=target,
        ) from error
    except OSError as error:
        # Errors of the network are such, too.
        told = " ".join(str(error).split())[:160]
        raise FileFormatError(
            f"cannot be fetched from {clip.url}: {told}; check the network and try again",
            path=target,
        ) from error
    return Path(fetched)


def _download(url: str, output_file: str, _: Any) -> None:
    """Write what is at an address to a file: what Pooch calls, which then looks at the digest."""
    try:
        with urlopen(url, timeout=TIMEOUT) as answer, open(output_file, "wb") as file:
            shutil.copyfileobj(answer, file)
    except HTTPError as error:
        # It holds the connection on which the refusal came.
        error.close()
        raise

"""Motions of others: `samples list` and `samples fetch`."""

from __future__ import annotations

from pathlib import Path

from footfall.datasets.public_clips import fetch_clip, find_clip, public_clips

__all__ = ["fetch_samples", "list_samples"]


def list_samples() -> None:
    """List motions that others have published under free licenses."""
    clips = public_clips()
    width = max(len(clip.name) for clip in clips)
    for clip in clips:
        print(
            f"{clip.name:<{width}}  {clip.seconds:5.1f} s  {clip.bytes / 1e3:6.0f} kB  "
            f"{clip.license:<10}  {clip.source}"
        )


def fetch_samples(*names: str, folder: Path | None = None) -> None:
    """Fetch motions that others have published, and say where they are and under which license.

    Parameters
    ----------
    names
        Their names; all where none is given.
    folder
        Where to; by default the user's cache.
    """
    clips = public_clips()
    chosen = [find_clip(name, clips) for name in names] if names else clips
    for clip in chosen:
        print(f"{fetch_clip(clip, folder)}  ({clip.license}, {clip.source})")

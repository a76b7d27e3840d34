"""The folder the studio was started in: the only place it ever writes to."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from footfall.errors import FileFormatError
from footfall.io import readable_suffixes, write_atomically

__all__ = ["LARGEST_FILE", "WorkFolder", "check_size"]

LARGEST_FILE = 256 * 1024 * 1024
"""A larger motion file is refused [bytes]: it would not fit the memory several times over."""

MOST_LISTED = 500
"""How many motion files are offered for loading."""

DEEPEST = 3
"""How many folders down they are looked for."""

SUFFIXES = tuple(one for one in readable_suffixes() if one not in (".json", ".txt"))
"""Of files that are offered as motions: what else may hold one is seldom one."""

SKINS = (".glb", ".gltf")
"""Of files that are offered as bodies."""


@dataclass(frozen=True, slots=True)
class WorkFolder:
    """A folder, and what may be read and written there."""

    root: Path
    """Resolved."""

    @classmethod
    def at(cls, path: Path | str) -> WorkFolder:
        """Return the work folder of a path."""
        return cls(Path(path).resolve())

    def place(self, name: str | Path) -> Path:
        """Return where a file of this name may be written.

        Raises:
            FileFormatError: If that is outside the folder, links followed, or is a link or a
                folder.
        """
        path = self.root / name
        try:
            real = path.parent.resolve() / path.name
        except (OSError, RuntimeError, ValueError) as error:
            raise FileFormatError(f"is no name of a file: {error}", path=path) from None
        if not real.is_relative_to(self.root) or real == self.root or real.name == "..":
            raise FileFormatError(
                f"lies outside of {self.root}, where the studio was started; it writes nowhere "
                "else, so start it in the folder of the file",
                path=path,
            )
        if real.is_symlink():
            raise FileFormatError("is a link; the studio writes only plain files", path=path)
        return real

    def write(self, name: str | Path, data: bytes) -> Path:
        """Write a file whole, or not at all, and return where it is.

        Raises:
            FileFormatError: As `place`, or if it cannot be written.
        """
        path = self.place(name)
        write_atomically(path, data)
        return path

    def readable(self, name: str) -> Path:
        """Return a file to read, named from within the folder.

        Raises:
            FileFormatError: If it lies outside, links followed, or is too large.
        """
        path = (self.root / name).resolve()
        if not path.is_relative_to(self.root):
            raise FileFormatError(
                f"lies outside of {self.root}, where the studio was started; name it on the "
                "command line",
                path=self.root / name,
            )
        check_size(path)
        return path

    def motions(self) -> list[str]:
        """Return the motion files in and below the folder, by name from it."""
        return self._files(SUFFIXES, DEEPEST)

    def bodies(self) -> list[str]:
        """Return the files in and below the folder that may hold a body in its skin, by name."""
        return self._files(SKINS, DEEPEST)

    def scenarios(self) -> list[str]:
        """Return the scenario files in the folder, by name."""
        return self._files((".toml",), 0)

    def _files(self, suffixes: tuple[str, ...], deepest: int) -> list[str]:
        found: list[str] = []
        folders = [(self.root, 0)]
        while folders and len(found) < MOST_LISTED:
            folder, depth = folders.pop(0)
            try:
                entries = sorted(folder.iterdir())
            except OSError:
                continue
            for entry in entries:
                if entry.name.startswith(".") or entry.is_symlink():
                    continue
                if entry.is_dir() and depth < deepest:
                    folders.append((entry, depth + 1))
                elif entry.name.lower().endswith(suffixes) and entry.is_file():
                    found.append(str(entry.relative_to(self.root)))
        return sorted(found)[:MOST_LISTED]


def check_size(path: Path) -> None:
    """Refuse a file that is too large to be worked on.

    Raises:
        FileFormatError: If it is.
    """
    size = path.stat().st_size if path.is_file() else 0
    if size > LARGEST_FILE:
        raise FileFormatError(
            f"is {size / 2**20:.0f} MiB; the studio reads files up to {LARGEST_FILE / 2**20:.0f} "
            "MiB, so cut it first (footfall edit)",
            path=path,
        )

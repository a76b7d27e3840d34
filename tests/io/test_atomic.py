from __future__ import annotations

import ast
from pathlib import Path

import pytest

import footfall
from footfall.errors import FileFormatError
from footfall.io import atomic as module
from footfall.io import write_atomically


def test_a_file_is_written_whole_and_nothing_else_is_left(tmp_path: Path) -> None:
    path = tmp_path / "walk.bvh"
    write_atomically(path, b"one")
    write_atomically(path, b"another")
    assert path.read_bytes() == b"another"
    assert list(tmp_path.iterdir()) == [path]


def test_a_missing_folder_is_named(tmp_path: Path) -> None:
    path = tmp_path / "nowhere" / "walk.bvh"
    with pytest.raises(FileFormatError) as caught:
        write_atomically(path, b"")
    assert str(caught.value) == (
        f"{path}: cannot be written: there is no folder {str(path.parent)!r}; make it first"
    )


def test_a_folder_is_not_overwritten(tmp_path: Path) -> None:
    with pytest.raises(FileFormatError) as caught:
        write_atomically(tmp_path, b"")
    assert str(caught.value) == f"{tmp_path}: cannot be written: it is a folder; name a file"


def test_a_failure_leaves_the_old_file_and_no_temporary_one(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "walk.bvh"
    path.write_bytes(b"old")

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(module.os, "fsync", full)
    with pytest.raises(FileFormatError) as caught:
        write_atomically(path, b"new")
    assert str(caught.value) == (
        f"{path}: cannot be written: no space left on device; choose a place that can be written to"
    )
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


ALLOWED = {
    "io/atomic.py": "writes beside the file and then renames",
    "datasets/manifest.py": "adds lines, and drops one that was cut short when it is next opened",
    "io/guarded_server.py": "answers on its standard output",
    "datasets/public_clips.py": "fills a temporary file of the downloader, which renames it",
}


def writing_calls(source: str) -> list[str]:
    """Return the calls of a module that write to a file under its own name."""
    found: list[str] = []
    for node in ast.walk(ast.parse(source)):
        if not isinstance(node, ast.Call):
            continue
        name = node.func.attr if isinstance(node.func, ast.Attribute) else ast.unparse(node.func)
        given = [*node.args, *(keyword.value for keyword in node.keywords)]
        words = [one.value for one in given if isinstance(one, ast.Constant)]
        modes = [word for word in words if isinstance(word, str) and set(word) <= set("rwxabt+")]
        opens = name in ("open", "fdopen") and any(set(mode) & set("wxa+") for mode in modes)
        if opens or name in ("write_text", "write_bytes", "tofile", "O_WRONLY"):
            found.append(ast.unparse(node))
    return found


@pytest.mark.parametrize(
    ("source", "count"),
    [
        ('open(path, "wb")', 1),
        ('path.open(mode="w")', 1),
        ('path.write_text("")', 1),
        ('open(path, "rb")', 0),
        ("open(path)", 0),
        ("write_atomically(path, data)", 0),
    ],
)
def test_a_call_that_writes_is_seen(source: str, count: int) -> None:
    assert len(writing_calls(source)) == count


def test_nobody_else_writes_a_file() -> None:
    root = Path(footfall.__file__).parent
    writers = {
        path.relative_to(root).as_posix()
        for path in sorted(root.rglob("*.py"))
        if writing_calls(path.read_text(encoding="utf-8"))
    }
    assert writers == set(ALLOWED)

from __future__ import annotations

import ast
import inspect
import math
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from footfall import compilation
from footfall.compilation import Prepared, kernel, lean_kernel

source_digest: Callable[[], str] = getattr(compilation, "_source_digest")  # noqa: B009
cache_folder: Callable[[], Path] = getattr(compilation, "_cache_folder")  # noqa: B009


@pytest.fixture
def tree(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a small source tree that stands in for the project's."""
    root = tmp_path / "footfall"
    (root / "geometry").mkdir(parents=True)
    (root / "compilation.py").write_text("")
    (root / "geometry" / "curves.py").write_text("one = 1\n")
    monkeypatch.setattr(compilation, "__file__", str(root / "compilation.py"))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return root


def edit(root: Path) -> None:
    (root / "geometry" / "curves.py").write_text("one = 2\n")


def add(root: Path) -> None:
    (root / "geometry" / "more.py").write_text("")


def rename(root: Path) -> None:
    (root / "geometry" / "curves.py").rename(root / "geometry" / "lines.py")


def move(root: Path) -> None:
    (root / "geometry" / "curves.py").rename(root / "curves.py")


def remove(root: Path) -> None:
    (root / "geometry" / "curves.py").unlink()


@pytest.mark.parametrize("change", [edit, add, rename, move, remove])
def test_the_cache_folder_changes_with_any_source_file(
    tree: Path, change: Callable[[Path], None]
) -> None:
    before = cache_folder()
    change(tree)
    after = cache_folder()
    assert before != after
    assert before.is_dir()
    assert after.is_dir()


def test_the_cache_folder_stays_while_nothing_but_dates_and_other_files_change(tree: Path) -> None:
    before = cache_folder()
    os.utime(tree / "geometry" / "curves.py", (0, 0))
    (tree / "py.typed").write_text("")
    assert cache_folder() == before
    assert before == tree.parent / "cache" / "footfall" / source_digest()


def test_a_leaf_counts_only_where_it_holds_kernels(tree: Path) -> None:
    (tree / "io").mkdir()
    leaf = tree / "io" / "files.py"
    before = source_digest()
    leaf.write_text("one = 1\n")
    assert source_digest() == before
    leaf.write_text("from footfall.compilation import kernel\n")
    assert source_digest() != before


def names_of_kernels(tree: ast.Module) -> set[str]:
    """Return every name that a kernel of a module uses."""
    return {
        name.id
        for function in ast.walk(tree)
        if isinstance(function, ast.FunctionDef)
        and any("kernel" in ast.unparse(each) for each in function.decorator_list)
        for name in ast.walk(function)
        if isinstance(name, ast.Name)
    }


def test_no_kernel_reads_a_leaf_that_does_not_count() -> None:
    root = Path(compilation.__file__).parent
    kernels = 0
    for path in sorted(root.rglob("*.py")):
        tree = ast.parse(path.read_text())
        used = names_of_kernels(tree)
        kernels += bool(used)
        for node in ast.walk(tree):
            if not isinstance(node, ast.ImportFrom) or node.module is None:
                continue
            package, *parts = node.module.split(".")
            if package != "footfall" or not parts or parts[0] not in compilation.LEAVES:
                continue
            read = root.joinpath(*parts).with_suffix(".py")
            counts = read.is_file() and "footfall.compilation" in read.read_text()
            captured = used & {alias.asname or alias.name for alias in node.names}
            assert counts or not captured, f"{path} captures {captured} of {node.module}"
    assert kernels > 20


def test_where_the_users_cache_cannot_be_written_a_temporary_folder_is_used(
    tree: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tree / "compilation.py"))
    monkeypatch.setattr("tempfile.tempdir", str(tree.parent))
    folder = cache_folder()
    assert folder.parent.parent == tree.parent
    assert folder.name == source_digest()
    assert folder.is_dir()


def test_an_edit_in_another_module_reaches_machine_code_that_was_kept(tmp_path: Path) -> None:
    package = tmp_path / "footfall"
    package.mkdir()
    (package / "__init__.py").write_text("")
    (package / "compilation.py").write_text(inspect.getsource(compilation))
    callee, caller = package / "callee.py", package / "caller.py"
    imports = "from footfall.compilation import kernel\n"
    body = "@kernel\ndef {}(x: float) -> float:\n    return {}\n"
    caller.write_text(
        f"{imports}from footfall.callee import inner\n" + body.format("outer", "inner(x)")
    )
    environment = {**os.environ, "PYTHONPATH": str(tmp_path), "XDG_CACHE_HOME": str(tmp_path)}
    command = [sys.executable, "-c", "from footfall.caller import outer; print(outer(1.0))"]
    answers: list[str] = []
    for result in ("x + 1.0", "x + 1.0", "x + 2.0"):
        callee.write_text(imports + body.format("inner", result))
        run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
        answers.append(run.stdout.strip())
    assert answers == ["2.0", "2.0", "3.0"]
    assert list(tmp_path.rglob("*.nbc"))


@kernel
def ratio(one: float, other: float) -> float:
    """Return one over the other."""
    return one / other


def test_a_kernel_divides_as_numpy_does() -> None:
    assert ratio(1.0, 0.0) == math.inf
    assert math.isnan(ratio(0.0, 0.0))
    assert ratio(1.0, 4.0) == 0.25


def test_a_kernel_keeps_its_name_and_its_documentation() -> None:
    assert ratio.__name__ == "ratio"
    assert ratio.__doc__ == "Return one over the other."


@lean_kernel
def _first_of(numbers: Any, place: int, out: Any) -> None:
    out[0] = numbers[place]


@pytest.mark.parametrize("kind", [np.float32, np.int8, np.float64])
def test_a_prepared_kernel_notices_arrays_of_another_type(kind: type[Any]) -> None:
    prepared = Prepared(_first_of)
    out = np.zeros(1)
    prepared((np.array([1.5, 2.5]), 1, out))
    assert out[0] == 2.5
    for place in range(3):
        numbers = np.array([3, 4, 5], dtype=kind)
        prepared((numbers, place, out))
        assert out[0] == 3 + place
    prepared((np.arange(20.0)[::7], 2, out))
    assert out[0] == 14.0


def test_a_prepared_kernel_reads_what_its_arrays_hold_now() -> None:
    prepared, numbers, out = Prepared(_first_of), np.zeros(2), np.zeros(1)
    arguments = (numbers, 0, out)
    for value in (1.0, 2.0):
        numbers[0] = value
        prepared(arguments)
        assert out[0] == value

"""What is public is said in each `__all__`, and what is said there exists."""

from __future__ import annotations

import ast
import importlib
import inspect
from pathlib import Path
from types import ModuleType

import pytest

import footfall

ROOT = Path(footfall.__file__).parent


def module_name(path: Path) -> str:
    parts = ("footfall", *path.relative_to(ROOT).with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = sorted(module_name(path) for path in ROOT.rglob("*.py") if path.stem != "__main__")
PACKAGES = sorted(module_name(path) for path in ROOT.rglob("__init__.py"))


def rank(name: str) -> tuple[int, str]:
    """Return where a name stands in a sorted `__all__`: constants, classes, functions."""
    if name.isupper():
        return 0, name
    return (1 if name[0].isupper() else 2), name


def public_names(module: ModuleType) -> list[str] | None:
    return getattr(module, "__all__", None)


@pytest.mark.parametrize("name", MODULES)
def test_every_module_says_what_is_public_sorted_once_and_truly(name: str) -> None:
    module = importlib.import_module(name)
    public = public_names(module)
    assert public is not None, f"{name} has no __all__"
    assert public == sorted(set(public), key=rank)
    assert [entry for entry in public if not hasattr(module, entry)] == []


@pytest.mark.parametrize("name", MODULES)
def test_no_function_or_class_without_an_underscore_is_left_out(name: str) -> None:
    module = importlib.import_module(name)
    defined = [
        node.name
        for node in ast.parse(inspect.getsource(module)).body
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef)
        and not node.name.startswith("_")
    ]
    assert [entry for entry in defined if entry not in (public_names(module) or [])] == []


@pytest.mark.parametrize("name", PACKAGES)
def test_a_package_shows_all_that_it_takes_from_its_modules(name: str) -> None:
    module = importlib.import_module(name)
    taken = [
        alias.asname or alias.name
        for node in ast.walk(ast.parse(inspect.getsource(module)))
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(f"{name}.")
        for alias in node.names
    ]
    missing = set(taken) - set(public_names(module) or [])
    assert sorted(name for name in missing if not name.startswith("_")) == []


@pytest.mark.parametrize("name", MODULES)
def test_everything_public_is_documented(name: str) -> None:
    module = importlib.import_module(name)
    assert module.__doc__
    for entry in public_names(module) or []:
        value = getattr(module, entry)
        if inspect.isclass(value) or inspect.isroutine(value):
            assert value.__doc__, f"{name}.{entry} has no docstring"


def test_a_name_has_one_home() -> None:
    homes: dict[str, set[int]] = {}
    for package in PACKAGES:
        if package != "footfall":
            module = importlib.import_module(package)
            for entry in public_names(module) or []:
                homes.setdefault(entry, set()).add(id(getattr(module, entry)))
    front = importlib.import_module("footfall")
    for entry in public_names(front) or []:
        assert not entry.startswith("_")
        if entry in homes:
            assert id(getattr(front, entry)) in homes[entry], f"footfall.{entry} is another one"

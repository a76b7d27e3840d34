"""Who may import whom: the table of docs/architecture.md, as data."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

import footfall

ROOT = Path(footfall.__file__).parent
SOURCES = sorted(ROOT.rglob("*.py"))

OPEN = frozenset({"errors", "arrays", "compilation", "extras", "octets", "octet_memory"})
"""Modules that everybody may import, and that import none but each other."""

_BODIES = frozenset({"geometry", "skeleton", "motion", "support"})
_STAGES = _BODIES | {"sync", "timing", "blending", "adaptation"}
_ALL_BUT_FACES = _STAGES | {
    "detection",
    "actions",
    "engine",
    "baselines",
    "scenario",
    "samples",
    "io",
}
_NOBODY: frozenset[str] = frozenset()

MAY_IMPORT: dict[str, frozenset[str]] = {
    "geometry": _NOBODY,
    "support": _NOBODY,
    "skeleton": frozenset({"geometry"}),
    "motion": frozenset({"geometry", "skeleton"}),
    "detection": _BODIES,
    "sync": frozenset({"support"}),
    "timing": frozenset({"geometry", "support", "sync"}),
    "blending": frozenset({"geometry", "skeleton"}),
    "adaptation": frozenset({"geometry", "skeleton", "support"}),
    "actions": _BODIES | {"sync", "timing", "blending"},
    "engine": _STAGES | {"actions"},
    "baselines": _STAGES | {"engine"},
    "samples": _BODIES,
    "io": _BODIES,
    "scenario": _ALL_BUT_FACES,
    "report": _ALL_BUT_FACES,
    "view": _ALL_BUT_FACES | {"report"},
    "figures": _ALL_BUT_FACES | {"report", "view"},
    "robots": _BODIES | {"io"},
    "datasets": _ALL_BUT_FACES | {"report", "view"},
    "studio": _ALL_BUT_FACES | {"report", "view"},
    "benchmark": _ALL_BUT_FACES | {"view"},
    "warming": _ALL_BUT_FACES,
    "cli": _ALL_BUT_FACES
    | {
        "report",
        "studio",
        "view",
        "datasets",
        "figures",
        "robots",
        "benchmark",
        "footfall",
        "warming",
    },
    "__main__": frozenset({"cli"}),
    "footfall": _ALL_BUT_FACES | {"report", "warming"},
} | dict.fromkeys(OPEN, _NOBODY)
"""Each package, each module beside them, and `footfall` for the front door itself."""


def layer_of(module: str) -> str:
    """Return the layer of a module of ours, by its dotted name."""
    parts = module.split(".")
    return parts[1] if len(parts) > 1 else "footfall"


def module_name(path: Path) -> str:
    parts = ("footfall", *path.relative_to(ROOT).with_suffix("").parts)
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


def imported_layers(source: str, module: str, *, is_package: bool = False) -> set[str]:
    """Return the layers that a module imports, wherever in it the import stands."""
    layers: set[str] = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            names = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            start = node.module or ""
            if node.level:
                parts = module.split(".")
                kept = parts[: len(parts) - node.level + is_package]
                start = ".".join([*kept, start] if start else kept)
            names = [start]
            if start == "footfall":
                own = {alias.name for alias in node.names} & set(MAY_IMPORT)
                others = {alias.name for alias in node.names} - own
                names = [f"footfall.{name}" for name in own] + (["footfall"] if others else [])
        else:
            continue
        layers |= {layer_of(name) for name in names if name.split(".")[0] == "footfall"}
    return layers


def violations(source: str, module: str, *, is_package: bool = False) -> list[str]:
    """Return what the table has against a module, one sentence an import."""
    layer = layer_of(module)
    if layer not in MAY_IMPORT:
        return [f"{layer} has no row in the table of layers"]
    allowed = MAY_IMPORT[layer] | OPEN | {layer}
    return [
        f"{layer} may not import {other}"
        for other in sorted(imported_layers(source, module, is_package=is_package) - allowed)
    ]


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: str(path.relative_to(ROOT)))
def test_every_import_points_up_the_line(path: Path) -> None:
    found = violations(path.read_text(), module_name(path), is_package=path.stem == "__init__")
    assert found == []


@pytest.mark.parametrize(
    ("module", "source", "expected"),
    [
        ("sync.paper", "from footfall.skeleton import Skeleton", ["sync may not import skeleton"]),
        ("sync.paper", "import footfall.skeleton.anatomy", ["sync may not import skeleton"]),
        ("sync.paper", "from footfall import skeleton", ["sync may not import skeleton"]),
        ("sync.paper", "from ..skeleton import anatomy", ["sync may not import skeleton"]),
        ("sync.paper", "from .. import skeleton", ["sync may not import skeleton"]),
        ("sync.paper", "from footfall import Clip", ["sync may not import footfall"]),
        ("sync.paper", "import footfall", ["sync may not import footfall"]),
        ("sync.paper", "def late():\n    import footfall.io", ["sync may not import io"]),
        ("sync.paper", "from footfall.support import Support\nfrom . import schedule", []),
        ("sync.paper", "import numpy\nfrom footfall.errors import ArgumentError", []),
        ("geometry.curves", "from footfall.compilation import kernel", []),
        ("arrays", "from footfall.geometry import rotate", ["arrays may not import geometry"]),
        ("io.bvh", "from footfall.detection import detect", ["io may not import detection"]),
        ("tools.knife", "", ["tools has no row in the table of layers"]),
    ],
)
def test_a_forbidden_import_is_found(module: str, source: str, expected: list[str]) -> None:
    assert violations(source, f"footfall.{module}") == expected


def test_the_front_door_shows_neither_viewer_nor_commands() -> None:
    source = "from footfall.view import studio\nfrom footfall.engine import Character"
    found = violations(source, "footfall", is_package=True)
    assert found == ["footfall may not import view"]


def test_a_packages_own_relative_imports_are_its_own() -> None:
    assert violations("from .paper import rule", "footfall.sync", is_package=True) == []
    found = violations("from ..io import load", "footfall.sync", is_package=True)
    assert found == ["sync may not import io"]


def test_the_table_has_no_circle() -> None:
    placed: set[str] = set(OPEN)
    while waiting := set(MAY_IMPORT) - placed:
        free = {layer for layer in waiting if MAY_IMPORT[layer] <= placed | {layer}}
        assert free, f"these import each other in a circle: {sorted(waiting)}"
        placed |= free


def test_there_are_sources_to_look_at() -> None:
    assert len(SOURCES) > 30

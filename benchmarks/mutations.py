"""Small faults put into a copy of the source, one at a time: which of them does no test see?

Run as ``python benchmarks/mutations.py support 30``: so many faults, drawn evenly, in the modules
of a package. Nothing is compiled meanwhile. Prints one line a fault; survivors are judged in
docs/mutation.md.
"""

from __future__ import annotations

import ast
import os
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).parents[1]

TESTS = {
    "support": ["tests/support", "tests/paper/test_figure_04_support_algebra.py"],
    "timing": ["tests/timing", "tests/paper/test_figures_10_to_12_time_warp.py"],
    "sync": [
        "tests/sync/test_shares.py",
        "tests/sync/test_muting.py",
        "tests/sync/test_path.py",
        "tests/sync/test_options.py",
        "tests/sync/test_refusal.py",
        "tests/sync/test_schedule_text.py",
        "tests/sync/test_synchronizer.py",
        "tests/sync/test_schedule_html.py",
        "tests/sync/test_paper.py",
        "tests/sync/test_planner_properties.py",
        "tests/sync/test_every_pair.py",
        "tests/sync/test_golden_traces.py",
        "tests/sync/test_golden_schedules.py",
    ],
}
"""Which tests must see the faults of a package."""

LONGER = 3.0
"""How many times as long as without a fault the tests may last; longer, and they hang."""

COMPARISONS: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.LtE,
    ast.LtE: ast.Lt,
    ast.Gt: ast.GtE,
    ast.GtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
}
ARITHMETIC: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
    ast.BitAnd: ast.BitOr,
    ast.BitOr: ast.BitAnd,
}


def faults(source: str) -> Iterator[tuple[int, str, str]]:
    """Return each fault: its line, what is changed, and the faulty source."""
    count = len(list(ast.walk(ast.parse(source))))
    for index in range(count):
        tree = ast.parse(source)
        node = list(ast.walk(tree))[index]
        told = _damage(node)
        if told is not None:
            yield getattr(node, "lineno", 0), told, ast.unparse(tree)


def _damage(node: ast.AST) -> str | None:
    """Change a node in place; return what was done, or None where there is nothing to do."""
    if isinstance(node, ast.Compare) and type(node.ops[0]) in COMPARISONS:
        before = type(node.ops[0])
        node.ops[0] = COMPARISONS[before]()
        return f"{before.__name__} -> {COMPARISONS[before].__name__}"
    if isinstance(node, ast.BinOp | ast.AugAssign) and type(node.op) in ARITHMETIC:
        before = type(node.op)
        node.op = ARITHMETIC[before]()
        return f"{before.__name__} -> {ARITHMETIC[before].__name__}"
    if isinstance(node, ast.BoolOp):
        before = type(node.op)
        node.op = ast.Or() if isinstance(node.op, ast.And) else ast.And()
        return f"{before.__name__} -> {type(node.op).__name__}"
    if isinstance(node, ast.Constant) and isinstance(node.value, bool):
        node.value = not node.value
        return f"{not node.value} -> {node.value}"
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        number = node.value
        node.value = number + 1
        return f"{number} -> {node.value}"
    return None


def outcome(copy: Path, package: str, limit: float | None = None) -> str:
    """Return "survived" where all tests pass with the copy, "found", or "hung" past a limit [s]."""
    environment = {**os.environ, "PYTHONPATH": str(copy), "NUMBA_DISABLE_JIT": "1"}
    command = [sys.executable, "-m", "pytest", "-p", "tests.plain_octets", "-q", "-x", "-n", "0"]
    command += ["-p", "tests.few_examples", "-m", "not full", "-p", "no:cacheprovider"]
    try:
        ran = subprocess.run(
            [*command, *TESTS[package]],
            cwd=ROOT,
            env=environment,
            capture_output=True,
            check=False,
            timeout=limit,
        )
    except subprocess.TimeoutExpired:
        return "hung"
    return "found" if ran.returncode else "survived"


def main() -> None:
    """Draw faults, try them, and say which survived."""
    package, most = sys.argv[1], int(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder)
        shutil.copytree(ROOT / "src" / "footfall", copy / "footfall")
        start = time.monotonic()
        if outcome(copy, package) != "survived":
            sys.exit("the tests fail without any fault; nothing can be said")
        limit = 30.0 + LONGER * (time.monotonic() - start)
        every = [
            (path, *fault)
            for path in sorted((copy / "footfall" / package).glob("*.py"))
            for fault in faults(path.read_text(encoding="utf-8"))
        ]
        drawn = sorted(random.Random(1).sample(every, min(most, len(every))), key=str)
        told_of: list[str] = []
        for path, line, told, faulty in drawn:
            sound = path.read_text(encoding="utf-8")
            path.write_text(faulty, encoding="utf-8")
            told_of.append(outcome(copy, package, limit))
            path.write_text(sound, encoding="utf-8")
            print(f"{told_of[-1]:9}{path.name}:{line}  {told}", flush=True)
        counts = ", ".join(
            f"{told_of.count(kind)} {kind}" for kind in ("found", "hung", "survived")
        )
        print(f"{package}: {len(drawn)} of {len(every)} faults: {counts}")


if __name__ == "__main__":
    main()

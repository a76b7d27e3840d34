"""Wheel and source archive, built and installed where nothing else is."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
FIRST_PROGRAM = """
import footfall as ff

walk, supports = ff.sample("walk")
hero = ff.Character(walk.skeleton)
hero.add("walk", walk, supports)
hero.add("run", *ff.sample("run"), priority=2.0)
hero.start("walk")
start = hero.advance(0.5).world_positions.copy()
hero.start("run")
end = hero.advance(0.5).world_positions
assert end[0, 2] > start[0, 2] + 0.3, (start[0], end[0])
print(end.shape, ff.__file__)
"""

pytestmark = pytest.mark.full


def runs(command: str) -> bool:
    """Whether an interpreter is there: a stand-in on the path may say that it is not."""
    if shutil.which(command) is None:
        return False
    return subprocess.run([command, "--version"], capture_output=True, check=False).returncode == 0


def kept_by_pyenv(minor: int) -> list[str]:
    """Return the interpreters of Python 3.`minor` that pyenv has put aside."""
    if shutil.which("pyenv") is None:
        return []
    told = subprocess.run(
        ["pyenv", "prefix", f"3.{minor}"], capture_output=True, text=True, check=False
    )
    return [f"{told.stdout.strip()}/bin/python"] if told.returncode == 0 else []


def interpreters() -> list[str]:
    """Return the oldest and the newest supported Python of this machine."""
    oldest = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["requires-python"]
    first = int(oldest.removeprefix(">=3."))
    found = [
        name
        for minor in range(first, first + 8)
        for name in [f"python3.{minor}", *kept_by_pyenv(minor)]
        if runs(name)
    ]
    return list(dict.fromkeys([found[0], found[-1]])) if found else [sys.executable]


def install(what: Path | str, python: str, home: Path) -> Path:
    """Install an archive, and nothing else that was asked for, into a new environment."""
    subprocess.run([python, "-m", "venv", home], check=True)
    pip = [home / "bin" / "python", "-m", "pip", "install", "-q", "--disable-pip-version-check"]
    subprocess.run([*pip, what], check=True)
    return home


def bare_environment(folder: Path) -> dict[str, str]:
    """Return what a user's shell says, without what this process says about Python."""
    environment = {
        name: value
        for name, value in os.environ.items()
        if not name.startswith(("PYTHON", "NUMBA", "XDG"))
    }
    return {**environment, "HOME": str(folder)}


def run_in(folder: Path, *command: Path | str) -> str:
    """Run a command in an empty folder, and return what it printed."""
    ran = subprocess.run(
        command,
        capture_output=True,
        text=True,
        cwd=folder,
        env=bare_environment(folder),
        check=False,
    )
    assert ran.returncode == 0, ran.stderr
    return ran.stdout


def archive(built: Path, pattern: str) -> Path:
    (found,) = built.glob(pattern)
    return found


def test_the_wheel_has_every_module_and_says_that_it_is_typed(built: Path) -> None:
    names = set(zipfile.ZipFile(archive(built, "*.whl")).namelist())
    source = ROOT / "src"
    parts = [
        path
        for path in (source / "footfall").rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    ]
    assert {str(path.relative_to(source)) for path in parts} <= names
    assert "footfall/py.typed" in names
    assert any(name.endswith("licenses/LICENSE") for name in names)
    assert not any(name.startswith(("tests", "docs", "benchmarks")) for name in names)


def test_the_source_archive_has_what_a_packager_needs(built: Path) -> None:
    with tarfile.open(archive(built, "*.tar.gz")) as opened:
        names = {name.split("/", 1)[1] for name in opened.getnames() if "/" in name}
    assert {"pyproject.toml", "LICENSE", "README.md", "Makefile", "CITATION.cff"} <= names
    assert "tests/test_layers.py" in names
    assert not any(name.startswith((".venv", "out", "demo")) for name in names)


@pytest.mark.parametrize("kind", ["*.whl", "*.tar.gz"])
@pytest.mark.parametrize("python", interpreters())
def test_the_first_program_runs_where_nothing_else_is(
    built: Path, python: str, kind: str, tmp_path: Path
) -> None:
    home = install(archive(built, kind), python, tmp_path / "empty")
    # Nothing compiled by the checkout is used: the installed engine compiles itself, here.
    told = run_in(tmp_path, home / "bin" / "python", "-c", FIRST_PROGRAM)
    assert told.startswith("(")
    assert str(home) in told
    assert "R D L D" in run_in(tmp_path, home / "bin" / "footfall", "sync", "R D L D*")


def test_the_demo_runs_from_the_installed_wheel_on_the_oldest_python(
    built: Path, tmp_path: Path
) -> None:
    home = install(archive(built, "*.whl"), interpreters()[0], tmp_path / "empty")
    run_in(tmp_path, home / "bin" / "footfall", "demo", "-o", "demo")
    assert (tmp_path / "demo" / "index.html").stat().st_size > 0
    assert (tmp_path / "demo" / "foot-traces.svg").read_text().startswith("<svg")

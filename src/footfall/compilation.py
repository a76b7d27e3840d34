"""How a kernel is compiled: one decorator, and a cache that notices every edit.

Numba's on-disk cache looks only at the file of the function itself: after an edit to a helper
in another module the old machine code would keep running. So the cache folder is named by a
hash of every source file that can reach a kernel.
"""

from __future__ import annotations

import hashlib
import operator
import os
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any, TypeVar, cast

import numba  # pyright: ignore[reportMissingTypeStubs]
import numpy as np
import numpy.typing as npt
from numba.core import config as numba_config  # pyright: ignore[reportMissingTypeStubs]

__all__ = [
    "Prepared",
    "inlined_kernel",
    "inner_kernel",
    "is_compiled",
    "kernel",
    "lean_kernel",
    "records",
    "small_kernel",
]

Function = TypeVar("Function", bound=Callable[..., Any])


LEAVES = frozenset(
    {
        "actions",
        "baselines",
        "benchmark",
        "cli",
        "datasets",
        "detection",
        "figures",
        "io",
        "report",
        "robots",
        "samples",
        "scenario",
        "studio",
        "view",
    }
)
"""Packages that no kernel imports: their files count only where they hold kernels themselves."""


def _source_digest() -> str:
    digest = hashlib.sha256(f"{sys.version} {numba.__version__}".encode())
    root = Path(__file__).parent
    for path in sorted(root.rglob("*.py")):
        source, name = path.read_bytes(), path.relative_to(root)
        if name.parts[0] in LEAVES and b"footfall.compilation" not in source:
            continue
        digest.update(str(name).encode())
        digest.update(source)
    return digest.hexdigest()[:16]


def _cache_folder() -> Path:
    """Return the folder of this source tree's machine code, below the user's cache."""
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    folder = Path(base) / "footfall" / _source_digest()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:
        folder = Path(tempfile.gettempdir()) / f"footfall-{os.getuid()}" / _source_digest()
        folder.mkdir(parents=True, exist_ok=True)
    return folder


_numba_config: Any = numba_config
_numba_config.CACHE_DIR = str(_cache_folder())
# Measured: a fifth less time to compile, and machine code that is no slower: loops here are short.
if "NUMBA_OPT" not in os.environ:
    _numba_config.OPT = type(_numba_config.OPT)(2)
if "NUMBA_LOOP_VECTORIZE" not in os.environ:
    _numba_config.LOOP_VECTORIZE = 0


def _compiled(function: Function, *, managed: bool = False, **options: bool | str) -> Function:
    njit: Any = numba.njit  # pyright: ignore[reportUnknownMemberType]
    return cast(Function, njit(nogil=True, error_model="numpy", _nrt=managed, **options)(function))


def kernel(function: Function) -> Function:
    """Compile a function on arrays of one character, or on scalars.

    A kernel trusts its input, allocates nothing that outlives it, and divides as NumPy does.
    It keeps its Python signature, so that callers are type-checked as usual.
    """
    return _compiled(function, managed=True, cache=True)


def lean_kernel(function: Function) -> Function:
    """Compile a function that Python calls every frame.

    As `kernel`, but it may allocate nothing at all: without Numba's memory manager nobody counts
    the references to arrays that are handed on, which took a third of the time.
    """
    return _compiled(function, cache=True)


def inner_kernel(function: Function) -> Function:
    """Compile a function that only other kernels call.

    As `lean_kernel`, but without the entry from Python, which for arguments of many arrays takes
    longer to compile than the function itself.
    """
    return _compiled(function, cache=True, no_cpython_wrapper=True, no_cfunc_wrapper=True)


def small_kernel(function: Function) -> Function:
    """Compile a function that becomes part of the machine code of each kernel that calls it.

    As `lean_kernel`, for what is small, or has one caller and many arguments: handing a motion
    library on from function to function takes longer than most of what is done with it.
    """
    return _compiled(function, cache=True, forceinline=True)


def inlined_kernel(function: Function) -> Function:
    """Copy a function into the kernel that calls it, before that is compiled.

    For a step that has a name for the reader's sake and a single caller: compiled on its own it
    would be translated together with everything below it, once more for each step of the way up.
    """
    return _compiled(function, inline="always")


def is_compiled(name: str) -> bool:
    """Return whether the cache holds machine code of a kernel of this name."""
    return any(Path(str(_numba_config.CACHE_DIR)).rglob(f"*.{name}-*.nbi"))


class Prepared:
    """A kernel that is called in every frame with the same arrays.

    To find out of which types a motion library and all the rest are takes Numba as long as a frame
    of one character; here that is done when one of them is another object than the last time.
    """

    def __init__(self, kernel: Callable[..., None]) -> None:
        """Prepare nothing yet."""
        self._kernel = kernel
        self._arguments: tuple[object, ...] = ()
        self._compiled: Callable[..., None] = kernel

    def __call__(self, arguments: tuple[object, ...], *numbers: float) -> None:
        """Call the kernel.

        Args:
            arguments: Its first arguments, tuples and arrays.
            numbers: The others, which are always of the same types.
        """
        known = self._arguments
        if len(known) != len(arguments) or any(map(operator.is_not, known, arguments)):
            self._compiled = _compiled_for(self._kernel, (*arguments, *numbers))
            self._arguments = arguments
        self._compiled(*arguments, *numbers)


def _compiled_for(kernel: Callable[..., None], arguments: tuple[object, ...]) -> Any:
    """Return machine code that takes arguments of exactly these types."""
    if _numba_config.DISABLE_JIT:
        return kernel
    type_of: Any = cast(Any, numba).typeof
    return cast(Any, kernel).compile(tuple(type_of(one) for one in arguments))


def records(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Return an array of records as kernels take it.

    Compiled code reads the fields of a record as attributes. Where nothing is compiled, with
    NUMBA_DISABLE_JIT, NumPy needs to be told to do so.
    """
    return array.view(np.recarray) if _numba_config.DISABLE_JIT else array

"""Libraries that few need: imported when they are used, or else one line about how to get them."""

from __future__ import annotations

import importlib
from typing import Any

from footfall.errors import MissingExtraError

__all__ = ["extra_module"]


def extra_module(module: str, purpose: str, *, extra: str, library: str | None = None) -> Any:
    """Import a module of an optional library.

    Args:
        module: Its dotted name.
        purpose: What is about to be done with it, for the message.
        extra: The extra of this project that brings the library.
        library: What the library is called where packages are listed; the module's name where
            not given.

    Raises:
        MissingExtraError: If it is not installed.
    """
    try:
        return importlib.import_module(module)
    except ImportError as error:
        raise MissingExtraError(purpose, library or module.split(".")[0], extra) from error

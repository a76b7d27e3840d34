"""A pytest plugin for `make coverage`: where nothing is compiled, a few samples must do."""

from __future__ import annotations

from typing import Any

import hypothesis

FEW = 6
"""Examples that hypothesis tries of each property."""

_decorate = hypothesis.settings.__init__


def _few(self: hypothesis.settings, *arguments: Any, **options: Any) -> None:
    options["max_examples"] = min(options.get("max_examples", FEW), FEW)
    options["deadline"] = None
    options["stateful_step_count"] = 8
    _decorate(self, *arguments, **options)


setattr(hypothesis.settings, "__init__", _few)  # noqa: B010
hypothesis.settings.register_profile("few", max_examples=FEW, deadline=None)
hypothesis.settings.load_profile("few")

"""Collections overlook what stays, as long as a studio is open."""

from __future__ import annotations

import gc

from footfall.studio.memory import release_memory, settle_memory


def test_what_stays_is_overlooked_until_it_is_released() -> None:
    try:
        settle_memory()
        assert gc.get_freeze_count() > 10_000
        assert len(gc.get_objects()) < 10_000
    finally:
        release_memory()
    assert gc.get_freeze_count() == 0

"""Which phases are played together: indices, no clock."""

from footfall.sync.schedule import Schedule, ScheduleRow
from footfall.sync.synchronizer import Synchronizer

__all__ = ["Schedule", "ScheduleRow", "Synchronizer"]

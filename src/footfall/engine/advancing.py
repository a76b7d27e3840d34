"""One frame of a whole crowd: every cohort with its body on its ground, shared by all threads."""

from __future__ import annotations

from collections.abc import Sequence

from footfall.adaptation.surface_record import Ground
from footfall.compilation import Prepared
from footfall.engine.bodies import Body
from footfall.engine.cohorts import Cohort, blocks_of
from footfall.engine.pipeline import advance_blocks
from footfall.engine.workers import Workers
from footfall.octets import LANES
from footfall.sync.tables import Rules

__all__ = ["Advancing"]


class Advancing:
    """The cohorts of a crowd, and what each thread has found out of them."""

    def __init__(self, cohorts: Sequence[Cohort], workers: Workers) -> None:
        """Prepare nothing yet."""
        self._cohorts = cohorts
        self._workers = workers
        self._kernels = [
            [Prepared(advance_blocks) for _ in cohorts] for _ in range(workers.threads)
        ]

    def advance(
        self, bodies: Sequence[Body], grounds: Sequence[Ground], rules: Rules, dt: float
    ) -> None:
        """Let a time [s] pass for everybody."""

        def advance(thread: int, first: int, end: int) -> None:
            for cohort, kernel in zip(self._cohorts, self._kernels[thread], strict=True):
                begin = cohort.span.first // LANES
                here, after = max(first - begin, 0), min(end - begin, len(cohort.poses))
                if here >= after:
                    continue
                body = bodies[cohort.span.body]
                work = self._workers.workspaces(body.skeleton.count)[thread]
                ground = grounds[cohort.span.ground]
                kernel(
                    (body.shelf, ground, body.rig, cohort.characters, work, rules, cohort.poses),
                    dt,
                    here,
                    after,
                )

        self._workers.run(advance, blocks_of(self._cohorts[-1].span.end))

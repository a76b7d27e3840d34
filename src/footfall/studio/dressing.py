"""Another body chosen: its motions are fitted beside the live session, then it performs them."""

from __future__ import annotations

from footfall.errors import ArgumentError
from footfall.studio.bodies import Body, bodies_of
from footfall.studio.jobs import Job
from footfall.studio.motion_list import MotionList
from footfall.studio.session import Session

__all__ = ["choose_body"]


def choose_body(session: Session, name: str) -> None:
    """Let another body perform; the take begins anew once all motions fit it.

    Raises:
        ArgumentError: If there is none of this name.
    """
    known = {body.name: body for body in bodies_of(session.motions.skeletons)}
    files = session.folder.bodies()
    if name not in known and name not in files:
        raise ArgumentError(f"no body {name!r}; there are: {', '.join([*known, *files])}")
    if name in known and _fits(session, known[name]):
        session.put_on(known[name])
        return

    def work(job: Job) -> None:
        body = known.get(name) or session.wardrobe.body(session.folder.readable(name), name)
        with session.lock:
            others = MotionList(session.folder, session.motions)
        others.body = body.skeleton
        count = len(others.motions)
        performed = others.fit_all(
            lambda one: job.report(others.motions.index(one) / count, one.name)
        )
        job.report(1.0)
        able = [one for one, _ in performed]
        refused = [one.name for one in others.motions if one not in able]
        with session.lock:
            session.put_on(body)
        session.tell({"kind": "changed"})
        if refused:
            session.notice(f"{name} cannot perform: {', '.join(refused)}", "error")

    session.jobs.begin(f"putting on {name}", work)


def _fits(session: Session, body: Body) -> bool:
    """Whether no motion has to be retargeted for a body."""
    motions = session.motions.motions
    chosen = body.skeleton or motions[0].motion.clip.skeleton
    return all(one.motion.clip.skeleton.same_family(chosen) for one in motions)

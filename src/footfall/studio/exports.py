"""What a take is saved as: a scenario, motions for other programs, a page, a picture."""

from __future__ import annotations

import io
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from footfall.errors import ArgumentError, FileFormatError
from footfall.io import (
    SkinnedBody,
    save,
    save_gltf,
    save_native,
    save_skinned,
    save_supports,
)
from footfall.scenario.cue_sheet import Scenario, parse_scenario
from footfall.scenario.motions import SAMPLE, Motion, supports_path
from footfall.scenario.performance import Performance, perform, played_supports, support_text
from footfall.studio.bodies import standing_clip
from footfall.studio.jobs import Job
from footfall.studio.take import scenario_text
from footfall.studio.work_folder import WorkFolder

if TYPE_CHECKING:
    from footfall.studio.session import Session

__all__ = ["FORMS", "PageWriter", "export"]

PageWriter = Callable[[Scenario], str]
"""Returns a page that plays a scenario without a network."""

FORMS = {
    "scenario": ".toml",
    "bvh": ".bvh",
    "glb": ".glb",
    "page": ".html",
    "picture": ".png",
}
"""What a take can be saved as, and the suffix of the file."""

PICTURE = (1920, 1080)


def export(session: Session, form: str, name: str) -> None:
    """Save the take so far, beside the live session.

    Raises:
        ArgumentError: If the form is unknown, or nothing has been started yet.
        FileFormatError: If the name is none for a file in the folder.
    """
    if form not in FORMS:
        raise ArgumentError(f"no form {form!r}; there are: {', '.join(FORMS)}")
    if not re.fullmatch(r"[\w][\w .()-]{0,80}", name):
        raise ArgumentError(
            f"{name!r} is no name for a take; use letters, digits, blanks and - _ ."
        )
    path = session.folder.place(name.removesuffix(FORMS[form]) + FORMS[form])
    if form == "picture":
        session.jobs.begin(f"drawing {path.name}", lambda job: _picture(session, path, job))
        return
    if not session.stage.begun:
        raise ArgumentError("nothing has been started in this take yet; start an action first")
    scenario, body, skin = session.stage.scenario(), session.stage.body, session.skin
    motions = session.stage.motions

    def work(job: Job) -> None:
        sheet = scenario
        if body is not None:
            carrier = session.folder.place(f"{path.stem}.body.npz")
            save_native(standing_clip(body), carrier)
            sheet = replace(sheet, body=carrier.name)
        _keep_motions(session.folder, scenario, motions)
        _save(session, form, path, sheet, skin, job)
        session.notice(f"saved {path.name}", "saved")
        session.tell({"kind": "changed"})

    session.jobs.begin(f"saving {path.name}", work)


def _keep_motions(folder: WorkFolder, scenario: Scenario, motions: tuple[Motion, ...]) -> None:
    """Write the motions that are in no file: those of a character that a program showed."""
    for entry, motion in zip(scenario.actions, motions, strict=True):
        names = (entry.motion, *entry.others)
        for name, one in zip(names, (motion, *motion.others), strict=True):
            if not name.startswith(SAMPLE) and not (folder.root / name).exists():
                save_native(one.clip, folder.place(name), supports=one.supports)


def _save(
    session: Session,
    form: str,
    path: Path,
    scenario: Scenario,
    skin: SkinnedBody | None,
    job: Job,
) -> None:
    text = scenario_text(scenario)
    if form == "scenario":
        session.folder.write(path.name, text.encode())
        return
    # What is saved is what the scenario file would give, so read it as a file would be.
    scenario = parse_scenario(text, session.folder.root / f"{path.stem}.toml")
    job.report(0.1, "performing the take")
    if form == "page":
        writer = session.page_writer
        if writer is None:
            raise FileFormatError("pages are written by `footfall studio` only", path=path)
        page = writer(scenario)
        job.report(0.9, "writing")
        session.folder.write(path.name, page.encode())
        return
    performance = perform(scenario)
    job.report(0.7, "writing")
    _save_motion(session.folder, performance, path, skin)


def _save_motion(
    folder: WorkFolder, performance: Performance, path: Path, skin: SkinnedBody | None
) -> None:
    clip = performance.recording.to_clip(path.stem)
    supports = played_supports(performance)
    beside = folder.place(supports_path(path).name)
    if path.suffix == ".glb" and skin is not None:
        save_skinned(skin, [clip], path, supports=[support_text(performance.supports)])
    elif path.suffix == ".glb":
        save_gltf(clip, path, supports=support_text(performance.supports))
    else:
        save(clip, path)
    save_supports(supports, beside)


def _picture(session: Session, path: Path, job: Job) -> None:
    job.report(0.2, "asking the latest tab")
    try:
        picture = session.picture(*PICTURE)
    except RuntimeError as error:
        raise FileFormatError(f"cannot be drawn: {error}", path=path) from error
    # It comes with the viewer.
    from imageio.v3 import imwrite  # pyright: ignore[reportUnknownVariableType]

    job.report(0.8, "writing")
    data = io.BytesIO()
    imwrite(data, picture, extension=".png")
    session.folder.write(path.name, data.getvalue())
    session.notice(f"saved {path.name}", "saved")

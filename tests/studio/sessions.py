"""A session without servers, for tests: samples are on its stage, and what tabs hear is kept."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from footfall.studio.session import Session
from footfall.studio.work_folder import WorkFolder


class Heard:
    """What all tabs of a session have been told."""

    def __init__(self) -> None:
        self.messages: list[dict[str, Any]] = []

    def __call__(self, message: dict[str, Any]) -> None:
        self.messages.append(message)

    def kinds(self) -> list[str]:
        return [message["kind"] for message in self.messages]

    def notices(self) -> list[tuple[str, str]]:
        return [
            (message["level"], message["text"])
            for message in self.messages
            if message["kind"] == "notice"
        ]


def session_of(folder: Path, *names: str) -> tuple[Session, Heard]:
    """Return a session with some samples on its stage, and what its tabs hear from now on."""
    heard = Heard()
    session = Session(WorkFolder.at(folder), heard)
    for name in names:
        session.take_in(session.motions.resolve(f"sample:{name}"))
    heard.messages.clear()
    return session, heard

"""Starts the studio: two servers, a session, a clock."""

from __future__ import annotations

import ipaddress
import socket
from collections.abc import Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

from footfall.studio.clock import StudioClock
from footfall.studio.commands import handle
from footfall.studio.exports import PageWriter
from footfall.studio.gaits import GAIT_SAMPLES, load_gait
from footfall.studio.loading import load
from footfall.studio.memory import release_memory
from footfall.studio.motion_list import DEFAULT_SAMPLES, LoadedMotion
from footfall.studio.news import greet
from footfall.studio.page_server import PageServer
from footfall.studio.scene import StudioScene
from footfall.studio.session import Session
from footfall.studio.work_folder import WorkFolder

__all__ = ["Studio"]


class Studio:
    """A studio that is open; close it, or use it in a `with` statement."""

    def __init__(
        self,
        files: Sequence[str | Path] = (),
        *,
        folder: Path | str = ".",
        host: str = "127.0.0.1",
        port: int = 8080,
        page_writer: PageWriter | None = None,
        motions: Sequence[LoadedMotion] = (),
    ) -> None:
        """Open it.

        Args:
            files: Motions to load, files or ``sample:NAME``; by default some samples.
            folder: The only place where anything is written.
            host: Address to bind to.
            port: Of the page, or the first free one after it; the 3D scene takes the next free
                one. 0 for any.
            page_writer: Returns a page that plays a scenario without a network.
            motions: Motions that are loaded already, instead of the samples.

        Raises:
            FileFormatError: If no port is free.
        """
        self.host = host
        self._server: PageServer | None = None
        self.session = Session(WorkFolder.at(folder), self._tell)
        self.session.page_writer = page_writer
        allowed = _own_names(host)
        self._server = PageServer(
            host,
            port,
            allowed,
            handle=lambda message: handle(self.session, message),
            greet=lambda: [{"kind": "scene", "port": self.scene_port}, *greet(self.session)],
        )
        self.scene_port = 0
        self._scene = StudioScene(host, self._server.port + 1 if port else 0, allowed)
        self.scene_port = self._scene.port
        self.session.camera = self._scene.picture
        self.clock = StudioClock(self.session, self._scene)
        self.clock.start()
        for motion in motions:
            self.session.take_in(motion)
        if files or not motions:
            load(self.session, list(files) or [f"sample:{name}" for name in DEFAULT_SAMPLES])
        if not files and not motions:
            load_gait(self.session, "go", GAIT_SAMPLES)

    @property
    def port(self) -> int:
        """Of the page."""
        return 0 if self._server is None else self._server.port

    @property
    def url(self) -> str:
        """Where the page is."""
        shown = "127.0.0.1" if self.host in ("0.0.0.0", "::") else self.host
        return f"http://{f'[{shown}]' if ':' in shown else shown}:{self.port}/"

    def close(self) -> None:
        """Close it."""
        self.clock.stop()
        self.session.close()
        if self._server is not None:
            self._server.stop()
        self._scene.stop()
        release_memory()

    def __enter__(self) -> Studio:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _repr_html_(self) -> str:
        """Return the page inside a frame, for notebooks."""
        return (
            f'<iframe src="{self.url}" title="footfall studio" '
            'style="width:100%;height:720px;border:1px solid #dde1e6;border-radius:8px"></iframe>'
        )

    def _tell(self, message: dict[str, Any]) -> None:
        if self._server is not None:
            self._server.tell(message)


def _own_names(host: str) -> tuple[str, ...]:
    """Return the host names under which a studio that is bound to `host` may be reached."""
    try:
        everywhere = ipaddress.ip_address(host).is_unspecified
    except ValueError:
        everywhere = False
    if not everywhere:
        return (host,)
    name = socket.gethostname()
    try:
        addresses = {str(found[4][0]) for found in socket.getaddrinfo(name, None)}
    except OSError:
        addresses = set[str]()
    return (name, *sorted(addresses))

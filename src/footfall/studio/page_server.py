"""Serves the page and speaks with it: files of the package, and one web socket a tab."""

from __future__ import annotations

import asyncio
import json
import logging
import threading
from collections.abc import Callable
from http import HTTPStatus
from importlib import resources
from typing import Any, cast

from websockets.asyncio.server import Server, ServerConnection, broadcast, serve
from websockets.datastructures import Headers
from websockets.exceptions import ConnectionClosed
from websockets.http11 import Request, Response

from footfall.errors import FileFormatError
from footfall.studio.origins import is_own_host, is_own_origin

__all__ = ["PageServer"]

KINDS = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
}

SOCKET = "/session"

FRAMES = "frame-ancestors 'self' http://localhost:* http://127.0.0.1:* vscode-webview:"
"""Who may show the page inside another one: notebooks of this machine."""

MOST_PORTS = 50
"""How many ports are tried, the first one counted up."""

LONGEST_MESSAGE = 64 * 1024
"""What a page has to say is short [bytes]."""

Handler = Callable[[dict[str, Any]], list[dict[str, Any]]]


class PageServer:
    """A server in a thread of its own."""

    def __init__(
        self,
        host: str,
        port: int,
        allowed: tuple[str, ...],
        *,
        handle: Handler,
        greet: Callable[[], list[dict[str, Any]]],
    ) -> None:
        """Serve the page.

        Args:
            host: Address to bind to.
            port: The port, or the first free one after it; 0 for any.
            allowed: Host names under which it may be reached.
            handle: Takes what a tab says, and returns what it is answered.
            greet: Returns what a new tab is told.

        Raises:
            FileFormatError: If none of the ports is free.
        """
        self._host, self._wanted, self._allowed = host, port, allowed
        self._handle, self._greet = handle, greet
        self._tabs: set[ServerConnection] = set()
        self._loop = asyncio.new_event_loop()
        self._ready = threading.Event()
        self._failure = ""
        self.port = 0
        self._thread = threading.Thread(target=self._run, name="studio-page", daemon=True)
        self._thread.start()
        self._ready.wait()
        if self._failure:
            raise FileFormatError(self._failure, path=f"{host}:{port}")

    @property
    def tabs(self) -> int:
        """How many are open."""
        return len(self._tabs)

    def tell(self, message: dict[str, Any]) -> None:
        """Tell all tabs something; from any thread."""
        if self._tabs and not self._loop.is_closed():
            text = json.dumps(message, separators=(",", ":"))
            self._loop.call_soon_threadsafe(self._broadcast, text)

    def stop(self) -> None:
        """Serve no more."""
        self._loop.call_soon_threadsafe(self._stopping.set)
        self._thread.join(timeout=5.0)

    def _broadcast(self, text: str) -> None:
        broadcast(self._tabs, text)

    def _run(self) -> None:
        asyncio.set_event_loop(self._loop)
        try:
            self._loop.run_until_complete(self._serve())
        finally:
            self._loop.close()
            self._ready.set()

    async def _serve(self) -> None:
        self._stopping = asyncio.Event()
        server = await self._bound()
        if server is None:
            self._failure = "no port is free from here on; choose another one"
            return
        async with server:
            self.port = next(iter(server.sockets)).getsockname()[1]
            self._ready.set()
            await self._stopping.wait()

    async def _bound(self) -> Server | None:
        logger = logging.getLogger("footfall.studio")
        # A browser that goes away in the middle of a handshake is no event.
        logger.setLevel(logging.CRITICAL)
        for port in range(self._wanted, self._wanted + (MOST_PORTS if self._wanted else 1)):
            try:
                return await serve(
                    self._tab,
                    self._host,
                    port,
                    process_request=self._answer,
                    compression=None,
                    max_size=LONGEST_MESSAGE,
                    logger=logger,
                )
            except OSError:
                continue
        return None

    def _answer(self, connection: ServerConnection, request: Request) -> Response | None:
        """Answer a request for a file; let one for the socket pass."""
        del connection
        host, origin = request.headers.get("Host"), request.headers.get("Origin")
        path = request.path.partition("?")[0]
        if path == SOCKET:
            if not is_own_origin(origin, host, self._allowed):
                return _response(HTTPStatus.FORBIDDEN, b"foreign origin\n")
            return None
        if not is_own_host(host, self._allowed):
            return _response(HTTPStatus.FORBIDDEN, b"foreign host\n")
        name = "index.html" if path == "/" else path[1:]
        # Names of the package's own files only: no path of the disk is ever formed.
        pages = resources.files("footfall.studio").joinpath("page")
        files = {entry.name: entry for entry in pages.iterdir()}
        kind = KINDS.get(name[name.rfind(".") :])
        if name not in files or kind is None:
            return _response(HTTPStatus.NOT_FOUND, b"there is no such page\n")
        return _response(HTTPStatus.OK, files[name].read_bytes(), kind)

    async def _tab(self, connection: ServerConnection) -> None:
        for message in self._greet():
            await connection.send(json.dumps(message, separators=(",", ":")))
        self._tabs.add(connection)
        try:
            async for text in connection:
                for answer in self._heard(text):
                    await connection.send(json.dumps(answer, separators=(",", ":")))
        except ConnectionClosed:
            pass
        finally:
            self._tabs.discard(connection)

    def _heard(self, text: str | bytes) -> list[dict[str, Any]]:
        try:
            message: Any = json.loads(text)
        except ValueError:
            message = None
        if not isinstance(message, dict):
            return [{"kind": "notice", "level": "error", "text": "a message is a JSON object"}]
        return self._handle(cast(dict[str, Any], message))


def _response(status: HTTPStatus, body: bytes, kind: str = "text/plain; charset=utf-8") -> Response:
    headers = Headers(
        {
            "Content-Type": kind,
            "Content-Length": str(len(body)),
            "Cache-Control": "no-store",
            "X-Content-Type-Options": "nosniff",
            "Content-Security-Policy": FRAMES,
            "Referrer-Policy": "no-referrer",
            "Connection": "close",
        }
    )
    return Response(status.value, status.phrase, headers, body)

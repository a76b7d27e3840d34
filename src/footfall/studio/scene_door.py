"""The door of the 3D scene: pages of other origins stay outside."""

from __future__ import annotations

from typing import Any

import viser
from viser.infra import WebsockClientConnection

from footfall.studio.origins import is_own_origin

__all__ = ["refuse_foreigners"]


def refuse_foreigners(server: viser.ViserServer, allowed: tuple[str, ...]) -> None:
    """Close the connections of foreign pages before they hear or say anything.

    The library checks no origin, and offers no place for it: its connections are looked up where
    it keeps them.
    """
    socket_server = server._websock_server  # pyright: ignore[reportPrivateUsage]
    connections = socket_server._live_connections  # pyright: ignore[reportPrivateUsage]

    async def check(connection: WebsockClientConnection) -> None:
        socket = connections[connection.client_id]
        request = socket.request
        origin = None if request is None else request.headers.get("Origin")
        host = None if request is None else request.headers.get("Host")
        if not is_own_origin(origin, host, allowed):
            await socket.close(1008, "foreign origin")

    callbacks: list[Any] = socket_server._client_connect_cb  # pyright: ignore
    callbacks.insert(0, check)
    # A page that connected before the check was there connects again, and is checked.
    socket_server.disconnect_all_clients()

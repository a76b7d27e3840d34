"""Who may speak to the studio: its own pages, and no other page that the browser has open.

Any page may open a web socket to a local port, so the browser's ``Origin`` is checked. It must be
the very address that the request went to (``Host``), which a tunnel keeps; and that address must
be one of this machine, so that a foreign name that was made to point here (DNS rebinding) is none.
"""

from __future__ import annotations

import ipaddress
from collections.abc import Iterable
from urllib.parse import urlsplit

__all__ = ["is_own_host", "is_own_origin"]

LOOPBACK_NAMES = frozenset({"localhost"})


def is_own_origin(origin: str | None, host: str | None, allowed: Iterable[str]) -> bool:
    """Whether a request may be served.

    Args:
        origin: Its ``Origin``; None: no page sent it, as browsers always name theirs.
        host: Its ``Host``.
        allowed: Host names under which the studio may be reached, beside those of loopback.
    """
    if not is_own_host(host, allowed):
        return False
    if origin is None:
        return True
    parts = urlsplit(origin)
    return parts.scheme in ("http", "https") and parts.netloc == host


def is_own_host(host: str | None, allowed: Iterable[str]) -> bool:
    """Whether a ``Host`` is an address or a name of this machine."""
    if not host:
        return False
    name = urlsplit(f"//{host}").hostname or ""
    if name in LOOPBACK_NAMES or name in set(allowed):
        return True
    try:
        return ipaddress.ip_address(name).is_loopback
    except ValueError:
        return False

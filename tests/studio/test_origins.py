from __future__ import annotations

import pytest

from footfall.studio.origins import is_own_origin


@pytest.mark.parametrize(
    ("origin", "host"),
    [
        ("http://127.0.0.1:8080", "127.0.0.1:8080"),
        ("http://localhost:9000", "localhost:9000"),
        ("http://[::1]:8080", "[::1]:8080"),
        ("http://studio.example:8080", "studio.example:8080"),
        (None, "127.0.0.1:8080"),
    ],
)
def test_its_own_pages_are_served(origin: str | None, host: str) -> None:
    assert is_own_origin(origin, host, ("studio.example",))


@pytest.mark.parametrize(
    ("origin", "host"),
    [
        ("http://evil.example", "127.0.0.1:8080"),
        ("http://localhost:3000", "localhost:8080"),
        ("http://evil.example:8080", "evil.example:8080"),  # a name made to point here
        ("null", "127.0.0.1:8080"),
        ("file://", "127.0.0.1:8080"),
        ("http://127.0.0.1:8080", None),
        (None, "evil.example"),
        ("http://10.0.0.7:8080", "10.0.0.7:8080"),
    ],
)
def test_other_pages_are_not(origin: str | None, host: str | None) -> None:
    assert not is_own_origin(origin, host, ("studio.example",))

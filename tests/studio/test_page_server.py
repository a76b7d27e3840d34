"""The page's server: its files, one line a tab, and nobody from elsewhere."""

from __future__ import annotations

import http.client
import json
import socket
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any

import pytest

pytest.importorskip("websockets", reason="the extra [studio] is not installed")

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection, connect

from footfall.errors import FileFormatError
from footfall.studio import page_server
from footfall.studio.page_server import LONGEST_MESSAGE, PageServer


def echo(message: dict[str, Any]) -> list[dict[str, Any]]:
    return [{"kind": "echo", "said": message}]


@contextmanager
def serving(port: int = 0) -> Generator[PageServer]:
    server = PageServer(
        "127.0.0.1",
        port,
        ("127.0.0.1",),
        handle=echo,
        greet=lambda: [{"kind": "hello"}],
    )
    try:
        yield server
    finally:
        server.stop()


@contextmanager
def line(server: PageServer) -> Generator[ClientConnection]:
    origin: Any = f"http://127.0.0.1:{server.port}"
    tab: Any = connect(f"ws://127.0.0.1:{server.port}/session", origin=origin)
    with tab:
        yield tab


def heard(tab: ClientConnection) -> Any:
    return json.loads(tab.recv(timeout=10.0))


def answer(server: PageServer, path: str, host: str | None = None) -> http.client.HTTPResponse:
    asked = http.client.HTTPConnection("127.0.0.1", server.port, timeout=10.0)
    asked.request("GET", path, headers={"Host": host or f"127.0.0.1:{server.port}"})
    return asked.getresponse()


def test_a_tab_is_greeted_answered_and_told() -> None:
    with serving() as server, line(server) as one, line(server) as two:
        assert [heard(tab) for tab in (one, two)] == [{"kind": "hello"}] * 2
        one.send('{"do": "x"}')
        assert heard(one) == {"kind": "echo", "said": {"do": "x"}}
        server.tell({"kind": "news"})
        assert [heard(tab) for tab in (one, two)] == [{"kind": "news"}] * 2
        assert server.tabs == 2


def test_a_tab_that_goes_away_is_forgotten() -> None:
    with serving() as server, line(server) as one:
        heard(one)
        with line(server) as two:
            heard(two)
        one.send("{}")
        heard(one)
        for _ in range(100):
            if server.tabs == 1:
                break
            one.send("{}")
            heard(one)
        assert server.tabs == 1


@pytest.mark.parametrize("text", ["", "walk", "[1]", "3", '"do"', "{", b"\xff\xfe"])
def test_what_is_no_object_is_told_and_the_line_stays(text: str | bytes) -> None:
    with serving() as server, line(server) as tab:
        heard(tab)
        tab.send(text)
        told = {"kind": "notice", "level": "error", "text": "a message is a JSON object"}
        assert heard(tab) == told
        tab.send("{}")
        assert heard(tab)["kind"] == "echo"


def test_a_huge_message_ends_its_own_line_only() -> None:
    with serving() as server, line(server) as one, line(server) as two:
        heard(one)
        heard(two)
        one.send('{"do": "' + "x" * LONGEST_MESSAGE + '"}')
        with pytest.raises(ConnectionClosed):
            one.recv(timeout=10.0)
        two.send("{}")
        assert heard(two)["kind"] == "echo"


def test_files_are_served_under_the_own_name_only() -> None:
    with serving() as server:
        for path, kind in (
            ("/", "text/html"),
            ("/main.js", "text/javascript"),
            ("/studio.css?1", "text/css"),
        ):
            got = answer(server, path)
            assert got.status == 200
            assert got.headers["Content-Type"].startswith(kind)
            assert got.headers["Cache-Control"] == "no-store"
            assert "frame-ancestors 'self'" in got.headers["Content-Security-Policy"]
        assert answer(server, "/", host=f"evil.example:{server.port}").status == 403
        for path in ("/page_server.py", "/..%2flaunch.py", "//main.js", "/.", "/page/main.js"):
            assert answer(server, path).status == 404


def test_a_port_in_use_is_passed_over_and_none_free_is_told(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        with serving(port) as server:
            assert server.port > port
        monkeypatch.setattr(page_server, "MOST_PORTS", 1)
        with pytest.raises(FileFormatError) as caught, serving(port):
            pass
        told = f"127.0.0.1:{port}: no port is free from here on; choose another one"
        assert str(caught.value) == told


def test_it_listens_on_its_address_only() -> None:
    with serving() as server, pytest.raises(ConnectionRefusedError):
        socket.create_connection(("127.0.0.2", server.port), timeout=2.0).close()

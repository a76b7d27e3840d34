"""What a studio costs its server while one tab looks: less than half a core."""

from __future__ import annotations

import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest

from footfall.io import save_gltf
from footfall.samples import sample
from footfall.studio import open_studio
from footfall.studio.commands import handle

pytest.importorskip("viser", reason="the extra [studio] is not installed")

TAB = """
import sys, threading
from websockets.sync.client import connect
page, scene = sys.argv[1:]
def drain(address, protocols):
    with connect(address, subprotocols=protocols, max_size=None, compression=None) as line:
        while True:
            line.recv()
threading.Thread(
    target=drain, args=(f"ws://127.0.0.1:{scene}/", ["viser-v1.1.1"]), daemon=True
).start()
drain(f"ws://127.0.0.1:{page}/session", None)
"""
"""Hears everything that a browser would, in a process of its own."""

SECONDS = 6.0


def cores_used() -> float:
    """Return how much processor time passes in this process per second."""
    wall, own = time.perf_counter(), time.process_time()
    time.sleep(SECONDS)
    return (time.process_time() - own) / (time.perf_counter() - wall)


@pytest.mark.full
@pytest.mark.parametrize("what", ["one skinned character at 60 Hz", "500 characters at 30 Hz"])
def test_less_than_half_a_core(tmp_path: Path, what: str) -> None:
    save_gltf(sample("walk")[0], tmp_path / "hero.glb")
    with open_studio(["sample:walk", "sample:run"], folder=tmp_path, port=0) as studio:
        session = studio.session
        session.jobs.wait()
        command = [sys.executable, "-c", TAB, str(studio.port), str(studio.scene_port)]
        tab = subprocess.Popen(command)
        try:
            if what.startswith("one"):
                handle(session, {"do": "body", "name": "hero.glb"})
                session.jobs.wait()
                assert session.skin is not None
                handle(session, {"do": "ghost", "on": True})
                for name in ("walk", "run"):
                    handle(session, {"do": "start", "name": name})
            else:
                handle(session, {"do": "view", "view": "crowd"})
                session.jobs.wait()
                handle(session, {"do": "gather", "size": 500})
                session.jobs.wait()
            time.sleep(3.0)
            before = moments(session)
            used = cores_used()
            rate = (moments(session) - before) / SECONDS
            print(f"{what}: {used:.2f} cores, {rate:.1f} frames a second")
            assert used < 0.5
        finally:
            tab.kill()
            tab.wait()


def moments(session: Any) -> int:
    return session.crowd.frame if session.view == "crowd" else session.stage.performer.frame

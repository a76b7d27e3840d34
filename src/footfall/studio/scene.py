"""What is seen in 3D: the ground, the live body, its ghost and footprints, a clip, a crowd."""

from __future__ import annotations

import contextlib
import io

import numpy as np
import viser

from footfall.adaptation import AnyGround
from footfall.arrays import Positions, Rotations
from footfall.io import SkinnedBody
from footfall.skeleton import Anatomy, Skeleton, leg_length
from footfall.studio.crowd_figures import CrowdFigures
from footfall.studio.figure import Figure
from footfall.studio.footprints import Footprints
from footfall.studio.ground_figures import GroundFigures
from footfall.studio.performer import Performer
from footfall.studio.scene_door import refuse_foreigners
from footfall.studio.skin_figure import SkinFigure

__all__ = ["StudioScene"]

SKY = (238, 241, 245)

QUIET = (
    '<i id="footfall-stage"></i><style>.mantine-Paper-root:has(#footfall-stage),'
    ".mantine-Notifications-root{display:none!important}</style>"
)
"""Takes the library's own panel and notes off the scene: all controls are on the page."""

FOLLOW = 2.5
"""How fast the view follows the body [1/s]."""

CAMERAS = {
    "stage": ((3.1, 1.45, 2.6), (0.0, 0.78, 0.0)),
    "supports": ((2.6, 1.2, 1.9), (0.0, 0.8, 0.0)),
    "crowd": ((15.0, 8.5, 17.0), (0.0, 0.0, 0.0)),
}
"""Where each view is looked from, and what at [m]."""

USUAL_LEG = 0.85
"""Length of a leg that the cameras are meant for [m]."""

FARTHEST_GHOST = 2.5
"""How far from the body it is drawn at most [m]."""

GHOST_ASIDE = -1.1
"""How far beside the body its ghost is drawn, beyond it as seen by the camera [m]."""


class StudioScene:
    """The scene of all tabs.

    Bodies walk away from where they began, so the world hangs under one node that is moved
    against them: the camera stays where its user put it.
    """

    def __init__(self, host: str, port: int, allowed: tuple[str, ...]) -> None:
        """Serve an empty scene.

        Args:
            host: Address to bind to.
            port: The port, or the first free one after it; 0 for any.
            allowed: Host names under which it may be reached.
        """
        # The library prints addresses in a form of its own; the studio prints its ports.
        with contextlib.redirect_stdout(io.StringIO()):
            self.server = viser.ViserServer(host=host, port=port, verbose=False)
        refuse_foreigners(self.server, allowed)
        self.port = self.server.get_port()
        self._scene = self.server.scene
        self._size, self._view = 1.0, "stage"
        self._prepare()
        self._world = self._scene.add_frame("/world", show_axes=False)
        self._ground = GroundFigures(self._scene, "/world/ground")
        self._follows = np.zeros(3)
        self._ghost_shift = np.array([GHOST_ASIDE, 0.0, 0.0])
        self._prints = Footprints(self._scene, "/world/prints")
        self._shown = 0
        self._skins: list[tuple[SkinnedBody, tuple[SkinFigure, SkinFigure]]] = []
        self._figure: Figure | SkinFigure | None = None
        self._ghost: Figure | SkinFigure | None = None
        self._crowd: CrowdFigures | None = None

    def _prepare(self) -> None:
        scene, gui = self._scene, self.server.gui
        scene.set_up_direction("+y")
        scene.configure_environment_map(hdri=None)
        scene.configure_default_lights(enabled=False)
        scene.world_axes.visible = False
        scene.add_light_hemisphere(
            "/sky", sky_color=(255, 255, 255), ground_color=(176, 180, 190), intensity=1.7
        )
        scene.add_light_directional(
            "/sun",
            color=(255, 246, 232),
            intensity=2.0,
            position=(-2.2, 4.0, 2.0),
            cast_shadow=True,
        )
        sky = np.linspace((214, 223, 234), SKY, 64).astype(np.uint8)[:, np.newaxis]
        scene.set_background_image(np.repeat(sky, 8, axis=1))
        gui.configure_theme(show_logo=False, show_share_button=False)
        gui.add_html(QUIET)
        self.look("stage")
        self.server.initial_camera.fov = 0.72

    def look(self, view: str) -> None:
        """Put the camera of every tab where a view is seen best."""
        self._view = view
        size = 1.0 if view == "crowd" else self._size
        position, at = (size * np.array(place) for place in CAMERAS[view])
        self.server.initial_camera.position = position
        self.server.initial_camera.look_at = at
        for client in self.server.get_clients().values():
            client.camera.position = position
            client.camera.look_at = at
        far = 70.0 if view == "crowd" else 30.0
        self._scene.configure_fog(0.3 * far, far, color=SKY)

    def show_body(
        self, skeleton: Skeleton, anatomy: Anatomy, skin: SkinnedBody | None = None
    ) -> None:
        """Replace the body and its ghost; without a skin they are mannequins."""
        for old in (self._figure, self._ghost):
            if old is not None:
                old.remove()
        # A name is used once: what was still on its way to a body that is gone finds none.
        self._shown += 1
        body, ghost = f"/world/body_{self._shown}", f"/world/ghost_{self._shown}"
        if skin is None:
            self._figure = Figure(self._scene, body, skeleton, anatomy)
            self._ghost = Figure(self._scene, ghost, skeleton, anatomy, ghostly=True)
        else:
            self._figure, self._ghost = self._skin_figures(skin, body, ghost)
        self._prints.clear()
        self._zoom(leg_length(skeleton, anatomy.left))
        self._ghost_shift = np.array([self._size * GHOST_ASIDE, 0.0, 0.0])

    def _skin_figures(
        self, skin: SkinnedBody, body: str, ghost: str
    ) -> tuple[SkinFigure, SkinFigure]:
        """Return the figures of a skin; those that were shown before are shown again."""
        for known, figures in self._skins:
            if known is skin:
                return figures
        pair = SkinFigure(self._scene, body, skin), SkinFigure(self._scene, ghost, skin, True)
        self._skins.append((skin, pair))
        return pair

    def _zoom(self, leg: float) -> None:
        """Go back before giants, and near to dwarfs; who is of the size of people is seen so."""
        size = leg / USUAL_LEG
        size = 1.0 if 0.6 < size < 1.5 else size
        if size != self._size:
            self._size = size
            self.look(self._view)

    def show_crowd(self, skeleton: Skeleton, anatomy: Anatomy, size: int) -> None:
        """Replace the crowd."""
        if self._crowd is not None:
            self._crowd.remove()
        self._crowd = CrowdFigures(self._scene, "/world/crowd", skeleton, anatomy, size)

    def pose_body(
        self, positions: Positions, rotations: Rotations, planted: tuple[bool, bool]
    ) -> None:
        """Move the body; see `Figure.pose`."""
        if self._figure is not None:
            self._figure.pose(positions, rotations)
            self._figure.plant(*planted)

    def pose_ghost(self, positions: Positions, rotations: Rotations) -> None:
        """Move the ghost, drawn beside where it is."""
        if self._ghost is not None:
            away = positions[0] + self._ghost_shift - self._follows
            if max(abs(away[0]), abs(away[2])) > self._size * FARTHEST_GHOST:
                # It has gone its own way: it goes on beside the body.
                self._ghost_shift = (self._follows - positions[0]) * np.array([1.0, 0.0, 1.0])
                self._ghost_shift[0] += self._size * GHOST_ASIDE
            self._ghost.pose(positions + self._ghost_shift, rotations)

    def pose_crowd(self, positions: Positions, rotations: Rotations, shifts: Positions) -> None:
        """Move the crowd; see `CrowdFigures.pose`."""
        if self._crowd is not None:
            self._crowd.pose(positions, rotations, shifts)

    @property
    def crowd(self) -> CrowdFigures | None:
        """The crowd that is drawn."""
        return self._crowd

    def print_feet(self, performer: Performer) -> None:
        """Leave footprints; see `Footprints.update`."""
        planted = (performer.support.left, performer.support.right)
        self._prints.update(performer.foot_points, planted, performer.heights, performer.ground)

    def show_ground(self, ground: AnyGround, time: float) -> None:
        """Draw what is stood on as it is at a clock time [s]."""
        self._ground.show(ground, time, self._follows)
        self._prints.ride(ground, time)

    def clear_prints(self) -> None:
        """Clean the ground."""
        self._prints.clear()

    def show_only(self, *, ghost: bool, prints: bool, crowd: bool) -> None:
        """Say what is seen beside the ground; the body is, where no crowd is."""
        for figure, seen in ((self._figure, not crowd), (self._ghost, ghost and not crowd)):
            if figure is not None:
                figure.root.visible = seen
        self._prints.show(prints and not crowd)
        if self._crowd is not None:
            self._crowd.show(crowd)

    def follow(self, place: Positions, dt: float, *, at_once: bool = False) -> None:
        """Bring a place [m] to the middle of the picture, softly, its third part the height."""
        wanted = np.asarray(place, dtype=np.float64)
        share = 1.0 if at_once else 1.0 - float(np.exp(-FOLLOW * dt))
        if float(np.abs(wanted - self._follows).max()) > 4.0:
            share = 1.0
        self._follows += share * (wanted - self._follows)
        self._world.position = -self._follows

    def atomic(self) -> contextlib.AbstractContextManager[None]:
        """Let all that is moved inside be seen at once."""
        return self.server.atomic()

    def picture(self, width: int, height: int) -> np.ndarray[tuple[int, ...], np.dtype[np.uint8]]:
        """Return what the latest tab sees, shape (height, width, 3).

        Raises:
            RuntimeError: If no tab is open.
        """
        clients = self.server.get_clients()
        if not clients:
            raise RuntimeError("no tab is open to draw the picture")
        return clients[max(clients)].get_render(height, width, transport_format="png")

    def stop(self) -> None:
        """Serve no more."""
        with contextlib.redirect_stdout(io.StringIO()):
            self.server.stop()

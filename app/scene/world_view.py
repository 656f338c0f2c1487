"""One role's picture of the world and the chair, on the role's 3D server."""

import math
from collections.abc import ItemsView, Mapping, Sequence, ValuesView
from dataclasses import dataclass
from typing import Final

import numpy as np
import viser

from app.geometry import Pose
from app.scene.cameras import (
    FIELD_OF_VIEW,
    NEAREST,
    Bounds,
    Camera,
    EyeSettings,
    Orbit,
    Placement,
    View,
    chair_placement,
    chase_camera,
    eye_camera,
    first_orbit,
    free_camera,
    top_camera,
    world_placement,
)
from app.scene.head_view import AHEAD, Angles, HeadView
from app.scene.lighting import Lighting
from app.scene.meshes.bodies import Part
from app.scene.meshes.building import FURNITURE, OVERHEAD, WALLS, BuildingParts
from app.scene.meshes.paint import PaintedPart, unlit_glb
from app.scene.meshes.wheelchair import chair_parts, person_parts
from app.scene.scene_state import SceneState
from app.world.scenery import Lights

MeshNode = viser.MeshHandle | viser.GlbHandle


class MeshGroup:
    """The meshes under one node of a 3D server's scene."""

    def __init__(self, server: viser.ViserServer, under: str) -> None:
        self._server = server
        self._under = under
        self._nodes: dict[str, MeshNode] = {}
        self._parts: Mapping[str, Part | PaintedPart] = {}

    def __contains__(self, name: str) -> bool:
        """Return whether the group has a mesh of this name."""
        return name in self._nodes

    def __getitem__(self, name: str) -> MeshNode:
        """Return one of the meshes."""
        return self._nodes[name]

    def items(self) -> ItemsView[str, MeshNode]:
        """Return names and meshes."""
        return self._nodes.items()

    def values(self) -> ValuesView[MeshNode]:
        """Return the meshes."""
        return self._nodes.values()

    def show(self, parts: Mapping[str, Part | PaintedPart]) -> bool:
        """Replace the meshes by `parts`; return whether `parts` is another object than the one drawn before.

        When names, colours and faces are equal, only the vertices of the existing meshes are changed: a new mesh would
        blink.
        """
        if parts is self._parts:
            return False
        moved = self._moved_meshes(parts)
        if moved is None:
            for node in self._nodes.values():
                node.remove()
            self._nodes = {name: self._add(f"{self._under}/{name}", part) for name, part in parts.items()}
        else:
            for node, part in moved:
                node.vertices = part.mesh.vertices.astype(np.float32)
        self._parts = parts
        return True

    def _moved_meshes(self, parts: Mapping[str, Part | PaintedPart]) -> list[tuple[viser.MeshHandle, Part]] | None:
        """Return the meshes on the server with the parts that replace them, when these differ in their vertices only.

        Returns None when anything else differs.
        """
        if self._parts.keys() != parts.keys():
            return None
        moved = []
        for name, part in parts.items():
            before, node = self._parts[name], self._nodes[name]
            if not (isinstance(part, Part) and isinstance(before, Part) and isinstance(node, viser.MeshHandle)):
                return None
            if part.colour != before.colour or not np.array_equal(part.mesh.faces, before.mesh.faces):
                return None
            moved.append((node, part))
        return moved

    def _add(self, name: str, part: Part | PaintedPart) -> MeshNode:
        scene = self._server.scene
        if isinstance(part, PaintedPart):
            return scene.add_glb(name, unlit_glb(part), cast_shadow=False, receive_shadow=False)
        return scene.add_mesh_simple(
            name, part.mesh.vertices, part.mesh.faces, color=part.colour, cast_shadow=False, receive_shadow=False
        )


WALL_CUT_HEIGHT: Final[dict[View, float]] = {"eye": math.inf, "chase": 1.1, "top": 0.5, "free": 1.1}
"""Height (m) at which walls are cut, so that they hide less."""
FURNITURE_HEIGHT_SHARE: Final[dict[View, float]] = {"eye": 1.0, "chase": 1.0, "top": 0.25, "free": 1.0}
"""Share of the furniture's height that is drawn; in the view from the top, tall furniture would lean outwards."""
UPRIGHT: Final = ("flag", "mark")  # of a task; not shown in the view from the top
EMPTY: Final[Bounds] = (-5.0, -5.0, 5.0, 5.0)  # without a floor plan
LANDSCAPE = 4 / 3  # width over height of a picture whose size is not known yet
FARTHEST: Final = 700.0  # m, far plane
DEFAULT_LIGHTS: Final = Lights()


@dataclass(frozen=True, slots=True)
class DrawnPlan:
    """The drawing of a plan, made once for all roles."""

    building: BuildingParts
    movers: Sequence[list[Part]]
    bounds: Bounds = EMPTY
    wall_height: float = 0.0
    lights: Lights = DEFAULT_LIGHTS
    start: Pose | None = None


class WorldView:
    """One role's picture of the world. Changes are sent at the server's next `flush`."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._view: View = "eye"
        self._settings = EyeSettings()
        self._head = HeadView()
        self._angles = AHEAD
        self._pose = Pose(0.0, 0.0, 0.0)
        self._aspect = LANDSCAPE
        self._drawing = DrawnPlan({}, ())
        self._orbit: Orbit | None = None  # None until the free camera is moved
        scene = server.scene
        self._world = scene.add_frame("/world", show_axes=False)
        self._chair = scene.add_frame("/world/chair", show_axes=False)
        self._lighting = Lighting(server)
        self._building = MeshGroup(server, "/world")
        self._task = MeshGroup(server, "/world")
        self._cones = MeshGroup(server, "/world")
        self._movers: list[viser.FrameHandle] = []
        self._bodies = MeshGroup(server, "/world/chair")
        bodies = [
            Part(mesh, colour) for parts in (chair_parts(), person_parts()) for colour, mesh in sorted(parts.items())
        ]
        self._bodies.show(numbered("body", bodies))
        self._fix_camera()
        server.on_client_connect(self._aim_client)
        self.set_view("eye")

    @property
    def view(self) -> View:
        """The view of this role."""
        return self._view

    @property
    def settings(self) -> EyeSettings:
        """The settings of this role's eye."""
        return self._settings

    @property
    def orbit(self) -> Orbit:
        """The orbit of this role's free camera."""
        return self._orbit or first_orbit(self._drawing.bounds, self._drawing.start, self._aspect)

    def draw(self, drawing: DrawnPlan) -> None:
        """Draw a plan: building, movers and lights."""
        with self._server.atomic():
            self._building.show(drawing.building)
            if drawing is not self._drawing:
                self._orbit = None
                self._show_movers(drawing.movers)
            self._drawing = drawing
            self._lighting.shine(drawing.lights)
            self.set_view(self._view)

    def set_view(self, view: View, settings: EyeSettings | None = None) -> None:
        """Set the view, and the eye's settings when given."""
        self._view = view
        self._settings = self._settings if settings is None else settings
        self._head.roll_share = self._settings.roll_share
        height = self._drawing.wall_height
        with self._server.atomic():
            cut_share = min(WALL_CUT_HEIGHT[view] / height, 1.0) if height else 1.0
            for name, node in self._building.items():
                if name == WALLS:
                    node.scale = (1.0, 1.0, cut_share)
                elif name.startswith(FURNITURE):
                    node.scale = (1.0, 1.0, FURNITURE_HEIGHT_SHARE[view])
                elif name == OVERHEAD:
                    node.visible = view == "eye"
            for body in self._bodies.values():
                body.visible = view != "eye"
            self._hide_upright()
            self._server.initial_camera.fov = self._field_of_view()
            self._server.initial_camera.near = NEAREST[view]
            for client in self._server.get_clients().values():
                self._aim(client)
            self._place()

    def turn_free(self, orbit: Orbit) -> None:
        """Set the orbit of the free camera."""
        self._orbit = orbit
        if self._view == "free":
            self._place()

    def follow(self, pose: Pose, dt: float, head: Angles, head_age: float, state: SceneState) -> None:
        """Update chair, head, movers, task and cones together to a moment `dt` (s) after the last one."""
        age = head_age if self._settings.head else math.inf
        self._angles = self._head.step(dt, *head, age)
        self._pose = pose
        with self._server.atomic():
            place_node(self._chair, chair_placement(pose))
            for node, place in zip(self._movers, state.movers(), strict=True):
                place_node(node, chair_placement(place))
            if self._task.show(state.task):
                self._hide_upright()
            self._cones.show(state.cones.parts())
            self._place()

    def fit_picture(self) -> None:
        """Fit the view to the narrowest of the clients' pictures."""
        shapes = [
            client.camera.image_width / client.camera.image_height
            for client in self._server.get_clients().values()
            if client.camera.image_height > 0 and client.camera.image_width > 0
        ]
        aspect = min(shapes, default=LANDSCAPE)
        if aspect != self._aspect:
            self._aspect = aspect
            self._place()

    def _place(self) -> None:
        with self._server.atomic():
            place_node(self._world, world_placement(self._camera()))

    def _camera(self) -> Camera:
        match self._view:
            case "eye":
                return eye_camera(self._pose, self._angles, self._settings.eye_height)
            case "chase":
                return chase_camera(self._pose)
            case "top":
                cut_height = min(WALL_CUT_HEIGHT["top"], self._drawing.wall_height)
                return top_camera(self._drawing.bounds, self._aspect, cut_height)
            case "free":
                return free_camera(self.orbit)

    def _field_of_view(self) -> float:
        return math.radians(self._settings.fov_deg) if self._view == "eye" else FIELD_OF_VIEW[self._view]

    def _show_movers(self, movers: Sequence[list[Part]]) -> None:
        for frame in self._movers:
            frame.remove()
        self._movers = []
        for number, parts in enumerate(movers):
            name = f"/world/mover_{number}"
            self._movers.append(self._server.scene.add_frame(name, show_axes=False))
            MeshGroup(self._server, name).show(numbered("body", parts))

    def _hide_upright(self) -> None:
        for name in UPRIGHT:
            if name in self._task:
                self._task[name].visible = self._view != "top"

    def _fix_camera(self) -> None:
        """Set viser's camera to the origin, looking along x: the world is moved in front of it."""
        camera = self._server.initial_camera
        camera.position = (0.0, 0.0, 0.0)
        camera.look_at = (1.0, 0.0, 0.0)
        camera.up = (0.0, 0.0, 1.0)
        camera.far = FARTHEST

    def _aim_client(self, client: viser.ClientHandle) -> None:
        # The view may have changed between the client's first message and this call.
        self._aim(client)
        self.fit_picture()

    def _aim(self, client: viser.ClientHandle) -> None:
        client.camera.fov = self._field_of_view()
        client.camera.near = NEAREST[self._view]


def numbered(name: str, parts: list[Part]) -> dict[str, Part]:
    """Return parts by names made of `name` and their number."""
    return {f"{name}_{number}": part for number, part in enumerate(parts)}


def place_node(node: viser.SceneNodeHandle, placement: Placement) -> None:
    """Set the orientation and the position of a node.

    Viser compares what it is given with what it has, which takes much longer than to compare numbers; most of the time
    nothing moves, and this is called sixty times a second for each node.
    """
    if tuple(node.wxyz) != tuple(placement.wxyz):
        node.wxyz = placement.wxyz
    if tuple(node.position) != tuple(placement.position):
        node.position = placement.position

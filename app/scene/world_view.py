"""The building and the chair on one 3D server: what is drawn, and where it stands at the moment."""

import math
from typing import Final

import viser

from app.geometry import Pose
from app.scene.building import FURNITURE, WALLS, building_parts, path_parts
from app.scene.meshes import Mesh, Part
from app.scene.palette import Colour
from app.scene.views import (
    FIELD_OF_VIEW,
    Bounds,
    Placement,
    View,
    chair_placement,
    chase_camera,
    eye_camera,
    top_camera,
    world_placement,
)
from app.scene.wheelchair import chair_parts, person_parts
from app.world.floorplan import FloorPlan

WALLS_SHOWN: Final[dict[View, float]] = {"eye": math.inf, "chase": 1.1, "top": 0.5}  # m: cut low, so that one sees over
FURNITURE_SHOWN: Final[dict[View, float]] = {"eye": 1.0, "chase": 1.0, "top": 0.25}  # of its height: nothing leans far
EMPTY: Final[Bounds] = (-5.0, -5.0, 5.0, 5.0)  # of a place without a floor plan
SUN: Final = (-3000.0, -5000.0, 9000.0)  # so far away that its direction stays the same while the world moves
LANDSCAPE = 4 / 3  # of a picture whose size is not known yet

MeshNode = viser.MeshHandle


class WorldView:
    """One role's picture of the world."""

    def __init__(self, server: viser.ViserServer) -> None:
        self._server = server
        self._view: View = "eye"
        self._pose = Pose(0.0, 0.0, 0.0)
        self._aspect = LANDSCAPE
        self._bounds = EMPTY
        self._wall_height = 0.0
        self._plan: FloorPlan | None = None
        self._path_name: str | None = None
        self._building: dict[str, MeshNode] = {}
        self._path: dict[str, MeshNode] = {}
        scene = server.scene
        self._world = scene.add_frame("/world", show_axes=False)
        self._chair = scene.add_frame("/world/chair", show_axes=False)
        _add_lights(server)
        bodies = {"chair": chair_parts(), "person": person_parts()}
        self._bodies = [
            _add(server, f"/world/chair/{name}_{number}", Part(mesh, colour))
            for name, parts in bodies.items()
            for number, (colour, mesh) in enumerate(_in_order(parts))
        ]
        self._camera_stands_still()
        server.on_client_connect(self._aim_client)
        self.look("eye")

    @property
    def view(self) -> View:
        """Return where this role looks from."""
        return self._view

    def show(self, plan: FloorPlan | None, path_name: str | None) -> None:
        """Draw a floor plan and one of its paths, or nothing.

        Raises
        ------
        ValueError
            When the plan has no path of this name; the picture stays as it was.
        """
        path = None if plan is None or path_name is None else plan.path_named(path_name)
        with self._server.atomic():
            if plan != self._plan:
                self._remove(self._building)
                if plan is not None:
                    parts = building_parts(plan)
                    self._building = {name: _add(self._server, f"/world/{name}", part) for name, part in parts.items()}
            self._remove(self._path)
            if path is not None:
                self._path = {
                    name: _add(self._server, f"/world/{name}", part) for name, part in path_parts(path).items()
                }
            self._plan, self._path_name = plan, path_name
            self._bounds = EMPTY if plan is None else plan.bounds
            self._wall_height = 0.0 if plan is None else plan.wall_height
            self.look(self._view)

    def look(self, view: View) -> None:
        """Look from somewhere else."""
        self._view = view
        with self._server.atomic():
            shown = min(WALLS_SHOWN[view] / self._wall_height, 1.0) if self._wall_height else 1.0
            for name, node in self._building.items():
                if name in WALLS:
                    node.scale = (1.0, 1.0, shown)
                elif name.startswith(FURNITURE):
                    node.scale = (1.0, 1.0, FURNITURE_SHOWN[view])
            for name in ("door_frames", "lintels"):
                if name in self._building:
                    self._building[name].visible = view == "eye"
            if "flag" in self._path:
                self._path["flag"].visible = view != "top"
            for body in self._bodies:
                body.visible = view != "eye"
            self._server.initial_camera.fov = FIELD_OF_VIEW[view]
            for client in self._server.get_clients().values():
                client.camera.fov = FIELD_OF_VIEW[view]
            self.place(self._pose)

    def place(self, pose: Pose) -> None:
        """Put the chair somewhere; call `flush` on the server when everything of this moment is done."""
        self._pose = pose
        with self._server.atomic():
            _put(self._chair, chair_placement(pose))
            _put(self._world, self._world_placement())

    def fit_picture(self) -> None:
        """Take over the shape of the clients' pictures: the plan seen from the top must fit into the narrowest."""
        shapes = [
            client.camera.image_width / client.camera.image_height
            for client in self._server.get_clients().values()
            if client.camera.image_height > 0 and client.camera.image_width > 0
        ]
        aspect = min(shapes, default=LANDSCAPE)
        if aspect != self._aspect:
            self._aspect = aspect
            if self._view == "top":
                self.place(self._pose)

    def _world_placement(self) -> Placement:
        if self._view == "top":
            shown = min(WALLS_SHOWN["top"], self._wall_height)
            return world_placement(top_camera(self._bounds, self._aspect, shown))
        return world_placement(eye_camera(self._pose) if self._view == "eye" else chase_camera(self._pose))

    def _camera_stands_still(self) -> None:
        """Keep the camera at the origin, looking along x: the world is moved in front of it."""
        camera = self._server.initial_camera
        camera.position = (0.0, 0.0, 0.0)
        camera.look_at = (1.0, 0.0, 0.0)
        camera.up = (0.0, 0.0, 1.0)
        camera.near = 0.05  # m
        camera.far = 400.0

    def _aim_client(self, client: viser.ClientHandle) -> None:
        # The view may have changed between the page's first message and its being counted as connected.
        client.camera.fov = FIELD_OF_VIEW[self._view]
        self.fit_picture()

    def _remove(self, nodes: dict[str, MeshNode]) -> None:
        for node in nodes.values():
            node.remove()
        nodes.clear()


def _in_order(parts: dict[Colour, Mesh]) -> list[tuple[Colour, Mesh]]:
    return sorted(parts.items())


def _add(server: viser.ViserServer, name: str, part: Part) -> MeshNode:
    return server.scene.add_mesh_simple(
        name, part.mesh.vertices, part.mesh.faces, color=part.colour, cast_shadow=False, receive_shadow=False
    )


def _put(node: viser.SceneNodeHandle, placement: Placement) -> None:
    node.wxyz = placement.wxyz
    node.position = placement.position


def _add_lights(server: viser.ViserServer) -> None:
    # They hang under the world so that a wall keeps its shade while the chair turns.
    server.scene.add_light_hemisphere(
        "/world/sky", sky_color=(255, 255, 255), ground_color=(206, 208, 200), intensity=3.2
    )
    server.scene.add_light_directional("/world/sun", color=(255, 250, 240), intensity=2.2, position=SUN)

"""Groups of meshes on a 3D server, each shown and replaced together."""

from collections.abc import ItemsView, Mapping, ValuesView

import numpy as np
import viser

from app.scene.cameras import Placement
from app.scene.meshes.bodies import Part

MeshNode = viser.MeshHandle


class MeshGroup:
    """The meshes under one node of a 3D server's scene."""

    def __init__(self, server: viser.ViserServer, under: str) -> None:
        self._server = server
        self._under = under
        self._nodes: dict[str, MeshNode] = {}
        self._shown: Mapping[str, Part] = {}

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

    def show(self, parts: Mapping[str, Part]) -> bool:
        """Replace the meshes by `parts`; return whether `parts` is another object than the one shown before.

        When names, colours and faces are equal, only the vertices of the existing meshes are changed: a new mesh would
        blink.
        """
        if parts is self._shown:
            return False
        if self._differ_in_vertices_only(parts):
            for name, part in parts.items():
                self._nodes[name].vertices = part.mesh.vertices.astype(np.float32)
        else:
            for node in self._nodes.values():
                node.remove()
            self._nodes = {name: self._add(f"{self._under}/{name}", part) for name, part in parts.items()}
        self._shown = parts
        return True

    def _differ_in_vertices_only(self, parts: Mapping[str, Part]) -> bool:
        return self._shown.keys() == parts.keys() and all(
            part.colour == self._shown[name].colour and np.array_equal(part.mesh.faces, self._shown[name].mesh.faces)
            for name, part in parts.items()
        )

    def _add(self, name: str, part: Part) -> MeshNode:
        return self._server.scene.add_mesh_simple(
            name, part.mesh.vertices, part.mesh.faces, color=part.colour, cast_shadow=False, receive_shadow=False
        )


def numbered(name: str, parts: list[Part]) -> dict[str, Part]:
    """Return parts by names made of `name` and their number."""
    return {f"{name}_{number}": part for number, part in enumerate(parts)}


def place_node(node: viser.SceneNodeHandle, placement: Placement) -> None:
    """Set the orientation and the position of a node."""
    node.wxyz = placement.wxyz
    node.position = placement.position

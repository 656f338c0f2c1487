"""Groups of meshes on a 3D server, each shown and replaced together."""

from collections.abc import ItemsView, Mapping, ValuesView

import numpy as np
import viser

from app.scene.cameras import Placement
from app.scene.meshes.bodies import Part
from app.scene.meshes.paint import PaintedPart
from app.scene.unlit_glb import unlit_glb

MeshNode = viser.MeshHandle | viser.GlbHandle


class MeshGroup:
    """The meshes under one node of a 3D server's scene."""

    def __init__(self, server: viser.ViserServer, under: str) -> None:
        self._server = server
        self._under = under
        self._nodes: dict[str, MeshNode] = {}
        self._shown: Mapping[str, Part | PaintedPart] = {}

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
        """Replace the meshes by `parts`; return whether `parts` is another object than the one shown before.

        When names, colours and faces are equal, only the vertices of the existing meshes are changed: a new mesh would
        blink.
        """
        if parts is self._shown:
            return False
        moved = self._moved_meshes(parts)
        if moved is None:
            for node in self._nodes.values():
                node.remove()
            self._nodes = {name: self._add(f"{self._under}/{name}", part) for name, part in parts.items()}
        else:
            for node, part in moved:
                node.vertices = part.mesh.vertices.astype(np.float32)
        self._shown = parts
        return True

    def _moved_meshes(self, parts: Mapping[str, Part | PaintedPart]) -> list[tuple[viser.MeshHandle, Part]] | None:
        """Return the meshes on the server with the parts that replace them, when these differ in their vertices only.

        Returns None when anything else differs.
        """
        if self._shown.keys() != parts.keys():
            return None
        moved = []
        for name, part in parts.items():
            before, node = self._shown[name], self._nodes[name]
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

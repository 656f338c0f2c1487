"""A GLB file in another scale, by a node above its scene."""

import json

from app.scene.models.glb_document import chunks, packed


def scaled_glb(content: bytes, scale: float) -> bytes:
    """Return a GLB file that is valid, `scale` times as large; only its default scene is kept."""
    description, body = chunks(content)
    document = json.loads(description)
    nodes = document.get("nodes", [])
    below = {child for node in nodes for child in node.get("children", [])}
    scenes = document.get("scenes") or [{"nodes": [number for number in range(len(nodes)) if number not in below]}]
    scene = scenes[document.get("scene") or 0]
    whole = {"name": "in metres", "children": scene.get("nodes", []), "scale": [scale] * 3}
    changed = {"nodes": [*nodes, whole], "scenes": [scene | {"nodes": [len(nodes)]}], "scene": 0}
    return packed(document | changed, body)

"""The mesh of a boulder: a ball cut by planes that are chosen at random from its place."""

import numpy as np

from app.scene.meshes.bodies import Mesh, ball

CUTS = 14
SUNK = 0.3  # share of the half height that is below the floor, so that the boulder does not stand on a point
SIDES = 12


def rock(radius: float, height: float, seed: tuple[float, float]) -> Mesh:
    """Return a boulder that fits exactly into a cylinder of `radius` and `height`.

    Parameters
    ----------
    radius, height
        Size, m.
    seed
        The boulder's place in the plan (m), so that it looks the same each time.
    """
    rng = np.random.default_rng([int(1000 * abs(value)) for value in seed])
    whole = ball((0.0, 0.0, 0.0), 1.0, SIDES)
    points = whole.vertices.copy()
    planes = rng.normal(size=(CUTS, 3))
    planes /= np.linalg.norm(planes, axis=1)[:, np.newaxis]
    for plane, depth in zip(planes, rng.uniform(0.68, 0.95, CUTS), strict=True):
        reach = points @ plane
        points *= np.where(reach > depth, depth / np.maximum(reach, depth), 1.0)[:, np.newaxis]
    points[:, :2] *= radius / np.hypot(points[:, 0], points[:, 1]).max()
    points[:, 2] = height * (points[:, 2] + SUNK) / (points[:, 2].max() + SUNK)
    faces = whole.faces[np.linalg.norm(_normals(points, whole.faces), axis=1) > 1e-9]
    # Each face has its own points, so that edges look sharp.
    return Mesh(points[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3))


def _normals(points: np.ndarray, faces: np.ndarray) -> np.ndarray:
    """Return a normal of each face (m, 3), its length twice the face's area."""
    a, b, c = (points[faces[:, corner]] for corner in range(3))
    normals: np.ndarray = np.cross(b - a, c - a)
    return normals

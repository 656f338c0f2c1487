"""A boulder: a ball that was broken along some planes, so that no two look alike."""

import numpy as np

from app.scene.meshes.bodies import Mesh, ball

CUTS = 14
SUNK = 0.3  # of its half height: it does not balance on a point
SIDES = 12


def rock(radius: float, height: float, seed: tuple[float, float]) -> Mesh:
    """Return a boulder that stays inside a circle of `radius` and under `height` (m) and touches both.

    Parameters
    ----------
    radius, height
        Size, m.
    seed
        Its place in the plan (m): a rock looks the same each time.
    """
    chance = np.random.default_rng([int(1000 * abs(value)) for value in seed])
    whole = ball((0.0, 0.0, 0.0), 1.0, SIDES)
    points = whole.vertices.copy()
    planes = chance.normal(size=(CUTS, 3))
    planes /= np.linalg.norm(planes, axis=1)[:, np.newaxis]
    for plane, depth in zip(planes, chance.uniform(0.68, 0.95, CUTS), strict=True):
        reach = points @ plane
        points *= np.where(reach > depth, depth / np.maximum(reach, depth), 1.0)[:, np.newaxis]
    points[:, :2] *= radius / np.hypot(points[:, 0], points[:, 1]).max()
    points[:, 2] = height * (points[:, 2] + SUNK) / (points[:, 2].max() + SUNK)
    faces = whole.faces[np.linalg.norm(_across(points, whole.faces), axis=1) > 1e-9]
    # Each face has points of its own, so that its edges look broken.
    return Mesh(points[faces].reshape(-1, 3), np.arange(3 * len(faces)).reshape(-1, 3))


def _across(points: np.ndarray, faces: np.ndarray) -> np.ndarray:
    a, b, c = (points[faces[:, corner]] for corner in range(3))
    crossed: np.ndarray = np.cross(b - a, c - a)
    return crossed

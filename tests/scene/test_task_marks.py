import math

import numpy as np
import pytest

from app.scene.task_marks import BOX, GAP_MARK, SPOT, gap_parts, later_parts, task_parts
from app.world.floorplan import PrescribedPath
from app.world.scenery import Gap
from app.world.tasks import Back, Course, Stage, Turn


def path(task, points=((1.0, 2.0), (1.0, 5.0)), start_heading=None):
    return PrescribedPath(
        name="one", title="One", points=points, instruction="Do.", task=task, start_heading=start_heading
    )


def looks_up(mesh):
    a, b, c = (mesh.vertices[mesh.faces[:, corner], :2] for corner in range(3))
    (ux, uy), (vx, vy) = (b - a).T, (c - a).T
    return (ux * vy - uy * vx > -1e-12).all()


@pytest.mark.parametrize(
    ("direction", "start", "swept"),
    [("left", 0.0, math.pi / 2), ("right", 0.0, 3 * math.pi / 2), ("right", math.pi, math.pi / 2)],
)
def test_a_turn_shows_the_spot_the_mark_and_an_arrow_in_the_asked_direction(direction, start, swept):
    parts = task_parts(path(Turn(kind="turn", direction=direction), start_heading=start))
    away = parts["goal"].mesh.vertices[:, :2] - (1.0, 2.0)
    assert np.hypot(*away.T).max() == pytest.approx(SPOT)
    mark = parts["mark"].mesh.vertices
    assert mark[:, :2].mean(axis=0) == pytest.approx([1.0, 5.0], abs=0.01)
    assert looks_up(parts["path"].mesh)
    arrow = parts["path"].mesh.vertices[:, :2] - (1.0, 2.0)
    sign = 1 if direction == "left" else -1
    turned = sign * (np.arctan2(arrow[:, 1], arrow[:, 0]) - start) % math.tau
    turned[turned > swept + 0.3] -= math.tau  # a little before the beginning
    assert turned.min() > -0.1
    assert turned.max() == pytest.approx(swept, abs=0.1)


def test_the_box_to_back_into_lies_at_the_end_along_the_way():
    mesh = task_parts(path(Back(kind="back")))["goal"].mesh
    assert looks_up(mesh)
    low, high = mesh.vertices[:, :2].min(axis=0), mesh.vertices[:, :2].max(axis=0)
    assert (low + high) / 2 == pytest.approx([1.0, 5.0])
    assert high - low == pytest.approx([BOX[1], BOX[0]], abs=0.06)


def test_a_course_shows_its_stages_faintly_and_other_tasks_nothing():
    stages = (
        Stage(title="A", instruction="Drive.", points=((0, 0), (4, 0))),
        Stage(title="B", instruction="Turn.", points=((4, 0), (4, 3)), task=Turn(kind="turn", direction="left")),
        Stage(title="C", instruction="Back.", points=((4, 0), (4, -2)), task=Back(kind="back")),
    )
    (part,) = later_parts(path(Course(kind="course", stages=stages))).values()
    assert part.mesh.vertices[:, 1].max() < 1
    assert part.mesh.vertices[:, 1].min() == pytest.approx(-2)
    assert later_parts(path(Back(kind="back"))) == {}


@pytest.mark.parametrize("heading", [0.0, 0.7, math.pi / 2])
def test_the_marks_of_a_gap_are_as_far_apart_as_it_is_wide(heading):
    gap = Gap(label="narrow", position=(3.0, 1.0), width=0.9, heading=heading)
    points = gap_parts((gap,))["gap_marks"].mesh.vertices[:, :2] - (3.0, 1.0)
    across = points @ (-math.sin(heading), math.cos(heading))
    along = points @ (math.cos(heading), math.sin(heading))
    assert np.abs(across).max() == pytest.approx(0.45)
    assert np.abs(along).max() == pytest.approx(GAP_MARK[0] / 2)
    assert gap_parts(()) == {}

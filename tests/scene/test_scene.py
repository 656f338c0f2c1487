"""The scene of a session: the plan, the chair, what moves, each role's camera."""

import numpy as np
import pytest
from scene.scene_messages import everything, of_node, tick
from session.same_reader import read_in_this_process

from app.geometry import Pose
from app.scene.cameras import VIEWS, EyeSettings, Orbit, chase_camera, eye_camera, free_camera, world_placement
from app.scene.head_view import Angles
from app.scene.role_servers import ROLES
from app.scene.session_scene import LiveScene
from app.world.floorplan import FloorPlan, bundled_floorplans, load_floorplan
from app.world.obstacles import Box

PLAN = load_floorplan(bundled_floorplans()["corridors"])


@pytest.fixture
def scene(servers):
    made = LiveScene(servers)
    made.set_floorplan(PLAN, "main")
    return made


def test_the_world_is_moved_and_the_camera_is_not(servers, scene):
    scene.set_view("patient", "chase")
    scene.follow(tick(0, 1.0, 2.0, 0.0))
    scene.follow(tick(1, 3.0, 2.0, 0.5))
    found = everything(servers.port("patient"))
    placed = world_placement(chase_camera(Pose(3.0, 2.0, 0.5)))
    assert of_node(found, "SetPositionMessage", "/world")[-1]["position"] == pytest.approx(placed.position, abs=1e-6)
    assert of_node(found, "SetOrientationMessage", "/world")[-1]["wxyz"] == pytest.approx(placed.wxyz, abs=1e-6)
    assert of_node(found, "SetPositionMessage", "/world/chair")[-1]["position"] == pytest.approx((3.0, 2.0, 0.0))
    cameras = [message for message in found if message["type"] == "SetCameraPositionMessage"]
    assert {tuple(message["position"]) for message in cameras} == {(0.0, 0.0, 0.0)}


def test_before_it_moves_the_chair_is_shown_at_the_start_of_the_path(servers):
    """The control loop begins at 0, 0, where the corridors have a wall, and keeps the place of the last trial."""
    scene = LiveScene(servers)
    start = PLAN.path_named("main").start
    driven = [(0.0, 0.0), (0.0, 0.0), (float("nan"), 0.0), (0.0, 0.0), (4.0, 2.0), (0.0, 0.0)]
    shown = []
    scene.set_floorplan(PLAN, "main")
    for number, (x, y) in enumerate(driven):
        scene.follow(tick(number, x, y, 0.0))
        shown.append((scene._pose.x, scene._pose.y))
    assert shown == [(start.x, start.y)] * 4 + [(4.0, 2.0), (0.0, 0.0)]
    scene.set_floorplan(load_floorplan(bundled_floorplans()["clinic"]), "main")
    scene.follow(tick(9, 0.0, 0.0, 0.0))
    other = load_floorplan(bundled_floorplans()["clinic"]).path_named("main").start
    assert scene._pose == other


def test_roles_look_from_where_they_want(servers):
    scene = LiveScene(servers)
    for view in VIEWS:
        scene.set_view("clinician", view)
        assert scene.view("clinician") == view
        assert scene.view("patient") == "eye"


def drawn(port):
    return {message["name"] for message in everything(port) if message["type"] in ("MeshMessage", "GlbMessage")}


@pytest.mark.parametrize("role", ROLES)
def test_ceiling_and_door_frames_are_shown_to_the_eye_only(servers, role):
    scene = LiveScene(servers)
    scene.set_floorplan(load_floorplan(bundled_floorplans()["clinic"]), "main")
    for view in VIEWS:
        scene.set_view(role, view)
        shown = of_node(everything(servers.port(role)), "SetSceneNodeVisibilityMessage", "/world/overhead")
        assert shown[-1]["visible"] == (view == "eye"), view
        (walls,) = [node for name, node in scene._views[role]._building.items() if name == "walls"]
        assert np.all(np.asarray(walls.scale)[:2] == 1)
        assert (np.asarray(walls.scale)[2] < 1) == (view != "eye"), view


def test_another_plan_replaces_the_first_and_none_leaves_nothing(servers):
    scene = LiveScene(servers)
    scene.set_floorplan(load_floorplan(bundled_floorplans()["clinic"]), "main")
    scene.set_floorplan(PLAN, "straight")
    names = drawn(servers.port("clinician"))
    assert {"/world/floor", "/world/walls", "/world/overhead", "/world/path", "/world/goal"} <= names
    assert not any(name.startswith("/world/gap_marks") for name in names)
    scene.set_floorplan(OPEN, "course")
    names = drawn(servers.port("clinician"))
    assert "/world/ground" in names
    assert not {"/world/floor", "/world/walls", "/world/overhead"} & names  # a meadow has neither walls nor a ceiling
    scene.set_floorplan(None, None)
    names = drawn(servers.port("clinician"))
    assert all(name.startswith("/world/chair/") for name in names)


def test_an_unknown_path_changes_nothing(servers, scene):
    with pytest.raises(ValueError, match="has no path 'nowhere'"):
        scene.set_floorplan(load_floorplan(bundled_floorplans()["clinic"]), "nowhere")
    found = everything(servers.port("patient"))
    assert len(of_node(found, "GlbMessage", "/world/walls")) == 1
    assert of_node(found, "MeshMessage", "/world/path")


def test_the_driven_line_is_drawn_and_taken_away_at_a_new_trial(servers, scene):
    for number in range(100):
        scene.follow(tick(number, 1.0 + 0.06 * number, 2.0, 0.0, t=0.25 * number))
    found = everything(servers.port("patient"))
    assert of_node(found, "LineSegmentsMessage", "/world/driven/0")
    scene.new_trial()
    assert not of_node(everything(servers.port("patient")), "LineSegmentsMessage", "/world/driven/0")


@pytest.mark.parametrize("bad", [float("nan"), float("inf")])
def test_a_pose_that_is_not_finite_is_left_out(servers, bad):
    scene = LiveScene(servers)
    scene.update(Pose(1.0, 2.0, 0.0), 0.0)
    for pose in (Pose(bad, 0, 0), Pose(0, bad, 0), Pose(0, 0, bad)):
        scene.update(pose, 1.0)
    scene.update(Pose(9.0, 9.0, 0.0), bad)
    found = everything(servers.port("patient"))
    assert of_node(found, "SetPositionMessage", "/world/chair")[-1]["position"] == pytest.approx((1.0, 2.0, 0.0))


STAGES = [
    {"title": "A", "instruction": "Ahead.", "points": [[0, 0], [2, 0]]},
    {"title": "B", "instruction": "Back.", "points": [[2, 0], [0, 0]], "task": {"kind": "back"}},
]
COURSE = {"name": "course", "title": "Course", "points": [[0, 0], [6, 0]], "instruction": "Do all."}
OPEN = FloorPlan.model_validate(
    {
        "name": "open",
        "title": "Open",
        "walls": [],
        "ground": {"kind": "grass", "area": [-3, -3, 12, 8]},
        "cones": [{"position": [3.0, 0.0]}],
        "movers": [{"name": "ann", "kind": "person", "points": [[0, 3], [10, 3]], "pace": [[0, 0.5]]}],
        "lights": {"sun": 0.5, "azimuth": 0.0, "elevation": 0.0, "colour": [1, 2, 3]},
        "paths": [COURSE | {"task": {"kind": "course", "stages": STAGES}}],
    }
)


def test_what_moves_is_where_the_scenes_time_puts_it(servers):
    scene = LiveScene(servers)
    scene.set_floorplan(OPEN, "course")
    scene.update(Pose(0.0, 0.0, 0.0), 1.0, scene_t=4.0)
    found = everything(servers.port("patient"))
    assert of_node(found, "SetPositionMessage", "/world/mover_0")[-1]["position"] == pytest.approx((2.0, 3.0, 0.0))


def middle_of_goal(scene):
    return float(scene._views["patient"]._task["goal"].vertices[:, 0].mean())


def test_the_present_stage_is_drawn_and_a_chair_put_on_the_start_begins_again(servers):
    scene = LiveScene(servers)
    scene.set_floorplan(OPEN, "course")
    assert middle_of_goal(scene) == pytest.approx(2.0, abs=0.05)
    for number in range(22):
        scene.update(Pose(0.1 * number, 0.0, 0.0), 0.1 * number, v=1.0, scene_t=0.1 * number)
    assert middle_of_goal(scene) == pytest.approx(0.0, abs=0.05)
    scene.update(Pose(0.0, 0.0, 0.0), 3.0, scene_t=0.0)
    assert middle_of_goal(scene) == pytest.approx(2.0, abs=0.05)


def height_of_cones(scene):
    return float(scene._views["clinician"]._cones["cones"].vertices[:, 2].max())


def test_a_touched_cone_lies_until_the_next_trial(servers):
    scene = LiveScene(servers)
    scene.set_floorplan(OPEN, "course")
    assert height_of_cones(scene) == pytest.approx(0.5)
    scene.update(Pose(2.7, 0.0, 0.0), 1.0, scene_t=1.0)
    assert height_of_cones(scene) < 0.3
    scene.new_trial()
    assert height_of_cones(scene) == pytest.approx(0.5)


def test_the_sun_stands_where_the_plan_says(servers):
    scene = LiveScene(servers)
    scene.set_floorplan(OPEN, "course")
    found = everything(servers.port("clinician"))
    x, y, z = of_node(found, "SetPositionMessage", "/world/sun")[-1]["position"]
    assert x > 1000
    assert (y, z) == pytest.approx((0.0, 0.0), abs=1e-3)


def test_head_and_chair_of_one_tick_come_together_and_each_role_has_its_own_eye(servers, scene):
    scene.set_view("clinician", "eye", EyeSettings(head=False))
    scene.set_view("patient", "eye", EyeSettings(eye_height=1.4))
    pose, head = Pose(3.0, 2.0, 0.5), Angles(0.6, 0.1, 0.3)
    for number in range(150):
        scene.update(pose, number / 60, head=head, head_age=0.01)
    seen = {role: everything(servers.port(role)) for role in ROLES}
    wanted = {
        "clinician": world_placement(eye_camera(pose)),
        "patient": world_placement(eye_camera(pose, Angles(0.6, 0.1, 0.0), 1.4)),
    }
    for role, placed in wanted.items():
        assert of_node(seen[role], "SetPositionMessage", "/world")[-1]["position"] == pytest.approx(
            placed.position, abs=1e-4
        )
        assert of_node(seen[role], "SetOrientationMessage", "/world")[-1]["wxyz"] == pytest.approx(
            placed.wxyz, abs=1e-4
        )


def test_the_free_camera_is_moved_by_the_server(servers, scene):
    orbit = Orbit(1.0, 0.5, 7.0, 2.0, 3.0)
    scene.set_view("clinician", "free")
    scene.set_orbit("clinician", orbit)
    assert scene.orbit("clinician") == orbit
    assert scene.orbit("patient") != orbit
    scene.update(Pose(9.0, 2.0, 0.0), 1.0)
    placed = world_placement(free_camera(orbit))
    found = everything(servers.port("clinician"))
    assert of_node(found, "SetPositionMessage", "/world")[-1]["position"] == pytest.approx(placed.position, abs=1e-5)


def test_an_object_that_cannot_be_read_is_a_plain_box_and_said_so(servers, tmp_path, caplog, monkeypatch):
    read_in_this_process(monkeypatch)
    (tmp_path / "piano.glb").write_bytes(b"nothing")
    plan = OPEN.model_copy(
        update={"obstacles": (Box(kind="box", label="x", position=(8.0, 5.0), size=(1.0, 1.0), model="piano"),)}
    )
    scene = LiveScene(servers, tmp_path)
    scene.set_floorplan(plan, "course")
    assert "piano.glb" in caplog.text
    names = {message["name"] for message in everything(servers.port("patient")) if message["type"] == "MeshMessage"}
    assert any(name.startswith("/world/furniture_") for name in names)

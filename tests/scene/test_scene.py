import socket
import threading

import msgspec
import numpy as np
import pytest
import websockets.sync.client
import zstandard

from app.clock import MonotonicClock
from app.geometry import Pose
from app.messages import TICK
from app.scene.page import client_page
from app.scene.scene import CLOCK_NODE, Scene
from app.scene.scene_thread import start_scene
from app.scene.servers import ROLES, RoleServers
from app.scene.views import VIEWS, chase_camera, world_placement
from app.scene.wire import SUBPROTOCOL
from app.world.floorplan import bundled_floorplans, load_floorplan

PLAN = load_floorplan(bundled_floorplans()["corridors"])


@pytest.fixture
def servers():
    with RoleServers() as started:
        yield started


def messages(port, stop):
    """Read a 3D server as a browser does, until a message satisfies `stop`."""
    found = []
    with websockets.sync.client.connect(
        f"ws://127.0.0.1:{port}", subprotocols=[SUBPROTOCOL], compression=None, max_size=None, proxy=None
    ) as client:
        while not any(stop(message) for message in found):
            frame = client.recv(timeout=10)
            size = int.from_bytes(frame[8:16], "little")
            inner = zstandard.ZstdDecompressor().decompress(frame[16 : 16 + size], int.from_bytes(frame[:8], "little"))
            found += msgspec.msgpack.decode(inner)["messages"]
    return found


def everything(port):
    return messages(port, lambda message: message["type"] == "ReplayDoneMessage")


def of_node(found, kind, name):
    return [message for message in found if message["type"] == kind and message["name"] == name]


def tick(number, x, y, theta, t=1.0):
    made = np.zeros(1, dtype=TICK)[0]
    made["number"], made["x"], made["y"], made["theta"], made["t"] = number, x, y, theta, t
    return made


def test_servers_listen_here_only_say_nothing_and_end(capfd):
    before = set(threading.enumerate())
    servers = RoleServers()
    ports = [servers.port(role) for role in ROLES]
    assert len(set(ports)) == len(ROLES)
    assert {servers[role].get_host() for role in ROLES} == {"127.0.0.1"}
    servers.stop()
    servers.stop()
    assert [thread for thread in set(threading.enumerate()) - before if thread.is_alive()] == []
    for port in ports:
        with pytest.raises(ConnectionRefusedError):
            socket.create_connection(("127.0.0.1", port), timeout=1)
    assert capfd.readouterr() == ("", "")


def test_no_server_can_be_asked_for_a_public_tunnel(servers):
    for role in ROLES:
        handled = {kind.__name__ for kind in servers[role]._websock_server._incoming_handlers}
        assert not {name for name in handled if name.startswith("ShareUrl")}


def test_only_the_clinician_gets_plots(servers):
    Scene(servers)
    kinds = {role: {message["type"] for message in everything(servers.port(role))} for role in ROLES}
    assert "GuiUplotMessage" in kinds["clinician"]
    assert "GuiUplotMessage" not in kinds["patient"]


def test_the_world_is_moved_and_the_camera_is_not(servers):
    scene = Scene(servers)
    scene.set_floorplan(PLAN, "main")
    scene.set_view("patient", "chase")
    scene.follow(tick(1, 3.0, 2.0, 0.5))
    found = everything(servers.port("patient"))
    placed = world_placement(chase_camera(Pose(3.0, 2.0, 0.5)))
    assert of_node(found, "SetPositionMessage", "/world")[-1]["position"] == pytest.approx(placed.position, abs=1e-6)
    assert of_node(found, "SetOrientationMessage", "/world")[-1]["wxyz"] == pytest.approx(placed.wxyz, abs=1e-6)
    assert of_node(found, "SetPositionMessage", "/world/chair")[-1]["position"] == pytest.approx((3.0, 2.0, 0.0))
    cameras = [message for message in found if message["type"] == "SetCameraPositionMessage"]
    assert {tuple(message["position"]) for message in cameras} == {(0.0, 0.0, 0.0)}


def test_roles_look_from_where_they_want(servers):
    scene = Scene(servers)
    for view in VIEWS:
        scene.set_view("clinician", view)
        assert scene.view("clinician") == view
        assert scene.view("patient") == "eye"


def test_another_plan_replaces_the_first_and_none_leaves_nothing(servers):
    scene = Scene(servers)
    scene.set_floorplan(load_floorplan(bundled_floorplans()["clinic"]), "main")
    scene.set_floorplan(PLAN, "straight")
    names = {message["name"] for message in everything(servers.port("clinician")) if message["type"] == "MeshMessage"}
    assert {"/world/floor", "/world/wall_sides", "/world/path", "/world/goal"} <= names
    assert "/world/door_frames" not in names  # this plan has no doors
    scene.set_floorplan(None, None)
    names = {message["name"] for message in everything(servers.port("clinician")) if message["type"] == "MeshMessage"}
    assert all(name.startswith("/world/chair/") for name in names)


def test_an_unknown_path_changes_nothing(servers):
    scene = Scene(servers)
    scene.set_floorplan(PLAN, "main")
    with pytest.raises(ValueError, match="has no path 'nowhere'"):
        scene.set_floorplan(load_floorplan(bundled_floorplans()["clinic"]), "nowhere")
    found = everything(servers.port("patient"))
    assert not of_node(found, "MeshMessage", "/world/door_frames")
    assert of_node(found, "MeshMessage", "/world/path")


def test_the_driven_line_is_drawn_and_taken_away_at_a_new_trial(servers):
    scene = Scene(servers)
    scene.set_floorplan(PLAN, "main")
    for number in range(100):
        scene.follow(tick(number, 1.0 + 0.06 * number, 2.0, 0.0, t=0.25 * number))
    found = everything(servers.port("patient"))
    assert of_node(found, "LineSegmentsMessage", "/world/driven/0")
    scene.new_trial()
    assert not of_node(everything(servers.port("patient")), "LineSegmentsMessage", "/world/driven/0")


@pytest.mark.parametrize("bad", [float("nan"), float("inf")])
def test_a_pose_that_is_not_finite_is_left_out(servers, bad):
    scene = Scene(servers)
    scene.update(Pose(1.0, 2.0, 0.0), 0.0)
    for pose in (Pose(bad, 0, 0), Pose(0, bad, 0), Pose(0, 0, bad)):
        scene.update(pose, 1.0)
    scene.update(Pose(9.0, 9.0, 0.0), bad)
    found = everything(servers.port("patient"))
    assert of_node(found, "SetPositionMessage", "/world/chair")[-1]["position"] == pytest.approx((1.0, 2.0, 0.0))


def test_the_thread_follows_the_newest_tick_and_stamps_the_picture(servers):
    box = [tick(1, 1.0, 1.0, 0.0)]
    thread = start_scene(servers, lambda: box[0])
    try:
        box[0] = tick(2, 5.0, 4.0, 0.0)
        messages(
            servers.port("clinician"),
            lambda message: (
                message["type"] == "SetPositionMessage"
                and message["name"] == "/world/chair"
                and message["position"][0] == pytest.approx(5.0)
            ),
        )
        stamps = set()

        def third_stamp(message):
            if message["type"] == "SetPositionMessage" and message["name"] == CLOCK_NODE:
                stamps.add(message["position"][0])
            return len(stamps) >= 3

        messages(servers.port("clinician"), third_stamp)
    finally:
        thread.stop()
    thread.stop()


def test_the_same_tick_is_drawn_once(servers):
    drawn, asked = [], []

    def newest():
        asked.append(None)
        return tick(7, 1.0, 1.0, 0.0)

    thread = start_scene(servers, newest)
    follow = thread.scene.follow
    thread.scene.follow = lambda found: (drawn.append(int(found["number"])), follow(found))
    clock = MonotonicClock()
    while len(asked) < 10:
        clock.sleep_until(clock.now() + 0.01)
    thread.stop()
    assert len(drawn) <= 1


def test_the_page_is_visers_own_with_our_head():
    page = client_page().decode()
    assert page.count("</head>") == 1
    assert "bodydriveView" in page[: page.index("</head>")]
    assert "<title>Viser" not in page

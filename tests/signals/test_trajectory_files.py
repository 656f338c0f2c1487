"""Trajectories of robots and their data sets, in the plane; libraries that read bags are asked for by name."""

import importlib.util
from types import SimpleNamespace

import numpy as np
import pytest

from app.signals.foreign.mcap_log import read as read_mcap
from app.signals.foreign.poses import TopicMessage, place_of, stamp_of, trajectory_of
from app.signals.foreign.ros_bag import read as read_bag
from app.signals.trajectory_files import read_places, read_trajectory
from needed import lacks

COUNT = 50
T = np.arange(COUNT) / 10
PLACES = np.column_stack([np.sin(T), T**2 / 10])
EPOCH = 1_706_282_470.0


def rows(form):
    return "".join(
        form.format(t=EPOCH + t, ns=int((EPOCH + t) * 1e9), x=x, y=y) for t, (x, y) in zip(T, PLACES, strict=True)
    )


QUATERNION = "0 0 0.70710678 0.70710678"
FILES = {
    "TUM": "# ground truth\n# timestamp tx ty tz qx qy qz qw\n"
    + rows("{t:.4f} {x:.6f} {y:.6f} 0 " + QUATERNION + "\n"),
    "TUM without a header": rows("{t:.4f} {x:.6f} {y:.6f} 0 " + QUATERNION + "\n"),
    "EuRoC": "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n"
    + rows("{ns},{x:.6f},{y:.6f},0,1,0,0,0\n"),
    "CSV of a bag": "%time,field.header.seq,field.pose.pose.position.x,field.pose.pose.position.y,"
    "field.pose.pose.orientation.x,field.twist.twist.linear.x\n" + rows("{ns},7,{x:.6f},{y:.6f},0,0\n"),
    "millimetres": "time [s];x [mm];y [mm]\n"
    + "".join(f"{EPOCH + t:.3f};{1e3 * x:.3f};{1e3 * y:.3f}\n" for t, (x, y) in zip(T, PLACES, strict=True)),
    "our own": "t,x,y\n" + rows("{t:.3f},{x:.6f},{y:.6f}\n"),
}


@pytest.mark.parametrize("name", FILES)
def test_a_trajectory_is_read(tmp_path, name):
    (tmp_path / "driven.csv").write_text(FILES[name])
    found = read_trajectory(tmp_path / "driven.csv")
    np.testing.assert_allclose(found.t - found.t[0], T, atol=2e-6)
    np.testing.assert_allclose(np.column_stack([found.x, found.y]), PLACES, atol=1e-6)


@pytest.fixture
def kitti(tmp_path):
    matrices = [f"1 0 0 {-y:.6f} 0 1 0 0 0 0 1 {x:.6f}\n" for x, y in PLACES]
    (tmp_path / "00.txt").write_text("".join(matrices))
    return tmp_path / "00.txt"


def test_poses_of_a_camera_lie_ahead_and_to_the_left(kitti):
    with pytest.raises(ValueError, match=r"lay times\.txt with 50 times beside it"):
        read_trajectory(kitti)
    assert read_trajectory(kitti, rate=10.0).t[1] == pytest.approx(0.1)
    (kitti.parent / "times.txt").write_text("".join(f"{t:e}\n" for t in T))
    found = read_trajectory(kitti)
    np.testing.assert_allclose(np.column_stack([found.t, found.x, found.y]), np.column_stack([T, PLACES]), atol=1e-6)


def test_extras_come_with_it_and_several_places_are_asked_about(tmp_path):
    file = tmp_path / "driven.csv"
    file.write_text("t,x,y,u1\n0,0,0,1\n1,1,0,0\n")
    assert read_trajectory(file, ("u1", "u2")).extras["u1"].tolist() == [1.0, 0.0]
    file.write_text("t,a/position/x,a/position/y,b/position/x,b/position/y\n0,0,0,1,1\n1,1,0,2,2\n")
    with pytest.raises(ValueError, match="call the right ones x and y"):
        read_trajectory(file)
    file.write_text("t,x,z\n0,0,0\n1,1,1\n")
    with pytest.raises(ValueError, match="no column 'y'"):
        read_trajectory(file)


def test_a_line_needs_no_times_and_no_names(tmp_path):
    file = tmp_path / "path.csv"
    for content in ("x,y\n0,0\n2,1\n", "0 0\n2 1\n", "x [cm];y [cm]\n0;0\n200;100\n", "id,x,y,\n1,0,0,\n2,2,1,\n"):
        file.write_text(content)
        np.testing.assert_allclose(read_places(file), [[0, 0], [2, 1]])


def ros(**fields):
    return SimpleNamespace(**fields)


POINT = ros(x=1.5, y=-2.0, z=0.0)
STAMP = ros(stamp=ros(sec=1_706_282_470, nanosec=250_000_000))


@pytest.mark.parametrize(
    "message",
    [
        ros(header=STAMP, pose=ros(pose=ros(position=POINT))),
        ros(header=STAMP, pose=ros(position=POINT)),
        ros(header=STAMP, point=POINT),
        {"timestamp": {"sec": 1_706_282_470, "nsec": 250_000_000}, "pose": {"position": {"x": 1.5, "y": -2.0}}},
    ],
)
def test_a_place_and_a_stamp_are_found_in_messages(message):
    assert place_of(message) == (1.5, -2.0)
    assert stamp_of(message) == EPOCH + 0.25


def test_the_topic_with_the_most_places_is_the_trajectory():
    messages = [TopicMessage("/goal", 1, POINT), TopicMessage("/imu", 2, ros(header=STAMP))]
    messages += [
        TopicMessage("/odom", int((EPOCH + t) * 1e9), {"x": float(x), "y": float(y)})
        for t, (x, y) in zip(T, PLACES, strict=True)
    ]
    found = trajectory_of(messages)
    np.testing.assert_allclose(found.columns["x"], PLACES[:, 0])
    np.testing.assert_allclose(found.columns["t"] - EPOCH, T, atol=1e-6)
    assert "topic /odom; these others were left out: /goal" in str(found.note)
    assert trajectory_of([]).columns == {}


def need_library(name):
    if importlib.util.find_spec(name) is None:
        lacks(f"there is no {name} here: install the extra 'bags'")
    return importlib.import_module(name)


def test_messages_of_mcap_in_json_are_read(tmp_path):
    need_library("mcap")
    writer_of = importlib.import_module("mcap.writer").Writer
    with (tmp_path / "drive.mcap").open("wb") as file:
        writer = writer_of(file)
        writer.start()
        schema = writer.register_schema(name="Pose", encoding="jsonschema", data=b"{}")
        channel = writer.register_channel(schema_id=schema, topic="/pose", message_encoding="json")
        for t, (x, y) in zip(T, PLACES, strict=True):
            moment = int((EPOCH + t) * 1e9)
            content = f'{{"position": {{"x": {x}, "y": {y}}}}}'.encode()
            writer.add_message(channel_id=channel, log_time=moment, data=content, publish_time=moment)
        writer.finish()
    np.testing.assert_allclose(read_mcap(tmp_path / "drive.mcap").columns["y"], PLACES[:, 1])


def test_a_bag_of_ros_is_read(tmp_path):
    need_library("rosbags")
    typesys = importlib.import_module("rosbags.typesys")
    store = typesys.get_typestore(typesys.Stores.ROS2_HUMBLE)
    point = store.types["geometry_msgs/msg/PointStamped"]
    with importlib.import_module("rosbags.rosbag2").Writer(tmp_path / "drive", version=9) as writer:
        connection = writer.add_connection("/place", point.__msgtype__, typestore=store)
        for t, (x, y) in zip(T, PLACES, strict=True):
            stamp = store.types["builtin_interfaces/msg/Time"](sec=int(EPOCH) + int(t), nanosec=round(1e9 * (t % 1.0)))
            header = store.types["std_msgs/msg/Header"](stamp=stamp, frame_id="map")
            message = point(header=header, point=store.types["geometry_msgs/msg/Point"](x=x, y=y, z=0.0))
            writer.write(connection, int((EPOCH + t) * 1e9), store.serialize_cdr(message, point.__msgtype__))
    file = next((tmp_path / "drive").glob("*.db3"))
    np.testing.assert_allclose(read_bag(file).columns["x"], PLACES[:, 0])
    assert len(read_trajectory(tmp_path / "drive").t) == COUNT

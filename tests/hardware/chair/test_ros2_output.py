"""The ROS 2 output, received through DDS as a chair's own driver would, without ROS."""

import itertools
import random
import struct
import sys

import pytest
from hardware.chair.ros_network import THIS_MACHINE_ONLY
from rosbags.typesys import Stores, get_typestore

from app.geometry import STANDSTILL, Twist
from app.hardware.chair.outputs import OutputRefused, open_output

core = pytest.importorskip("cyclonedds.core", reason="not every machine has this library: it is the extra ros2")
domain, sub, topic = (pytest.importorskip(f"cyclonedds.{name}") for name in ("domain", "sub", "topic"))
ros2 = pytest.importorskip("app.hardware.chair.ros2")

DOMAIN = 77
STEP = 0.01  # s


@pytest.fixture
def network(monkeypatch):
    monkeypatch.setenv("CYCLONEDDS_URI", THIS_MACHINE_ONLY)
    monkeypatch.setenv("ROS_DOMAIN_ID", str(DOMAIN))


@pytest.fixture
def output(network):
    return ros2.Ros2Twist()


@pytest.fixture
def heard(output):
    """Return a function that returns the samples since its last call, as a default ROS 2 subscriber gets them."""
    participant = domain.DomainParticipant(DOMAIN)
    wants = core.Qos(core.Policy.Reliability.Reliable(max_blocking_time=0), core.Policy.History.KeepLast(1000))
    reader = sub.DataReader(participant, topic.Topic(participant, "rt/cmd_vel", ros2.RosTwist), qos=wants)
    assert output._topic.listeners() == 1
    return lambda: [(told.linear.x, told.angular.z) for told in reader.take(1000)]


def test_a_sample_is_the_52_bytes_of_a_ros_twist():
    cdr = ros2.sample(Twist(0.5, -1.25)).serialize()
    assert cdr == b"\x00\x01\x00\x00" + struct.pack("<6d", 0.5, 0.0, 0.0, 0.0, 0.0, -1.25)
    assert len(cdr) == 52
    assert ros2.RosTwist.__idl__.idl_transformed_typename == "geometry_msgs::msg::dds_::Twist_"


def test_messages_are_what_another_cdr_implementation_reads_and_writes():
    rosbags, rng = get_typestore(Stores.ROS2_JAZZY), random.Random(4)
    for _ in range(100):
        twist, frame = Twist(rng.uniform(-2, 2), rng.uniform(-3, 3)), "x" * rng.randint(1, 20)
        plain, stamped = ros2.sample(twist).serialize(), ros2.stamped_sample(twist, frame).serialize()
        read = rosbags.deserialize_cdr(plain, "geometry_msgs/msg/Twist")
        assert (read.linear.x, read.angular.z) == twist
        assert bytes(rosbags.serialize_cdr(read, "geometry_msgs/msg/Twist")) == plain
        read = rosbags.deserialize_cdr(stamped, "geometry_msgs/msg/TwistStamped")
        assert (read.twist.linear.x, read.twist.angular.z, read.header.frame_id) == (*twist, frame)
        assert (read.header.stamp.sec, read.header.stamp.nanosec) == (0, 0)
        assert bytes(rosbags.serialize_cdr(read, "geometry_msgs/msg/TwistStamped")) == stamped


def test_topic_type_and_frame_are_chosen(network):
    output = ros2.Ros2Twist("/wheels/cmd_vel", "TwistStamped", "chair")
    participant = domain.DomainParticipant(DOMAIN)
    wants = core.Qos(core.Policy.Reliability.Reliable(max_blocking_time=0), core.Policy.History.KeepLast(10))
    named = topic.Topic(participant, "rt/wheels/cmd_vel", ros2.RosTwistStamped)
    reader = sub.DataReader(participant, named, qos=wants)
    output.drive(0.0, "armed", Twist(0.3, -0.1), "")
    (told,) = reader.take(10)
    assert (told.header.frame_id, told.twist.linear.x, told.twist.angular.z) == ("chair", 0.3, -0.1)
    assert ros2.RosTwistStamped.__idl__.idl_transformed_typename == "geometry_msgs::msg::dds_::TwistStamped_"
    assert "The topic /wheels/cmd_vel of ROS 2 (TwistStamped): 1 listening" in output.description()


@pytest.mark.parametrize(
    ("options", "why"),
    [
        *(({"topic": name}, "is no topic") for name in ("cmd_vel", "/", "/a//b", "/a b", "/1", "", "/" + 200 * "a")),
        ({"frame": "chair"}, "--frame is of TwistStamped"),
        ({"frame": "a b", "message": "TwistStamped"}, "is no frame"),
        ({"frame": "", "message": "TwistStamped"}, "is no frame"),
    ],
)
def test_names_that_ros_does_not_have_are_refused(options, why):
    with pytest.raises(OutputRefused, match=why):
        ros2.Ros2Twist(**options)


def test_a_topic_that_nobody_listens_to_drives_no_chair(output, heard):
    output.poll(0.0)

    class Deserted:
        def get_matched_subscriptions(self):
            return []

    output._topic._writer = Deserted()
    output.poll(0.05)  # who listens is looked up ten times a second
    with pytest.raises(OSError, match="nobody listens to /cmd_vel"):
        output.poll(0.11)


def test_every_change_is_published_at_once(output, heard):
    speeds = [Twist(0.01 * n, -0.02 * n) for n in range(20)]
    for n, twist in enumerate(speeds):
        output.drive(STEP * n, "armed", twist, "")
    assert heard() == speeds


def test_the_same_is_published_at_least_every_50_ms(output, heard):
    times = []
    for n in range(100):
        output.drive(STEP * n, "armed", Twist(0.3, 0.1), "")
        times += [STEP * n] * len(heard())
    gaps = [after - before for before, after in itertools.pairwise(times)]
    assert max(gaps) <= 0.05 + 1e-9
    assert 20 <= len(times) <= 34


def test_a_disarmed_chair_is_told_zeros_and_closing_says_so_again(output, heard):
    output.drive(0.0, "disarmed", STANDSTILL, "")
    output.drive(0.06, "armed", Twist(0.3, 0.0), "")
    output.drive(0.07, "disarmed", STANDSTILL, "The chair received a stop.")
    assert heard() == [(0.0, 0.0), (0.3, 0.0), (0.0, 0.0)]
    output.drive(0.08, "armed", Twist(0.3, 0.0), "")
    output.close()
    assert heard() == [(0.3, 0.0), (0.0, 0.0)]


def test_who_moves_somebody_says_so(output):
    assert output.is_real


def test_a_sample_that_dds_does_not_take_is_a_broken_output_and_is_said_again(output, heard):
    writer = output._topic._writer

    class Full:
        def write(self, _sample):
            raise core.DDSException(core.DDSException.DDS_RETCODE_TIMEOUT, msg="full")

    output._topic._writer = Full()
    with pytest.raises(OSError, match="full"):
        output.drive(0.0, "armed", Twist(0.3, 0.0), "")
    output._topic._writer = writer
    output.drive(0.01, "armed", Twist(0.3, 0.0), "")
    assert heard() == [(0.3, 0.0)]


@pytest.mark.parametrize("error", [core.DDSException(core.DDSException.DDS_RETCODE_ERROR), AttributeError()])
def test_closing_is_no_trouble_when_nobody_acknowledges(output, error):
    class Alone:
        def write(self, _sample):
            pass

        def wait_for_acks(self, _duration):
            raise error

    output._topic._writer = Alone()
    output.drive(0.0, "armed", Twist(0.3, 0.0), "")
    output.close()


@pytest.mark.parametrize("number", ["x", "-1", "233", "1.5"])
def test_a_domain_that_is_none_is_refused(monkeypatch, number):
    monkeypatch.setenv("ROS_DOMAIN_ID", number)
    with pytest.raises(OutputRefused, match=f"ROS_DOMAIN_ID is '{number}'"):
        open_output("ros2")


def test_without_its_library_it_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "cyclonedds", None)
    monkeypatch.delitem(sys.modules, "cyclonedds.core")
    for name in ("dds", "ros2"):
        monkeypatch.delitem(sys.modules, f"app.hardware.chair.{name}")
    with pytest.raises(OutputRefused, match=r"pip install 'bodydrive\[ros2\]'"):
        open_output("ros2")

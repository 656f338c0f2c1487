"""The ROS 2 output, received through DDS as a chair's own driver would, without ROS."""

import itertools
import struct
import sys

import pytest

from app.geometry import STANDSTILL, Twist
from app.hardware.chair.outputs import OutputRefused, open_output

core = pytest.importorskip("cyclonedds.core", reason="not every machine has this library: it is the extra ros2")
domain, sub, topic = (pytest.importorskip(f"cyclonedds.{name}") for name in ("domain", "sub", "topic"))
ros2 = pytest.importorskip("app.hardware.chair.ros2")

DOMAIN = 77
STEP = 0.01  # s
THIS_MACHINE_ONLY = """<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast>
<Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces></General></Domain></CycloneDDS>"""


@pytest.fixture
def output(monkeypatch):
    monkeypatch.setenv("CYCLONEDDS_URI", THIS_MACHINE_ONLY)
    monkeypatch.setenv("ROS_DOMAIN_ID", str(DOMAIN))
    return ros2.Ros2Twist()


@pytest.fixture
def heard(output):
    """Return a function that returns the samples since its last call, as a default ROS 2 subscriber gets them."""
    participant = domain.DomainParticipant(DOMAIN)
    wants = core.Qos(core.Policy.Reliability.Reliable(max_blocking_time=0), core.Policy.History.KeepLast(1000))
    reader = sub.DataReader(participant, topic.Topic(participant, "rt/cmd_vel", ros2.RosTwist), qos=wants)
    assert len(output._writer.get_matched_subscriptions()) == 1
    return lambda: [(told.linear.x, told.angular.z) for told in reader.take(1000)]


def test_a_sample_is_the_52_bytes_of_a_ros_twist():
    cdr = ros2.sample(Twist(0.5, -1.25)).serialize()
    assert cdr == b"\x00\x01\x00\x00" + struct.pack("<6d", 0.5, 0.0, 0.0, 0.0, 0.0, -1.25)
    assert len(cdr) == 52
    assert ros2.RosTwist.__idl__.idl_transformed_typename == "geometry_msgs::msg::dds_::Twist_"


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
    writer = output._writer

    class Full:
        def write(self, _sample):
            raise core.DDSException(core.DDSException.DDS_RETCODE_TIMEOUT, msg="full")

    output._writer = Full()
    with pytest.raises(OSError, match="full"):
        output.drive(0.0, "armed", Twist(0.3, 0.0), "")
    output._writer = writer
    output.drive(0.01, "armed", Twist(0.3, 0.0), "")
    assert heard() == [(0.3, 0.0)]


@pytest.mark.parametrize("error", [core.DDSException(core.DDSException.DDS_RETCODE_ERROR), AttributeError()])
def test_closing_is_no_trouble_when_nobody_acknowledges(output, error):
    class Alone:
        def write(self, _sample):
            pass

        def wait_for_acks(self, _duration):
            raise error

    output._writer = Alone()
    output.close()


@pytest.mark.parametrize("number", ["x", "-1", "233", "1.5"])
def test_a_domain_that_is_none_is_refused(monkeypatch, number):
    monkeypatch.setenv("ROS_DOMAIN_ID", number)
    with pytest.raises(OutputRefused, match=f"ROS_DOMAIN_ID is '{number}'"):
        open_output("ros2")


def test_without_its_library_it_says_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "cyclonedds", None)
    monkeypatch.delitem(sys.modules, "cyclonedds.core")
    monkeypatch.delitem(sys.modules, "app.hardware.chair.ros2")
    with pytest.raises(OutputRefused, match=r"pip install 'bodydrive\[ros2\]'"):
        open_output("ros2")

"""The LUCI output: its messages against another CDR implementation, and what LUCI's node hears and tells."""

import random
from itertools import pairwise

import pytest
from hardware.chair.ros_network import THIS_MACHINE_ONLY, wait_until
from rosbags.typesys import Stores, get_types_from_msg, get_typestore

from app.geometry import STANDSTILL, Twist
from app.hardware.chair.reasons import Reason

core = pytest.importorskip("cyclonedds.core", reason="not every machine has this library: it is the extra ros2")
domain, pub, sub, topic = (pytest.importorskip(f"cyclonedds.{name}") for name in ("domain", "pub", "sub", "topic"))
luci = pytest.importorskip("app.hardware.chair.luci")
dds = pytest.importorskip("app.hardware.chair.dds")

DOMAIN = 81
STEP = 0.01  # s
MESSAGE = "luci_messages/msg/LuciJoystick"
FIELDS = "int32 forward_back\nint32 left_right\nint32 joystick_zone\nint32 input_source\n"


@pytest.fixture
def output(monkeypatch):
    monkeypatch.setenv("CYCLONEDDS_URI", THIS_MACHINE_ONLY)
    monkeypatch.setenv("ROS_DOMAIN_ID", str(DOMAIN))
    return luci.LuciRemote()


class LuciNode:
    """LUCI's node: what it hears on /luci/remote_joystick, and its own joystick on /luci/joystick_position."""

    NAMES = ("remote_joystick", "joystick_position")

    def __init__(self):
        participant = domain.DomainParticipant(DOMAIN)
        wants = core.Qos(core.Policy.Reliability.Reliable(max_blocking_time=0), core.Policy.History.KeepLast(1000))
        heard, told = (topic.Topic(participant, f"rt/luci/{name}", luci.LuciJoystick) for name in self.NAMES)
        self._reader = sub.DataReader(participant, heard, qos=wants)
        self._writer = pub.DataWriter(participant, told, qos=dds.QOS)

    @property
    def heard(self):
        return [(each.forward_back, each.left_right, each.joystick_zone) for each in self._reader.take(1000)]

    def tell(self, forward_back, left_right):
        fields = {"forward_back": forward_back, "left_right": left_right, "joystick_zone": 8, "input_source": 4}
        self._writer.write(luci.LuciJoystick(**fields))


@pytest.fixture
def node(output):
    made = LuciNode()
    assert output._topic.listeners() == 1
    return made


@pytest.fixture
def rosbags():
    store = get_typestore(Stores.ROS2_JAZZY)
    store.register(get_types_from_msg(FIELDS, MESSAGE))
    return store


def test_a_message_is_what_another_cdr_implementation_reads_and_writes(rosbags):
    rng = random.Random(3)
    for _ in range(200):
        ahead, right = rng.uniform(-100, 100), rng.uniform(-100, 100)
        cdr = luci.joystick_of(ahead, right).serialize()
        read = rosbags.deserialize_cdr(cdr, MESSAGE)
        assert (read.forward_back, read.left_right, read.input_source) == (round(ahead), round(right), 5)
        assert bytes(rosbags.serialize_cdr(read, MESSAGE)) == cdr
    assert luci.LuciJoystick.__idl__.idl_transformed_typename == "luci_messages::msg::dds_::LuciJoystick_"


@pytest.mark.parametrize(
    ("ahead", "right", "zone"),
    [
        *((0, 0, 8), (0.4, -0.4, 8), (50, 0, 0), (50, 20, 0), (50, 21, 2), (0, 50, 4), (-50, 50, 6), (-50, 20, 7)),
        *((-50, -20, 7), (-50, -50, 5), (0, -50, 3), (20, -50, 3), (50, -50, 1), (50, -20, 0)),
    ],
)
def test_the_zone_is_the_sector_of_the_joystick(ahead, right, zone):
    assert luci.joystick_of(ahead, right).joystick_zone == zone


def test_every_change_is_published_and_the_same_at_least_every_50_ms(output, node):
    output.drive(0.0, "disarmed", STANDSTILL, "")
    assert node.heard == [(0, 0, 8)]
    output.drive(0.01, "armed", Twist(0.3, 0.0), "")
    output.drive(0.02, "armed", Twist(0.3, 0.5), "")
    assert node.heard == [(7, 0, 0), (7, -12, 1)]
    times = []
    for n in range(3, 103):
        output.drive(STEP * n, "armed", Twist(0.3, 0.5), "")
        times += [STEP * n] * len(node.heard)
    assert max(later - earlier for earlier, later in pairwise([0.02, *times])) <= 0.05 + 1e-9


def test_a_hand_on_the_chair_s_own_joystick_is_told_until_it_lets_go(output, node):
    assert output.poll(1.0).obstacle is Reason.NONE
    for position, touched in (((4, -9), False), ((0, 10), True), ((-80, 0), True), ((0, 0), False)):
        node.tell(*position)
        wait_until(lambda touched=touched: output.poll(1.0).own_joystick == touched)
    assert output.poll(1.0).obstacle is Reason.NONE


def test_it_says_what_to_call_and_what_it_found(output):
    description = output.description()
    assert "0 listening to /luci/remote_joystick" in description
    assert "the chair's own joystick is not reported" in description
    assert "`ros2 service call /luci/set_shared_remote_input std_srvs/srv/Empty`" in description
    assert "No chair document is given" in description


def test_closing_publishes_the_centre_where_anything_was_driven(output, node):
    output.close()
    assert node.heard == []
    output.drive(0.0, "armed", Twist(0.3, 0.0), "")
    output.close()
    assert node.heard == [(7, 0, 0), (0, 0, 8)]

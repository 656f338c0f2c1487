"""Each output and each fault of its far end: the receiver stops, and no old speed comes back (docs/safety.md)."""

import pytest
from hardware.chair.driven_output import DrivenOutput
from hardware.chair.far_ends import Board, MemoryPort
from hardware.chair.ros_network import THIS_MACHINE_ONLY

from app.hardware.chair import analog, whill
from app.hardware.chair.key import Key, write_key
from app.hardware.chair.packet import DRIVE
from app.hardware.chair.reasons import Reason
from app.hardware.chair.receiver import ReceiverState
from app.hardware.chair.whill_emulator import EmulatedWhill

SECRET = bytes(range(32))
SPEEDS = (0.2, 0.1)  # m/s, rad/s
STOPPED_WITHIN = 0.31  # s from the fault to the receiver's stop, as from the silence of a sender (S3)
RAMP = 0.25  # s


class Rig:
    """A driven output, what is at its far end, and the line between them where there is one."""

    def __init__(self, output, far, port=None):
        self.drive, self.far, self.port = DrivenOutput(output), far, port

    @property
    def is_moved(self):
        """Whether the far end moves; the board looks at its own clock."""
        if isinstance(self.far, Board):
            self.far.watch(self.drive.t)
        return self.far.is_moved


class MovedWhill(EmulatedWhill):
    @property
    def is_moved(self):
        return self.front != 0 or self.side != 0


class MovedBoard(Board):
    @property
    def is_moved(self):
        return self.deflection != (0, 0) or self.relay_closed


class Network:
    """In place of DDS's writer and reader: keeps the newest message; a node listens, or DDS refuses."""

    def __init__(self):
        self.newest = None
        self.listens, self.refuses = True, False
        self.own = []  # of the chair's own joystick

    def write(self, message):
        from cyclonedds.core import DDSException

        if self.refuses:
            raise DDSException(DDSException.DDS_RETCODE_TIMEOUT, msg="full")
        self.newest = message

    def get_matched_subscriptions(self):
        return [1] if self.listens else []

    def take(self, _count):
        taken, self.own = self.own, []
        return taken

    @property
    def is_moved(self):
        message = self.newest
        if message is None:
            return False
        if hasattr(message, "forward_back"):
            return (message.forward_back, message.left_right) != (0, 0)
        return (message.linear.x, message.angular.z) != (0.0, 0.0)


@pytest.fixture
def make(monkeypatch, tmp_path):
    """Return a function that makes the rig of an output."""
    monkeypatch.setenv("CYCLONEDDS_URI", THIS_MACHINE_ONLY)
    monkeypatch.setenv("ROS_DOMAIN_ID", "83")

    def whill_rig():
        far = MovedWhill()
        port = MemoryPort(far)
        monkeypatch.setattr("app.hardware.chair.whill.SerialPort", lambda *_: port)
        return Rig(whill.WhillLine("/dev/whill", far.tread), far, port)

    def analog_rig():
        far = MovedBoard(SECRET)
        port = MemoryPort(far)
        monkeypatch.setattr("app.hardware.chair.analog.SerialPort", lambda *_: port)
        write_key(tmp_path / "7.key", Key(7, SECRET))
        return Rig(analog.AnalogBoard("/dev/board", tmp_path / "7.key"), far, port)

    def ros2_rig():
        output = pytest.importorskip("app.hardware.chair.ros2").Ros2Twist()
        far = output._topic._writer = Network()
        return Rig(output, far)

    def luci_rig():
        output = pytest.importorskip("app.hardware.chair.luci").LuciRemote()
        far = output._topic._writer = output._own = Network()
        return Rig(output, far)

    makers = {"whill": whill_rig, "analog": analog_rig, "ros2": ros2_rig, "luci": luci_rig}
    return lambda name: makers[name]()


def own_joystick_of_luci(rig, position):
    from app.hardware.chair.luci import LuciJoystick

    rig.far.own = [LuciJoystick(forward_back=position, left_right=0, joystick_zone=8, input_source=4)]


# Of each output each fault: how it begins, how it ends, and the reason that the receiver tells.
FAULTS = {
    ("whill", "cable pulled"): (
        lambda rig: setattr(rig.port, "pulled", True),
        lambda rig: setattr(rig.port, "pulled", False),
        Reason.OUTPUT,
    ),
    ("whill", "port hangs"): (
        lambda rig: setattr(rig.port, "hung", True),
        lambda rig: setattr(rig.port, "hung", False),
        Reason.OUTPUT,
    ),
    ("whill", "far end starts again"): (lambda rig: rig.far.reboot(), lambda _: None, Reason.OUTPUT),
    ("whill", "error"): (
        lambda rig: setattr(rig.far, "error", 12),
        lambda rig: setattr(rig.far, "error", 0),
        Reason.CHAIR_ERROR,
    ),
    ("whill", "switched off"): (
        lambda rig: setattr(rig.far, "power", 0),
        lambda rig: setattr(rig.far, "power", 1),
        Reason.CHAIR_OFF,
    ),
    ("whill", "own joystick"): (
        lambda rig: setattr(rig.far, "joystick", (0, -30)),
        lambda rig: setattr(rig.far, "joystick", (0, 0)),
        Reason.OWN_JOYSTICK,
    ),
    ("analog", "cable pulled"): (
        lambda rig: setattr(rig.port, "pulled", True),
        lambda rig: setattr(rig.port, "pulled", False),
        Reason.OUTPUT,
    ),
    ("analog", "port hangs"): (
        lambda rig: setattr(rig.port, "hung", True),
        lambda rig: setattr(rig.port, "hung", False),
        Reason.OUTPUT,
    ),
    ("analog", "far end starts again"): (lambda rig: rig.far.reboot(), lambda _: None, Reason.OUTPUT),
    ("analog", "far end hangs"): (
        lambda rig: setattr(rig.far, "dead", True),
        lambda rig: setattr(rig.far, "dead", False),
        Reason.OUTPUT,
    ),
    ("analog", "error"): (
        lambda rig: setattr(rig.far, "state", 4),
        lambda rig: setattr(rig.far, "state", 0),
        Reason.OUTPUT,
    ),
    ("analog", "commands refused"): (
        lambda rig: setattr(rig.far, "secret", bytes(32)),
        lambda rig: setattr(rig.far, "secret", SECRET),
        Reason.OUTPUT,
    ),
    ("ros2", "listener ends"): (
        lambda rig: setattr(rig.far, "listens", False),
        lambda rig: setattr(rig.far, "listens", True),
        Reason.OUTPUT,
    ),
    ("ros2", "nothing is taken"): (
        lambda rig: setattr(rig.far, "refuses", True),
        lambda rig: setattr(rig.far, "refuses", False),
        Reason.OUTPUT,
    ),
    ("luci", "listener ends"): (
        lambda rig: setattr(rig.far, "listens", False),
        lambda rig: setattr(rig.far, "listens", True),
        Reason.OUTPUT,
    ),
    ("luci", "nothing is taken"): (
        lambda rig: setattr(rig.far, "refuses", True),
        lambda rig: setattr(rig.far, "refuses", False),
        Reason.OUTPUT,
    ),
    ("luci", "own joystick"): (
        lambda rig: own_joystick_of_luci(rig, -40),
        lambda rig: own_joystick_of_luci(rig, 0),
        Reason.OWN_JOYSTICK,
    ),
}
# Nothing reaches the far end any more, so it stops only by itself: a WHILL and a driver of ROS 2 may not.
OUT_OF_REACH = {("whill", "cable pulled"), ("whill", "port hangs"), ("ros2", "nothing is taken")}
OUT_OF_REACH |= {("luci", "nothing is taken")}


@pytest.mark.parametrize("case", FAULTS, ids=", ".join)
def test_a_fault_stops_and_no_old_speed_comes_back(make, case):
    begin, end, reason = FAULTS[case]
    rig = make(case[0])
    rig.drive.drive(*SPEEDS)
    assert rig.is_moved
    begin(rig)
    rig.drive.until(lambda: rig.drive.state is not ReceiverState.ARMED, STOPPED_WITHIN, *SPEEDS, DRIVE)
    assert rig.drive.reason is reason
    nonce = rig.drive.chair.receiver.nonce
    rig.drive.run(RAMP + 0.05, *SPEEDS, DRIVE)
    assert rig.drive.chair.receiver.driven == (0.0, 0.0)
    assert rig.drive.chair.receiver.nonce == nonce, "it was disarmed once"
    assert case in OUT_OF_REACH or not rig.is_moved
    end(rig)
    rig.drive.run(0.1, *SPEEDS, DRIVE)
    for _ in range(50):  # the sender goes on with its old commands; the fault has gone
        rig.drive.run(0.02, *SPEEDS, DRIVE)
        assert rig.drive.state in (ReceiverState.DISARMED, ReceiverState.FAULT)
        assert not rig.is_moved
    rig.drive.drive(*SPEEDS)
    assert rig.is_moved


@pytest.mark.parametrize("case", FAULTS, ids=", ".join)
def test_what_is_wrong_before_arming_keeps_it_from_arming(make, case):
    begin, end, _ = FAULTS[case]
    rig = make(case[0])
    rig.drive.run(0.3)
    begin(rig)
    if case[1] == "far end starts again":
        return  # it is well again at once
    rig.drive.run(0.3)
    rig.drive.chair.epoch += 1
    for _ in range(40):
        rig.drive.run(0.02, 0.0, 0.0)
        assert rig.drive.state is ReceiverState.FAULT
    assert not rig.is_moved
    end(rig)
    rig.drive.drive(*SPEEDS)
    assert rig.is_moved


@pytest.mark.parametrize("name", ["whill", "analog"])
def test_after_the_last_command_the_board_stops_by_itself_and_a_whill_need_not(make, name):
    """Why docs/safety.md says what to try before anybody sits in a WHILL."""
    rig = make(name)
    rig.drive.drive(*SPEEDS)
    rig.drive.clock.time += 0.05
    assert rig.is_moved == (name == "whill")

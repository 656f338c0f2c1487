"""The WHILL output: its bytes and the chair's against the maker's own SDK, and what it does with a chair."""

import math
import os
import pty
import random
from itertools import pairwise

import pytest
from hardware.chair.driven_output import DrivenOutput
from hardware.chair.far_ends import MemoryPort
from hypothesis import given
from hypothesis import strategies as st
from whill import ComWHILL

from app.geometry import STANDSTILL, Twist
from app.hardware.chair import whill
from app.hardware.chair.outputs import OutputRefused, open_output
from app.hardware.chair.reasons import Reason
from app.hardware.chair.receiver import ReceiverState
from app.hardware.chair.whill_emulator import EmulatedWhill

STEP_SPEED = 0.004 / 3.6  # m/s
TREAD = 0.5  # m


class Line:
    """In place of the SDK's serial line."""

    def __init__(self):
        self.written, self.coming = [], b""

    @property
    def in_waiting(self):
        return len(self.coming)

    def write(self, content):
        self.written.append(content)

    def read(self, size=1):
        content, self.coming = self.coming[:size], self.coming[size:]
        return content


@pytest.fixture
def sdk():
    """Return the maker's SDK on a line in memory."""
    leader, follower = pty.openpty()
    made = ComWHILL(port=os.ttyname(follower))
    made.com.close()
    made.com = Line()
    yield made
    os.close(leader)
    os.close(follower)


@pytest.fixture
def chair():
    return EmulatedWhill(TREAD)


@pytest.fixture
def port(chair, monkeypatch):
    made = MemoryPort(chair, "/dev/whill")
    monkeypatch.setattr("app.hardware.chair.whill.SerialPort", lambda *_: made)
    return made


@pytest.fixture
def driven(port):
    return DrivenOutput(whill.WhillLine("/dev/whill", TREAD, "right"))


def test_a_thousand_commands_are_the_sdk_s_byte_by_byte(sdk):
    rng = random.Random(1)
    for _ in range(1000):
        front, side = rng.randint(-500, 1500), rng.randint(-750, 750)  # what the chair takes; the SDK does not look
        sdk.send_velocity(front, side)
        twist = Twist(front * STEP_SPEED, -side * STEP_SPEED / TREAD)
        assert whill.velocity_command(twist, TREAD) == sdk.com.written[-1], (front, side)


def test_the_other_commands_are_the_sdk_s_too(sdk):
    sdk.start_data_stream(50)
    sdk.release_joystick()
    assert [whill.start_command(), whill.release_command()] == sdk.com.written


def test_the_sdk_reads_the_chair_s_states_as_this_program_does(sdk, chair):
    rng = random.Random(2)
    for _ in range(200):
        chair.front, chair.side = rng.randint(-500, 1500), 2 * rng.randint(-375, 375)
        chair.joystick = (rng.randint(-100, 100), rng.randint(-100, 100))
        chair.battery, chair.power, chair.error = rng.randint(0, 100), rng.randint(0, 1), rng.randint(0, 255)
        sdk.com.coming = chair.state()
        assert sdk.refresh()
        (payload,) = whill.payloads(bytearray(chair.state()))
        ours = whill.state_of(payload)
        assert (3.6 * ours.right, 3.6 * ours.left) == pytest.approx((sdk.right_motor["speed"], sdk.left_motor["speed"]))
        assert ours.measured(TREAD, "right") == pytest.approx((chair.v, chair.omega))
        assert (ours.front, ours.side) == (sdk.joy["front"], sdk.joy["side"])
        assert (ours.battery, ours.is_on, ours.error) == (sdk.battery["level"], bool(sdk.power_status), sdk.error_code)


@given(st.lists(st.one_of(st.binary(max_size=40), st.just(None)), max_size=12), st.integers(1, 50))
def test_states_are_found_in_any_junk_in_pieces_of_any_size(parts, size):
    whole = EmulatedWhill(TREAD).state()
    content = b"".join(whole if part is None else part.replace(b"\xaf", b"") for part in parts)
    received, found = bytearray(), []
    for start in range(0, len(content), size):
        received += content[start : start + size]
        found += whill.payloads(received)
        assert len(received) <= 2 + whill.LARGEST_LENGTH
    assert found == [whole[2:-1]] * parts.count(None)


@given(st.binary(max_size=200))
def test_no_bytes_whatever_are_a_trouble(content):
    received = bytearray(content)
    for payload in whill.payloads(received):
        whill.state_of(payload)
    assert len(received) <= 2 + whill.LARGEST_LENGTH


def test_it_asks_for_states_and_leaves_the_chair_to_its_own_joystick_until_it_is_armed(driven, chair):
    driven.run(1.0)
    kinds = [payload[0] for _, payload in chair.commands]
    assert kinds[0] == 0
    assert set(kinds[1:]) == {3}
    assert len(kinds) == pytest.approx(50, abs=3)
    assert chair.own_joystick_on
    assert driven.state is ReceiverState.DISARMED


def test_it_drives_and_its_measured_speeds_come_back(driven, chair):
    driven.drive(0.4, -0.5)
    assert (chair.v, chair.omega) == (pytest.approx(0.4, abs=0.001), pytest.approx(-0.5, abs=0.003))
    assert not chair.own_joystick_on
    readings = driven.output.poll(driven.t)
    assert (readings.v, readings.omega) == (pytest.approx(0.4, abs=0.002), pytest.approx(-0.5, abs=0.006))
    assert (readings.battery, readings.obstacle) == (0.8, Reason.NONE)
    driven.run(0.6)  # silence
    assert (chair.v, chair.omega, chair.own_joystick_on) == (0.0, 0.0, True)


def test_which_motor_counts_backwards_is_an_option_and_without_it_nothing_is_measured(port, chair):
    chair.front, chair.side = 450, -100  # 0.5 m/s, to the left
    state = whill.state_of(chair.state()[2:-1])
    assert state.measured(TREAD, "right") == pytest.approx((chair.v, chair.omega))
    mirrored = state._replace(right=-state.right, left=-state.left)
    assert mirrored.measured(TREAD, "left") == pytest.approx((chair.v, chair.omega))
    plain = state._replace(right=-state.right)
    assert plain.measured(TREAD, "none") == pytest.approx((chair.v, chair.omega))
    driven = DrivenOutput(whill.WhillLine("/dev/whill", TREAD)).drive(0.4, 0.0)
    readings = driven.output.poll(driven.t)
    assert (math.isnan(readings.v), math.isnan(readings.omega), readings.battery) == (True, True, 0.8)
    assert "its right motor at -0.40 m/s and its left one at 0.40 m/s" in driven.output.description()
    assert "give the motor with the minus sign as --backward-motor" in driven.output.description()


def test_commands_keep_the_distance_that_the_chair_needs(driven, chair):
    driven.drive()
    times = [t for t, _ in chair.commands]
    assert min(later - earlier for earlier, later in pairwise(times)) >= 0.0179


def test_a_turn_is_no_faster_than_the_wheels_of_the_chair_turn(port):
    for tread in (0.3, 0.5, 0.9):
        output = whill.WhillLine("/dev/whill", tread)
        fastest = whill.velocity_command(Twist(0.0, -output.most.omega), tread)
        assert int.from_bytes(fastest[6:8], "big", signed=True) <= 750
        assert output.most.v == 1.5


@given(st.floats(allow_nan=False, min_value=-1e6, max_value=1e6), st.floats(-1e6, 1e6, allow_nan=False))
def test_no_twist_leaves_the_range_of_the_chair(v, omega):
    front, side = (
        int.from_bytes(whill.velocity_command(Twist(v, omega), TREAD)[at : at + 2], "big", signed=True) for at in (4, 6)
    )
    assert -500 <= front <= 1500
    assert -750 <= side <= 750


def test_a_charge_that_is_none_is_unknown(driven, chair):
    chair.battery = 255
    driven.run(0.3)
    assert math.isnan(driven.output.poll(driven.t).battery)


def test_it_says_what_it_found(driven, chair, port):
    assert "no WHILL reports anything on it" in driven.output.description()
    chair.joystick, chair.error = (3, -4), 7
    driven.run(0.3)
    description = driven.output.description()
    assert "A WHILL on /dev/whill: on, battery 80 %, error code 7" in description
    assert "at 3 % ahead and -4 % to the right, measured speed 0.00 m/s" in description


def test_closing_gives_the_chair_back_only_where_it_was_driven(driven, chair, port):
    driven.output.close()
    assert (chair.commands, port.closed) == ([], True)
    port.closed = False
    driven.drive(0.4, 0.0)
    driven.output.close()
    assert (chair.front, chair.own_joystick_on, port.closed) == (0, True, True)


def test_the_tread_is_asked_for_and_never_guessed():
    with pytest.raises(OutputRefused, match="the output whill needs --tread"):
        open_output("whill", {"device": "/dev/null"})


def test_standstill_is_a_command_to_stand():
    assert whill.velocity_command(STANDSTILL, TREAD) == bytes.fromhex("af07080000000000") + bytes([0xAF ^ 7 ^ 8])

"""The receiver's loop on a fake clock: a flood does not delay its limits, and the end sends a last telemetry."""

import math
from itertools import pairwise

import pytest
from fake_clock import FakeClock
from hardware.chair.commanded_receiver import KEY, CommandedReceiver

from app.geometry import STANDSTILL
from app.hardware.chair.inputs import Inputs
from app.hardware.chair.packet import DRIVE, FRAME_BYTES, decode_telemetry
from app.hardware.chair.readings import NO_READINGS, ChairReadings
from app.hardware.chair.reasons import Reason
from app.hardware.chair.receive import DRAINING, STEP, ReceiverLoop, slowness
from app.hardware.chair.receiver import ReceiverState
from app.hardware.chair.telemetry_sender import TelemetrySender

EACH = 20e-6  # s that a datagram takes: fifty thousand a second
SENDER = ("somebody", 1)


class FloodedSocket:
    """A socket with endless datagrams: junk, and at 50 Hz a command for `chair`."""

    def __init__(self, chair, clock):
        self.chair, self.clock = chair, clock
        self.due = clock.now()
        self.words = (0.0, 0.0, 0)
        self.received = 0
        self.sent = []

    def recvfrom(self, size):
        assert size == FRAME_BYTES + 1
        self.clock.time += EACH
        self.received += 1
        if self.clock.now() >= self.due:
            self.due += 0.02
            self.chair.t = self.clock.now()
            return self.chair.frame(*self.words), SENDER
        return b"BMIW\x01" + bytes(63), ("nobody", 2)

    def sendto(self, datagram, address):
        self.sent.append((decode_telemetry(datagram, KEY), address))


class OutputLog:
    """An output that keeps a log; `broken` makes it fail, `deaf` its chair silent, which has `readings`."""

    def __init__(self, is_real=False):
        self.is_real, self.broken, self.deaf = is_real, False, False
        self.readings = NO_READINGS
        self.said = []

    def poll(self, _t):
        if self.deaf:
            raise TimeoutError(110, "the chair reports nothing")
        return self.readings

    def drive(self, t, state, twist, reason):
        if self.broken:
            raise BrokenPipeError
        self.said.append((t, state, twist, reason))


@pytest.fixture
def turning(request):
    """Return a loop, its socket, its output and its receiver."""
    chair = CommandedReceiver()
    clock = FakeClock(chair.t)
    flooded, output = FloodedSocket(chair, clock), OutputLog(getattr(request, "param", False))
    telemetry = TelemetrySender(chair.receiver, KEY.id, flooded, None)
    loop = ReceiverLoop(chair.receiver, telemetry, flooded, output, Inputs(None, None), clock)
    return loop, flooded, output, chair.receiver


def ending_after(loop, output, seconds, then=lambda: None):
    """End the loop after `seconds`, and call `then`."""
    note, began = output.drive, loop._clock.now()

    def drive(t, *words):
        if t - began >= seconds and not loop.ending:
            loop.ending = True
            then()
        note(t, *words)

    output.drive = drive


def test_a_flood_neither_holds_up_the_watch_nor_a_command(turning):
    loop, flooded, output, receiver = turning

    def drive():
        flooded.words = (0.4, 0.0, DRIVE)
        ending_after(loop, output, 1.0)
        loop.ending = False

    ending_after(loop, output, 0.7, drive)
    loop.run()
    times = [t for t, *_ in output.said]
    assert max(b - a for a, b in pairwise(times)) <= STEP + 2 * EACH
    assert max(twist.v for _, _, twist, _ in output.said) == pytest.approx(0.4)
    assert receiver.reason is Reason.ENDING
    turns = 1.7 / STEP
    assert flooded.received <= turns * (DRAINING / EACH + 4), "half of the time is left to others"


@pytest.mark.parametrize("phase", range(20))
def test_silence_that_falls_due_during_a_step_is_acted_on_at_once(turning, monkeypatch, phase):
    loop, quiet, output, _ = turning
    clock, begun = quiet.clock, quiet.clock.now()
    note = output.drive

    def drive(t, *words):
        clock.time += 0.003 if clock.now() < begun + 0.66 else 0.004  # so that a command can come during a step
        note(t, *words)

    def recvfrom(_size):
        if clock.now() < quiet.due or clock.now() > begun + 0.66:
            raise BlockingIOError
        quiet.due += 0.02
        quiet.chair.t = quiet.last = clock.now()
        return quiet.chair.frame(*((0.4, 0.0, DRIVE) if clock.now() > begun + 0.56 else (0.0, 0.0, 0))), SENDER

    def wait(_sockets, _writers, _errors, timeout):
        clock.time = min(clock.time + timeout, max(quiet.due, clock.time + 1e-4))

    output.drive, quiet.recvfrom = drive, recvfrom
    monkeypatch.setattr("app.hardware.chair.receive.select.select", wait)
    ending_after(loop, output, 1.0)
    quiet.due += phase * 1e-3
    loop.run()
    driven = [(t, twist.v) for t, _, twist, _ in output.said]
    slowed = next(t for (_, before), (t, after) in pairwise(driven) if after < before)
    assert slowed - quiet.last <= 0.1 + 0.004 + 3e-4


def test_who_ends_it_while_it_drives_gets_a_ramp_and_a_last_word(turning):
    loop, _, output, receiver = turning
    receiver._v.driven = 0.75
    loop.ending = True
    loop.run()
    assert output.said[0][2].v < 0.75
    assert output.said[-1][2] == STANDSTILL
    assert output.said[-1][0] - output.said[0][0] <= 0.26
    assert all(reason == "The chair's receiver was ended." for *_, reason in output.said)


def test_telemetry_goes_to_who_drives(turning):
    loop, flooded, output, _ = turning
    ending_after(loop, output, 0.8)
    loop.run()
    assert {address for _, address in flooded.sent} == {SENDER}
    told = [telemetry for telemetry, _ in flooded.sent]
    assert {telemetry.state for telemetry in told} == {0, 1, 2}
    assert (told[-1].state, told[-1].fault, told[-1].v) == (0, Reason.ENDING, 0.0)
    pauses = [(b.t_ns - a.t_ns) * 1e-9 for a, b in pairwise(told)]
    assert max(pauses) <= 0.11 + 1e-6


def test_a_reader_who_left_ends_it(turning):
    loop, _, output, receiver = turning
    output.broken = True
    loop.run()
    assert (receiver.state, receiver.reason) == (ReceiverState.FAULT, Reason.OUTPUT)


@pytest.mark.parametrize("turning", [True], indirect=True)
def test_motors_that_take_no_commands_are_tried_again(turning):
    loop, _, output, receiver = turning
    output.broken = True
    steps = []

    def mend():
        steps.append(receiver.state)
        output.broken = len(steps) < 20
        loop.ending = len(steps) >= 40
        return False

    loop._inputs = type("Switch", (), {"stop_pressed": property(lambda _: mend()), "battery": math.nan})()
    loop.run()
    assert steps[10] is ReceiverState.FAULT
    assert steps[30] is not ReceiverState.FAULT


@pytest.mark.parametrize("turning", [True], indirect=True)
@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"deaf": True}, Reason.OUTPUT),
        ({"readings": ChairReadings(0.3, 0.1, 0.5, own_joystick=True)}, Reason.OWN_JOYSTICK),
        ({"readings": ChairReadings(trouble=Reason.CHAIR_ERROR)}, Reason.CHAIR_ERROR),
        ({"readings": ChairReadings(trouble=Reason.CHAIR_OFF)}, Reason.CHAIR_OFF),
    ],
)
def test_what_the_chair_says_stops_and_is_told(turning, change, reason, capfd):
    loop, flooded, output, _ = turning
    poll, begun = output.poll, flooded.clock.now()

    def disturbed(t):
        passed = t - begun
        flooded.words = (0.4, 0.0, DRIVE) if passed > 0.7 else (0.0, 0.0, 0)
        vars(output).update(change if passed > 1.0 else {})
        loop.ending = passed > 1.4
        return poll(t)

    output.poll = disturbed
    loop.run()
    assert max(twist.v for _, _, twist, _ in output.said) == pytest.approx(0.4)
    stopped = next(t for t, state, *_ in output.said if state == "fault")
    assert {twist.v for t, _, twist, _ in output.said if t > stopped + 0.25 + STEP} == {0.0}
    told = [telemetry for telemetry, _ in flooded.sent if telemetry.state == ReceiverState.FAULT]
    assert {telemetry.fault for telemetry in told} == {reason}
    if output.readings.own_joystick:
        assert {telemetry.own_joystick for telemetry in told} == {1}
        assert told[-1].measured_v == pytest.approx(0.3)
        assert told[-1].battery == 0.5
    assert len(capfd.readouterr().err.splitlines()) == 1


@pytest.mark.parametrize("turning", [True], indirect=True)
def test_a_trouble_that_comes_and_goes_is_told_once_a_second(turning, capfd):
    loop, flooded, output, _ = turning
    poll, begun = output.poll, flooded.clock.now()

    def flapping(t):
        output.deaf = not output.deaf
        loop.ending = t - begun > 2.5
        return poll(t)

    output.poll = flapping
    loop.run()
    lines = capfd.readouterr().err.splitlines()
    assert set(lines) == {"output: the chair reports nothing", "output: it works again"}
    assert len(lines) == 3


def test_a_machine_that_wakes_late_says_so_at_the_start():
    assert slowness(FakeClock()) == []

    class Late(FakeClock):
        def sleep_until(self, deadline):
            super().sleep_until(deadline + (0.023 if deadline > 0.2 else 0.0))

    (sentence,) = slowness(Late())
    assert "23 ms" in sentence

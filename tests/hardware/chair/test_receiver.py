"""The receiver on the chair: valid commands, silence, and hold-ups of its own."""

import math

import pytest
from hardware.chair.commanded_receiver import KEY, PERIOD, CommandedReceiver

from app.hardware.chair.link_texts import reason_text
from app.hardware.chair.packet import DRIVE, STOP, VIRTUAL, decode_telemetry
from app.hardware.chair.readings import ChairReadings
from app.hardware.chair.reasons import DESCRIPTIONS, Reason
from app.hardware.chair.receiver import Receiver, ReceiverState
from app.pipeline import stop_ramp

DISARMED, CHECKING, ARMED, FAULT = ReceiverState
STANDS = (0.0, 0.0)


def test_ten_thousand_boots_send_nothing_but_zeros():
    for boot in range(10_000):
        chair = CommandedReceiver()
        assert chair.state is DISARMED
        chair.send(1.0, 1.0, DRIVE)
        chair.send(0.0, 0.0, boot % 8)
        chair.send(1.0, 1.0, DRIVE)
        chair.step()
        assert all((v, omega) == STANDS for _, v, omega in chair.speeds)


def test_it_drives_what_it_is_told_after_half_a_second_of_zeros(chair):
    assert (chair.state, chair.told.epoch, chair.reason) == (DISARMED, 0, Reason.NONE)
    chair.send()
    assert chair.state is CHECKING
    began = chair.t
    while chair.state is CHECKING:
        chair.wait(PERIOD)
        chair.send()
    assert 0.5 <= chair.t - began <= 0.5 + PERIOD + 1e-9
    chair.command(0.6, 0.5, -0.7, DRIVE)
    assert chair.receiver.driven == pytest.approx((0.5, -0.7))
    told = chair.told
    assert (told.state, told.epoch, told.sequence, told.nonce) == (2, chair.epoch, chair.sequence, chair.receiver.nonce)
    assert (told.v, told.omega, told.fault, told.stop_input) == (pytest.approx(0.5), pytest.approx(-0.7), 0, 0)
    assert told.t_ns == pytest.approx(chair.t * 1e9)
    assert math.isnan(told.battery)
    assert (told.own_joystick, math.isnan(told.measured_v), math.isnan(told.measured_omega)) == (0, True, True)


def test_what_the_chair_says_of_itself_is_told(chair):
    readings = ChairReadings(0.25, -0.5, 0.75, own_joystick=True)
    told = decode_telemetry(chair.receiver.telemetry(chair.t, readings), KEY)
    assert (told.measured_v, told.measured_omega, told.battery, told.own_joystick) == (0.25, -0.5, 0.75, 1)
    assert (told.v, told.omega) == STANDS


@pytest.mark.parametrize("speeds", [(0.5, 0.0), (0.0, 0.5), (-1e-9, 0.0)])
def test_an_epoch_is_not_opened_by_a_command_to_move(chair, speeds):
    assert not chair.send(*speeds)
    assert not chair.send(*speeds, DRIVE)
    assert not chair.send(0.0, 0.0, STOP)
    assert chair.state is DISARMED


def test_a_command_to_move_begins_the_half_second_anew_and_is_not_driven(chair):
    chair.command(0.4)
    chair.command(PERIOD, 0.5, 0.5)
    again = chair.t
    chair.command(0.48)
    assert chair.state is CHECKING
    chair.command(0.06)
    assert chair.state is ARMED
    assert chair.t - again > 0.5
    assert all((v, omega) == STANDS for _, v, omega in chair.speeds)


def test_a_gap_begins_the_half_second_anew(chair):
    for gap, armed in ((0.08, True), (0.12, False)):
        chair.epoch += 1
        chair.command(0.4)
        chair.wait(gap)
        chair.command(0.2)
        assert (chair.state is ARMED) == armed
        chair.send(flags=STOP)


def test_the_gap_counts_also_when_nobody_looked_at_the_watch_within_it(chair):
    chair.send()
    chair.step(0.09)
    chair.t += 0.02
    chair.command(0.48)
    assert chair.state is CHECKING


def test_who_never_commands_to_stand_is_given_five_seconds(chair):
    chair.send()
    began = chair.t
    while chair.state is CHECKING:
        chair.command(PERIOD, 0.1)
    assert chair.t - began == pytest.approx(5.0, abs=3 * PERIOD)
    assert chair.reason is Reason.NOT_NEUTRAL


def test_without_the_drive_flag_it_does_not_move(chair):
    chair.arm()
    chair.command(0.3, 0.5, 0.5)
    assert chair.state is ARMED
    assert chair.receiver.driven == STANDS


def test_the_drive_flag_may_be_set_from_the_first_command_on(chair):
    chair.command(0.56, 0.0, 0.0, DRIVE)
    chair.command(0.3, 0.4, 0.0, DRIVE)
    assert chair.receiver.driven.v == pytest.approx(0.4)


def disarmed_by_sending(**changes):
    def disarm(chair):
        assert chair.send(**changes)

    return disarm


def disarmed_by(obstacle):
    def disarm(chair):
        chair.conditions = {"obstacle": obstacle}
        chair.step()
        assert chair.state is FAULT
        chair.conditions = {}
        chair.step()

    return disarm


OBSTACLES = (Reason.STOP_INPUT, Reason.OUTPUT, Reason.OWN_JOYSTICK, Reason.CHAIR_ERROR, Reason.CHAIR_OFF)
DISARMINGS = {
    Reason.STOP_COMMAND: disarmed_by_sending(flags=DRIVE | STOP),
    Reason.WITHDRAWN: disarmed_by_sending(v=0.5),
    Reason.SILENT: lambda chair: chair.wait(0.31),
    Reason.LATE: lambda chair: chair.step(0.11),
    Reason.ENDING: lambda chair: chair.receiver.stop(Reason.ENDING),
    **{obstacle: disarmed_by(obstacle) for obstacle in OBSTACLES},
}


@pytest.mark.parametrize("reason", DISARMINGS, ids=lambda reason: reason.name)
def test_every_disarming_ends_the_epoch_and_says_why_and_only_a_new_arming_drives(chair, reason):
    chair.drive()
    nonce, recorded = chair.receiver.nonce, [chair.frame(0.5, 0.0, DRIVE) for _ in range(50)]
    DISARMINGS[reason](chair)
    assert (chair.state, chair.reason, chair.told.fault) == (DISARMED, reason, reason)
    assert chair.receiver.nonce != nonce
    began = chair.t
    chair.command(0.6, 0.5, 0.0, DRIVE)  # the same epoch, even under the new nonce
    chair.command(0.6)
    assert not any(chair.receiver.accept(frame, chair.t) for frame in recorded)
    assert chair.state is DISARMED
    assert chair.receiver.driven == STANDS
    assert all(v == 0.0 for t, v, _ in chair.speeds if t > began + stop_ramp.STOP_TIME)
    assert chair.reason is reason
    chair.drive(0.3)
    assert chair.receiver.driven.v == pytest.approx(0.3)
    assert chair.reason is Reason.NONE


@pytest.mark.parametrize("reason", set(DISARMINGS) - {Reason.WITHDRAWN}, ids=lambda reason: reason.name)
def test_the_check_is_ended_by_the_same(chair, reason):
    chair.command(0.3)
    DISARMINGS[reason](chair)
    assert (chair.state, chair.reason) == (DISARMED, reason)


def test_a_drive_flag_taken_back_during_the_check_ends_it(chair):
    chair.command(0.1, flags=DRIVE)
    chair.send()
    assert (chair.state, chair.reason) == (DISARMED, Reason.WITHDRAWN)


@pytest.mark.parametrize("obstacle", OBSTACLES)
def test_while_something_forbids_motion_nothing_is_taken(chair, obstacle):
    chair.drive()
    chair.conditions = {"obstacle": obstacle}
    chair.step()
    before = chair.receiver.nonce
    assert not chair.send(flags=STOP)
    chair.epoch += 1
    assert not chair.send()
    assert chair.state is FAULT
    assert chair.receiver.nonce == before
    chair.wait(0.3)
    assert chair.receiver.driven == STANDS


def test_another_parameter_set_within_an_epoch_is_not_driven_but_stops(chair):
    chair.drive()
    assert not chair.send(0.9, 0.0, DRIVE, digest=b"another!")
    assert chair.send(0.0, 0.0, STOP, digest=b"another!")
    assert chair.reason is Reason.STOP_COMMAND


def test_what_moves_somebody_refuses_the_virtual_chairs_commands():
    chair = CommandedReceiver(refuses_virtual=True)
    assert not chair.send(flags=VIRTUAL)
    chair.drive()
    assert not chair.send(0.9, 0.0, DRIVE | VIRTUAL)
    assert CommandedReceiver().send(flags=VIRTUAL)


def test_a_command_that_waited_in_a_queue_is_not_newer(chair):
    chair.drive()
    for late, taken in ((90, True), (115, False), (2000, False)):
        t_ns = int((chair.t + chair.sender_ahead - late / 1000) * 1e9)
        assert chair.send(0.5, 0.0, DRIVE, t_ns=t_ns) == taken
        chair.command(PERIOD, 0.5, 0.0, DRIVE)
    assert chair.send(0.0, 0.0, STOP, t_ns=t_ns), "a stop is never too late"


def test_a_queue_that_stays_full_stops_the_chair(chair):
    chair.drive()
    chair.sender_ahead -= 0.4
    chair.command(0.4, 0.5, 0.0, DRIVE)
    assert chair.reason is Reason.SILENT


def test_a_clock_that_drifts_is_followed(chair):
    chair.arm()
    for _ in range(500):
        chair.sender_ahead -= 0.05 * PERIOD
        chair.command(PERIOD, 0.5, 0.0, DRIVE)
    assert chair.receiver.driven.v == pytest.approx(0.5)


def test_a_queue_that_fills_faster_than_clocks_drift_stops_the_chair(chair):
    chair.arm()
    began = chair.t
    while chair.state is ARMED:
        chair.sender_ahead -= 0.2 * PERIOD
        chair.command(PERIOD, 0.5, 0.0, DRIVE)
    assert 1.0 <= chair.t - began <= 1.6
    assert chair.reason is Reason.SILENT


@pytest.mark.parametrize("t_ns", [0, 5_000_000_000, 2**64 - 1])
def test_a_sender_without_a_clock_is_not_judged_by_it(chair, t_ns):
    chair.command(0.56, t_ns=t_ns)
    chair.command(5.0, 0.5, 0.0, DRIVE, t_ns=t_ns)
    assert chair.receiver.driven.v == pytest.approx(0.5)


@pytest.mark.parametrize("started_anew", [-300.0, 300.0])
def test_a_sender_that_was_started_anew_has_another_clock(chair, started_anew):
    chair.drive()
    chair.wait(0.4)
    chair.sender_ahead += started_anew
    chair.drive(0.3)
    assert chair.receiver.driven.v == pytest.approx(0.3)


def test_every_nonce_is_another():
    nonces = {Receiver(CommandedReceiver().receiver._key).nonce for _ in range(100)}
    assert len(nonces) == 100
    assert all(len(nonce) == 8 for nonce in nonces)


def test_every_reason_has_words():
    assert set(DESCRIPTIONS) == set(Reason)
    assert all(words.endswith(".") for words in DESCRIPTIONS.values())
    assert [str(reason_text(reason)) for reason in Reason if reason] == list(DESCRIPTIONS.values())[1:]

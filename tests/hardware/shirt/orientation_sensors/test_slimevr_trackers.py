"""Trackers over an imagined network: steady, late, lost, silent, started again, and two in one name."""

import heapq
import itertools
import math
import random

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.orientation_sensors.slime_tracker import SlimeTracker

from app.hardware.shirt.arrival_watch import ArrivalWatch
from app.hardware.shirt.orientation_sensors.orientation import exponential
from app.hardware.shirt.orientation_sensors.orientation_frames import REST_TIME, OrientationFrames
from app.hardware.shirt.orientation_sensors.placed_sensors import FrameGrid
from app.hardware.shirt.orientation_sensors.slimevr_trackers import MOST_TRACKERS, SlimeTrackers, sensor_name

RATE = 50.0
TRUNK, ARM, OTHER = "00:00:00:00:00:01", "00:00:00:00:00:02", "00:00:00:00:00:03"
HOME, AWAY = ("10.0.0.2", 6969), ("10.0.0.3", 6969)
STEP = 0.005  # s
JUNK = 100_000


class Room:
    """The server of `places`, trackers at their addresses, and the network between them."""

    def __init__(self, places, loss=0.0, jitter=0.0, seed=1):
        flex = [part for name, part in places.items() if name.endswith("/flex")]
        self.frames = OrientationFrames(places.values(), flex, RATE, from_neighbour=False)
        self.watch = ArrivalWatch()
        self.server = SlimeTrackers(places, self.frames, self.watch)
        self.clock = FakeClock(1000.0)
        self.grid = FrameGrid(self.clock, RATE)
        self.trackers = {}
        self.is_running = True
        self._loss, self._jitter = loss, jitter
        self._random = random.Random(seed)
        self._beat_t = self.clock.time
        self._on_the_way = []
        self._count = itertools.count()

    def add(self, tracker, address):
        self.trackers[address] = tracker
        return tracker

    def run(self, seconds):
        """Return the frames of some time, None for each instant without one."""
        made = []
        for _ in range(round(seconds / STEP)):
            self.clock.time += STEP
            for address, tracker in self.trackers.items():
                for datagram in tracker.step(self.clock.time):
                    self._send(datagram, address)
            while self._on_the_way and self._on_the_way[0][0] <= self.clock.time:
                self._arrive(*heapq.heappop(self._on_the_way)[2:])
            if not self.is_running:
                continue
            if self.clock.time - self._beat_t >= 1.0:
                self._beat_t = self.clock.time
                for datagram, address in self.server.heartbeats(self.clock.time):
                    self._hear(datagram, address)
            if self.clock.time >= self.grid.due:
                values = self.frames.frame(self.grid.advance())
                made.append(None if values is None else self.grid.frame(values))
        return made

    def _send(self, datagram, address):
        if self._random.random() >= self._loss:
            arrival = self.clock.time + self._random.uniform(0, self._jitter)
            heapq.heappush(self._on_the_way, (arrival, next(self._count), datagram, address))

    def _arrive(self, datagram, address):
        answer = self.server.receive(datagram, address, self.clock.time) if self.is_running else None
        if answer is not None:
            self._hear(answer, address)

    def _hear(self, datagram, address):
        if address in self.trackers:
            for answer in self.trackers[address].hear(datagram, self.clock.time):
                self._send(answer, address)


def two_trackers(**network):
    room = Room({TRUNK: "trunk", ARM: "right_forearm"}, **network)
    room.add(SlimeTracker(TRUNK), ("10.0.0.1", 6969))
    room.add(SlimeTracker(ARM), HOME)
    return room


def known(frame):
    """Return which of the six channels of a frame are known."""
    return np.isfinite(frame.values).tolist()


def test_trackers_are_answered_stay_and_give_a_frame_a_period():
    room = two_trackers()
    room.run(2 * REST_TIME)
    frames = room.run(60.0)
    assert len(frames) == pytest.approx(60 * RATE, abs=1)
    assert all(frame is not None and all(known(frame)) for frame in frames)
    assert set(np.diff([frame.seq for frame in frames])) == {1}
    assert (room.grid.lost, room.server.junk, room.server.repeated) == (0, 0, 0)
    for tracker in room.trackers.values():
        assert tracker.is_connected
        assert 55 <= tracker.heartbeats <= 65


def test_the_channels_follow_the_arm():
    room = two_trackers()
    room.run(2 * REST_TIME)
    room.trackers[HOME].orientation[0] = exponential(np.array((0.0, 0.7, 0.0)))
    *_, frame = room.run(0.1)
    np.testing.assert_allclose(frame.values, (0, 0, 0, 0, 0.7, 0), atol=1e-6)


def three_periods_long(frames):
    """Return whether the arm is known for three periods at most, and then no more."""
    is_silent = [known(frame) == [True] * 3 + [False] * 3 for frame in frames]
    return is_silent == sorted(is_silent) and is_silent.count(False) <= 4  # the one under way, too


def test_a_sensor_that_lies_still_counts_as_silent_until_it_moves():
    """Safety S5: standard firmware sends nothing of it, as of one that hangs."""
    room = two_trackers()
    room.run(2 * REST_TIME)
    arm = room.trackers[HOME]
    arm.still.add(0)
    assert three_periods_long(room.run(0.2))
    room.run(5.0)
    assert arm.is_connected
    assert room.frames.silent(room.clock.time) == ["right_forearm"]
    arm.still.clear()
    *_, frame = room.run(0.1)
    assert all(known(frame))


def test_a_sensor_that_lies_still_is_no_broken_one_and_one_that_hangs_is_found():
    """Safety S5: where acceleration comes alone, it shows that the sensor measures."""
    room = two_trackers()
    room.run(2 * REST_TIME)
    arm = room.trackers[HOME]
    arm.sends_acceleration_alone = True
    arm.orientation[0] = exponential(np.array((0.0, 0.7, 0.0)))
    room.run(0.1)
    arm.still.add(0)
    values = np.array([frame.values for frame in room.run(20.0)])
    np.testing.assert_allclose(values, np.broadcast_to((0, 0, 0, 0, 0.7, 0), values.shape), atol=1e-6)
    arm.hung.add(0)
    assert three_periods_long(room.run(0.2))
    room.run(20.0)
    assert arm.is_connected
    assert room.frames.silent(room.clock.time) == ["right_forearm"]
    arm.hung.clear()
    *_, frame = room.run(2.0)
    assert known(frame) == [True] * 3 + [False] * 3, "nobody knows what it did meanwhile"
    accepted = room.watch.accepted
    room.server.receive(arm.acceleration(), HOME, room.clock.time)
    assert (room.watch.accepted, room.watch.newest.reason) == (accepted, "idle"), "a sign of life, and no signal"
    arm.still.clear()
    *_, frame = room.run(0.1)
    assert all(known(frame))


def test_a_sensor_whose_orientation_was_never_sent_is_unknown_whatever_it_measures():
    room = two_trackers()
    room.trackers[HOME].sends_acceleration_alone = True
    room.trackers[HOME].still.add(0)
    frames = [frame for frame in room.run(2 * REST_TIME) if frame is not None]
    assert known(frames[-1]) == [True] * 3 + [False] * 3


def test_what_comes_late_or_never_costs_few_samples():
    room = two_trackers(loss=0.05, jitter=0.03)
    room.run(3 * REST_TIME)
    frames = room.run(60.0)
    assert np.mean([frame is not None and all(known(frame)) for frame in frames]) > 0.99
    assert room.grid.lost == frames.count(None) < 10
    assert room.server.repeated > 0, "a packet that was overtaken is left out"


def test_a_silent_tracker_is_nan_and_two_silent_ones_give_no_frame():
    room = two_trackers()
    room.run(2 * REST_TIME)
    arm = room.trackers.pop(HOME)
    *_, frame = room.run(0.2)
    assert known(frame) == [True] * 3 + [False] * 3
    trunk = room.trackers.pop(("10.0.0.1", 6969))
    room.run(0.1)
    assert room.run(1.0) == [None] * 50
    room.add(trunk, ("10.0.0.1", 6969))
    room.add(arm, HOME)
    *_, frame = room.run(0.5)
    assert all(known(frame))
    assert 50 <= room.grid.lost <= 60, "instants without any sample count as lost"


def test_a_tracker_that_lost_the_server_comes_back_with_its_numbers_and_its_posture_at_rest():
    room = two_trackers()
    room.run(2 * REST_TIME)
    room.is_running = False
    room.run(5.0)
    assert not room.trackers[HOME].is_connected
    room.is_running = True
    room.trackers[HOME].orientation[0] = exponential(np.array((0.0, 0.7, 0.0)))
    room.run(1.5)
    *_, frame = room.run(0.1)
    np.testing.assert_allclose(frame.values, (0, 0, 0, 0, 0.7, 0), atol=1e-6)


@pytest.mark.parametrize("handshake", [True, False])
def test_a_tracker_that_was_switched_off_and_on_has_to_be_still_again(handshake):
    room = two_trackers()
    room.run(2 * REST_TIME)
    arm = room.trackers[HOME]
    arm.start()
    arm.is_connected = not handshake  # a start so short that the tracker still has its server
    arm.hear(b"\0\0\0\1", room.clock.time)
    arm.orientation[0] = exponential(np.array((0.0, 0.0, 2.5)))  # another north
    frames = [frame for frame in room.run(3.0) if frame is not None]
    jumps = np.abs(np.diff([frame.values for frame in frames], axis=0))
    assert np.nanmax(jumps) < 0.01, "a jump could be a gesture"
    assert not all(map(all, map(known, frames)))
    assert all(known(frames[-1]))
    np.testing.assert_allclose(frames[-1].values, np.zeros(6), atol=1e-6)


def test_numbers_that_go_back_are_left_out():
    room = two_trackers()
    room.run(2 * REST_TIME)
    arm, t = room.trackers[HOME], room.clock.time
    old = arm.rotation()
    room.server.receive(arm.rotation(), HOME, t)
    arm.orientation[0] = exponential(np.array((0.0, 0.7, 0.0)))
    moved = arm.rotation()
    room.server.receive(moved, HOME, t)
    for _ in range(3):
        room.server.receive(old, HOME, t)
        room.server.receive(moved, HOME, t)
    assert room.server.repeated == 6
    frame = room.frames.frame(t)
    np.testing.assert_allclose(frame, (0, 0, 0, 0, 0.7, 0), atol=1e-6)


def test_another_program_in_the_name_of_a_tracker_is_counted_named_and_not_answered():
    room = two_trackers()
    room.run(2 * REST_TIME)
    forger = room.add(SlimeTracker(ARM), AWAY)
    forger.orientation[0] = exponential(np.array((0.0, 0.7, 0.0)))
    *_, frame = room.run(5.0)
    assert not forger.is_connected
    np.testing.assert_allclose(frame.values, np.zeros(6), atol=1e-6)
    assert room.server.sender_choice.other == "10.0.0.3:6969"
    assert room.server.sender_choice.other_frames >= 4
    real = room.trackers.pop(HOME)
    room.run(30.0)
    assert not forger.is_connected, "however long the tracker is silent, only a person chooses another"
    assert not room.server.use_sender("10.0.0.9:1")
    assert room.server.use_sender("10.0.0.3:6969")
    room.run(2.0 + REST_TIME)
    *_, frame = room.run(0.1)
    assert forger.is_connected
    assert all(known(frame))
    room.add(real, HOME)
    room.run(5.0)
    assert not real.is_connected
    assert room.server.sender_choice.other == "10.0.0.2:6969"


def test_a_program_that_was_started_again_may_come_from_another_port_of_its_machine_once_the_first_is_silent():
    room = two_trackers()
    room.run(2 * REST_TIME)
    port = (HOME[0], 40000)
    second = room.add(SlimeTracker(ARM), port)
    room.run(5.0)
    assert not second.is_connected
    del room.trackers[HOME]
    room.run(4.0)
    assert second.is_connected
    room.trackers[(HOME[0], 40001)] = third = SlimeTracker(ARM)
    del room.trackers[port]
    room.run(4.0)
    assert third.is_connected
    assert all(known(room.run(REST_TIME)[-1]))


def test_sensors_on_no_part_of_the_body_are_offered_while_they_send():
    room = two_trackers()
    room.add(SlimeTracker(OTHER, sensors=(0, 1), flex=(2,)), AWAY)
    room.run(2.0)
    assert room.server.unplaced(room.clock.time) == [OTHER, f"{OTHER}/1", f"{OTHER}/2/flex"]
    del room.trackers[AWAY]
    room.run(11.0)
    assert room.server.unplaced(room.clock.time) == []


def test_a_second_sensor_and_a_strain_sensor_have_places_of_their_own():
    hand, trunk, fingers = sensor_name(ARM, 0), sensor_name(ARM, 1), sensor_name(ARM, 2, is_flex=True)
    room = Room({hand: "left_hand", trunk: "trunk", fingers: "left_fingers"})
    arm = room.add(SlimeTracker(ARM, sensors=(0, 1), flex=(2,)), HOME)
    room.run(2 * REST_TIME)
    arm.flex[2] = 450.0
    arm.orientation[1] = exponential(np.array((0.5, 0.0, 0.0)))
    *_, frame = room.run(0.1)
    np.testing.assert_allclose(frame.values, (0.5, 0, 0, -0.5, 0, 0, 450.0), atol=1e-6)


def test_an_almost_empty_battery_is_named():
    room = two_trackers()
    room.run(1.0)
    room.server.receive(room.trackers[HOME].battery(0.5), HOME, room.clock.time)
    assert room.server.low(room.clock.time) == []
    room.server.receive(room.trackers[HOME].battery(0.1), HOME, room.clock.time)
    assert room.server.low(room.clock.time) == ["right_forearm"]


def test_junk_gives_no_frame():
    room = Room({TRUNK: "trunk"})
    source = random.Random(2)
    for i in range(JUNK):
        assert room.server.receive(source.randbytes(12 + i % 40), ("10.0.0.9", i % 5), room.clock.time) is None
    assert room.server.junk == JUNK
    assert room.frames.frame(room.clock.time) is None


def test_packets_of_a_sender_who_has_not_greeted_are_left_out():
    room = Room({TRUNK: "trunk"})
    assert room.server.receive(SlimeTracker(TRUNK).rotation(), HOME, room.clock.time) is None
    assert room.frames.frame(room.clock.time) is None


def test_a_flood_of_trackers_fills_no_memory_and_keeps_none_of_the_body_out():
    room = two_trackers()
    for i in range(1000):
        mac = ":".join(f"{byte:02X}" for byte in i.to_bytes(6, "big", signed=False)[::-1])
        answer = room.server.receive(SlimeTracker(mac).handshake(), ("10.1.0.1", i), room.clock.time)
        assert (answer is not None) == (0 < i <= MOST_TRACKERS)
    assert room.watch.newest.reason == "unplaced", "nobody sends in the name of another"
    room.run(2 * REST_TIME)
    assert all(known(room.run(0.1)[-1]))
    room.run(10.0)
    assert room.server.receive(SlimeTracker(OTHER).handshake(), AWAY, room.clock.time) is not None
    assert len(room.server.heartbeats(room.clock.time)) == 3


def test_a_pinned_tracker_may_turn_its_clock_of_packets_over():
    """A number of 64 bits never ends, but its lower half may: of a tracker that has run for years."""
    room = two_trackers()
    arm = room.trackers[HOME]
    arm.number = 2**32 - 100
    room.run(2 * REST_TIME)
    assert all(all(known(frame)) for frame in room.run(4.0))
    assert arm.number > 2**32
    assert math.isfinite(room.grid.due)

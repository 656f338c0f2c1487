"""What is sent over LSL: every tick with its time, gestures by their names, marks of trials, cues and stops."""

import numpy as np
import pytest
from fake_clock import FakeClock
from features.lsl.lsl_ring import Names, Ring, described
from hardware.shirt.fake_lsl import FakeLsl
from hardware.shirt.lsl_networks import ANSWER, networks

from app.cues import Cue
from app.faults import Fault, State
from app.features.lsl.outlets import (
    GESTURE,
    TICKS,
    MarkFinder,
    gesture_samples,
    gestures_stream,
    markers_stream,
    opened_outlet,
    tick_samples,
    ticks_stream,
)
from app.features.lsl.service import NAMED_WITHIN, TickSender
from app.lsl_library import OWN_SOURCE, lsl_ahead
from app.messages import MAX_GESTURES, NO_CUE, TICK

RATE = 100.0

network = pytest.fixture(scope="module", name="network")(networks)


class Sent:
    """A sender with all that it needs, and what it has sent."""

    def __init__(self):
        self.clock = FakeClock(70.0)
        self.lsl = FakeLsl(self.clock)
        self.ring, self.names = Ring(), Names()
        self.ring.add(69.0)  # of before
        self.sender = TickSender(self.lsl, self.ring, self.names, self.clock)

    def outlet(self, name):
        return next(outlet for outlet in reversed(self.lsl.outlets) if outlet.info.name() == f"bodydrive {name}")

    @property
    def markers(self):
        return [(round(t - self.lsl.offset, 6), row[0]) for t, row in self.outlet("markers").sent]

    def tick(self, **fields):
        self.clock.time += 1.0 / RATE
        self.ring.add(self.clock.time, **fields)

    def send(self):
        self.sender.send()


@pytest.fixture
def sent():
    return Sent()


def test_every_tick_is_sent_once_with_its_time_on_the_clock_of_lsl(sent):
    for i in range(300):
        sent.tick(u1=i / 300, v=0.5, state=State.ARMED, x=i)
        if i % 7 == 0:
            sent.send()
    sent.send()
    sent.send()
    outlet = sent.outlet("ticks")
    columns = [name for name, _ in TICKS]
    assert len(outlet.sent) == 300
    times = np.array([t for t, _ in outlet.sent])
    np.testing.assert_allclose(times - sent.lsl.offset, 70.0 + np.arange(1, 301) / RATE, atol=1e-9)
    values = np.array([row for _, row in outlet.sent])
    np.testing.assert_allclose(values[:, columns.index("u1")], np.arange(300) / 300)
    assert set(values[:, columns.index("state")]) == {State.ARMED}
    np.testing.assert_array_equal(values[:, columns.index("x")], np.arange(300))


def test_nothing_of_before_the_start_is_sent(sent):
    sent.send()
    assert sent.outlet("ticks").sent == []


def test_the_streams_describe_their_channels_units_codes_and_source():
    lsl = FakeLsl(FakeClock())
    for stream in (ticks_stream(), gestures_stream(["lean"]), markers_stream()):
        info = opened_outlet(lsl, stream, "desk").info
        assert info.channel_count() == len(described(info)) == len(stream.channels)
        assert tuple(described(info)) == stream.channels
        assert info.nominal_srate() == 0.0
        assert info.source_id() == f"{OWN_SOURCE}{stream.name.split()[1]}.desk"
        assert info.desc().child("acquisition").child_value("manufacturer") == "bodydrive"
    ticks = next(outlet.info for outlet in lsl.outlets if outlet.info.type() == "Control")
    codes = ticks.desc().child("codes")
    assert codes.child("state").child_value("armed") == str(int(State.ARMED))
    assert codes.child("fault").child_value("shirt_silent") == str(int(Fault.SHIRT_SILENT))
    assert (markers_stream().kind, markers_stream().is_text) == ("Markers", True)
    assert ("omega", "rad/s") in TICKS
    assert {name for name, _ in TICKS} <= set(TICK.names)


def test_the_samples_of_gestures_are_in_the_order_of_their_labels():
    ticks = np.zeros(3, dtype=TICK)
    for i, (name, _) in enumerate(GESTURE):
        ticks[name] = 100 * i + np.arange(MAX_GESTURES)
    labels = [label for label, _ in gestures_stream(["lean", "shrug"]).channels]
    assert labels == [f"{field}.{name}" for field, _ in GESTURE for name in ("lean", "shrug")]
    np.testing.assert_array_equal(gesture_samples(ticks, 2), [[0, 1, 100, 101, 200, 201]] * 3)
    assert tick_samples(ticks).shape == (3, len(TICKS))
    assert tick_samples(ticks).flags["C_CONTIGUOUS"]


def test_gestures_are_sent_by_name_and_described_anew_when_others_are_decoded(sent):
    activation = np.zeros(MAX_GESTURES)
    activation[:2] = 0.25, 0.75
    sent.tick(n_gestures=2, activation=activation)
    sent.tick(n_gestures=0)
    sent.send()
    outlet = sent.outlet("gestures")
    labels = [label for label, _ in described(outlet.info)]
    ((_, row),) = outlet.sent
    assert dict(zip(labels, row, strict=True))["activation.shrug"] == 0.75
    sent.names.decoded = []  # nobody is here: the stream stays, without samples
    sent.send()
    assert sent.outlet("gestures") is outlet
    sent.names.decoded = ["nod"]
    sent.tick(n_gestures=1, activation=activation)
    sent.send()
    other = sent.outlet("gestures")
    assert other is not outlet
    assert other.info.source_id() == outlet.info.source_id()
    assert [row[-1] for _, row in other.sent] == [0.25]


def test_a_trial_its_stop_and_its_end_are_marked_at_the_times_of_their_ticks(sent):
    sent.names.runs[4] = "trial 12"
    sent.tick()
    sent.tick(run=4)
    sent.tick(run=4, state=State.ARMED)
    sent.tick(run=4, state=State.FAULT, fault=Fault.STOP_TABLET, stops=1)
    sent.tick(run=4, state=State.FAULT, fault=Fault.STOP_TABLET, stops=2)
    sent.tick(run=4, state=State.ARMED, stops=2)
    sent.tick(run=4, state=State.DISARMED, fault=Fault.SCREEN_SLOW, stops=2)
    sent.tick(run=4, state=State.FAULT, fault=Fault.SHIRT_SILENT, stops=3)
    sent.tick(stops=3)
    sent.send()
    assert sent.markers == [
        (70.02, "start trial 12"),
        (70.04, "stop stop_tablet"),
        (70.05, "stop stop_tablet"),
        (70.06, "clear"),
        (70.07, "pause screen_slow"),
        (70.08, "fault shirt_silent"),
        (70.09, "end trial 12"),
        (70.09, "clear"),
    ]


def test_cues_are_marked_with_what_they_ask(sent):
    sent.names.runs[2] = "recording prompt"
    sent.names.cues[2] = [
        Cue(start=0.0, end=1.0, kind="ready"),
        Cue(start=1.0, end=2.0, kind="move", joint="right_elbow", repetition=2),
    ]
    for cue in (0, 0, 1, NO_CUE):
        sent.tick(run=2, cue=cue)
    sent.tick()
    sent.send()
    assert [text for _, text in sent.markers] == [
        *("start recording prompt", "cue ready", "cue move right_elbow 2", "cue none", "end recording prompt"),
    ]


def test_a_marker_waits_for_the_name_of_its_run_but_not_for_ever(sent):
    sent.tick(run=1)
    sent.send()
    assert sent.markers == []
    sent.names.runs[1] = "drive 3"
    sent.tick(run=1)
    sent.send()
    assert sent.markers == [(70.01, "start drive 3")]
    del sent.names.runs[1]  # it has ended meanwhile
    sent.tick()
    sent.send()
    assert sent.markers[1:] == [(70.03, "end drive 3")]
    sent.tick(run=2, cue=5)
    sent.send()
    assert len(sent.markers) == 2
    sent.clock.time += NAMED_WITHIN
    sent.send()
    assert [text for _, text in sent.markers[2:]] == ["start run 2", "cue 5"]


def test_the_end_of_the_control_process_ends_its_run_and_the_next_one_counts_from_one(sent):
    sent.names.runs[1] = "trial 9"
    for _ in range(3):
        sent.tick(run=1, stops=4)
    sent.send()
    sent.ring.alive = False
    sent.send()
    sent.send()
    assert [text for _, text in sent.markers] == ["start trial 9", "end trial 9", "fault control_lost"]
    sent.ring.begin_anew()
    sent.tick(x=7.0)
    sent.send()
    columns = [name for name, _ in TICKS]
    assert len(sent.outlet("ticks").sent) == 4
    assert sent.outlet("ticks").sent[-1][1][columns.index("x")] == 7.0
    assert len(sent.markers) == 3


def test_a_restart_between_two_looks_is_noticed_by_the_numbers(sent):
    for _ in range(50):
        sent.tick()
    sent.send()
    sent.ring.begin_anew()
    sent.tick()
    sent.send()
    assert len(sent.outlet("ticks").sent) == 51


def test_after_the_machine_slept_the_time_stamps_follow_the_clock_of_lsl(sent):
    sent.tick()
    sent.send()
    sent.lsl.offset -= 600.0  # our clock went on, LSL's stood
    sent.tick()
    sent.send()
    first, last = (t for t, _ in sent.outlet("ticks").sent)
    assert last - first == pytest.approx(1.0 / RATE - 600.0)


def test_samples_are_made_only_for_receivers(sent):
    sent.outlet("ticks").consumers = False
    sent.tick()
    sent.send()
    sent.outlet("ticks").consumers = True
    sent.tick()
    sent.send()
    assert len(sent.outlet("ticks").sent) == 1


@pytest.mark.parametrize("state", list(State))
def test_a_fault_that_was_there_before_is_marked_once(state):
    finder = MarkFinder()
    ticks = np.zeros(5, dtype=TICK)
    ticks["cue"], ticks["fault"], ticks["state"], ticks["stops"] = NO_CUE, Fault.SHIRT_RATE, state, 3
    found = finder.marks(ticks) + finder.marks(ticks)
    assert [mark.what for mark in found] == ["fault" if state is State.FAULT else "pause"]


def test_what_pylsl_receives_is_what_was_driven(network):
    net = network("pylsl")
    ring, names = Ring(), Names()
    names.runs[1] = "trial 12"
    sender = TickSender(net.lsl, ring, names, net.clock)
    sender.send()
    until, found = net.clock.now() + ANSWER, {}
    while len(found) < 3 and net.clock.now() < until:
        infos = [info for info in net.lsl.resolve_streams(1.0) if info.source_id().startswith(OWN_SOURCE)]
        found = {info.type(): info for info in infos}
    inlets = {kind: net.lsl.StreamInlet(info, recover=False) for kind, info in found.items()}
    for inlet in inlets.values():
        inlet.open_stream(ANSWER)
    for outlet in (sender._ticks, sender._gestures, sender._markers):
        assert outlet.wait_for_consumers(ANSWER)
    start = net.clock.now()
    for i in range(50):
        ring.add(start + i / RATE, run=1, u1=i / 50, n_gestures=2)
    sender.send()
    columns = [name for name, _ in TICKS]
    got = [inlets["Control"].pull_sample(ANSWER) for _ in range(50)]
    assert [row[columns.index("u1")] for row, _ in got] == [i / 50 for i in range(50)]
    expected = start + np.arange(50) / RATE + lsl_ahead(net.lsl, net.clock)
    np.testing.assert_allclose([t for _, t in got], expected, atol=0.01)
    text, t = inlets["Markers"].pull_sample(ANSWER)
    assert (text, t) == (["start trial 12"], pytest.approx(expected[0], abs=0.01))
    row, _ = inlets["Gestures"].pull_sample(ANSWER)
    assert len(row) == 3 * len(names.decoded)
    assert described(inlets["Control"].info(ANSWER)) == list(TICKS)

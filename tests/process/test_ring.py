"""The ring between the processes: no torn tick, none out of order, and every missing tick is counted."""

import math
import subprocess
import sys
import uuid

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.faults import Fault, State
from app.messages import MAX_GESTURES, TICK, Tick
from app.process.ring import RING_SLOTS, TickRing, ring_file
from building import make_ring

WRITER = """
import sys
import numpy as np
from app.messages import Tick
from app.process.ring import TickRing

ring = TickRing.create(sys.argv[1])
print("ready", flush=True)
sys.stdin.readline()
values = np.empty(64, dtype=np.float32)
tick = Tick(values=values, score=[0.0] * 16, rate=[0.0] * 16, activation=[0.0] * 16)
for number in range(1, int(sys.argv[2]) + 1):
    values[:] = number
    tick.t = tick.t_device = tick.u1 = tick.u2 = tick.x = tick.y = tick.theta = float(number)
    tick.frame_seq = tick.contacts = number
    tick.score[:] = tick.rate[:] = tick.activation[:] = [float(number)] * 16
    ring.write(tick, number, float(number), number, number, number)
print("written", flush=True)
sys.stdin.readline()
ring.unlink()
"""


@pytest.fixture
def name():
    return f"bodydrive-test-{uuid.uuid4().hex}"


@pytest.fixture
def ring(name):
    made = TickRing.create(name)
    yield made
    made.unlink()
    made.close()


SCALARS = (
    {"t": 1.5, "frame_seq": 7, "t_device": 2.5, "u1": -1.0, "u2": 0.25, "v": 0.8, "omega": -1.2}
    | {"x": 3.0, "y": 4.0, "theta": -3.0, "state": State.FAULT, "fault": Fault.STOP_KEY, "stops": 9, "dial": 0.5}
    | {"chair_kind": 1, "chair_state": 2, "chair_fault": 8, "stop_input": 1, "chair_age": 0.125, "battery": 0.75}
    | {"own_joystick": 1, "measured": 1}
    | {"driven_v": 0.25, "driven_omega": -0.5, "scene_t": 1.5, "contacts": 3}
    | {"head_yaw": 0.25, "head_pitch": -0.125, "head_roll": 0.5, "head_age": 0.0625}
)
OF_THE_LOOP = {"run": 2, "run_t": 0.75, "cue": 4, "lost": 5, "late": 6}


def test_what_is_written_is_read(ring, name):
    values = np.arange(52, dtype=np.float32)
    lists = {"score": [0.1, 0.2], "rate": [0.3, 0.4], "activation": [0.5, 0.6]}
    tick = Tick(values=values, in_contact=True, **lists, **SCALARS)
    ring.write(tick, *OF_THE_LOOP.values())
    reader = TickRing.attach(name)
    read = reader.newest()
    counted = {"number": 1, "n_channels": 52, "n_gestures": 2, "has_frame": 1, "in_contact": 1}
    for field, value in (SCALARS | OF_THE_LOOP | counted).items():
        assert read[field] == value, field
    assert read["values"][:52].tolist() == values.tolist()
    assert read["score"].tolist() == [0.1, 0.2] + [0.0] * (MAX_GESTURES - 2)
    assert read["rate"][:2].tolist() == [0.3, 0.4]
    assert read["activation"][:2].tolist() == [0.5, 0.6]
    reader.close()


def test_an_empty_ring_has_nothing_newest(ring):
    assert ring.newest() is None
    ticks, missed = ring.since(0)
    assert len(ticks) == 0
    assert missed == 0
    assert ticks.dtype == TICK


def test_a_tick_without_frame_shows_no_old_values(ring):
    ring.write(Tick(values=np.ones(52, dtype=np.float32)), 0, math.nan, -1, 0, 0)
    for _ in range(RING_SLOTS):
        ring.write(Tick(), 0, math.nan, -1, 0, 0)
    newest = ring.newest()
    assert newest["has_frame"] == 0
    assert newest["n_channels"] == 52
    assert np.isnan(newest["values"]).all()


@given(written=st.integers(0, 2 * RING_SLOTS + 5), asked=st.integers(0, 2 * RING_SLOTS + 10))
@settings(max_examples=15, deadline=None)
def test_read_and_missed_add_up(written, asked):
    ring = make_ring()
    tick = Tick()
    for _ in range(written):
        ring.write(tick, 0, math.nan, -1, 0, 0)
    ticks, missed = ring.since(asked)
    assert len(ticks) + missed == max(0, written - asked)
    assert ticks["number"].tolist() == list(range(asked + 1 + missed, written + 1))
    ring.close()


def test_a_slot_that_is_being_written_is_not_returned(ring):
    for _ in range(10):
        ring.write(Tick(), 0, math.nan, -1, 0, 0)
    ring._numbers[4] = 0  # as if the writer had just begun to overwrite the oldest of what a slow reader copies
    ticks, missed = ring.since(0)
    assert ticks["number"].tolist() == [5, 6, 7, 8, 9, 10]
    assert missed == 4
    ring._numbers[10] = 0
    assert ring.newest() is None


def test_a_name_of_a_ring_is_used_once(ring, name):
    with pytest.raises(FileExistsError):
        TickRing.create(name)


def test_readers_get_no_torn_tick_from_a_writer_at_full_speed(name):
    count = 150_000
    writer = subprocess.Popen(
        [sys.executable, "-c", WRITER, name, str(count)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        assert writer.stdout.readline() == "ready\n"
        ring = TickRing.attach(name)
        print(file=writer.stdin, flush=True)
        last = total_missed = reads = 0
        while last < count:
            newest = ring.newest()
            if newest is not None:
                assert is_whole(np.array([newest]))
            ticks, missed = ring.since(last)
            if len(ticks):
                assert ticks["number"][0] == last + missed + 1
                assert (np.diff(ticks["number"]) == 1).all()
                assert is_whole(ticks)
                reads += 1
                total_missed += missed
                last = int(ticks["number"][-1])
        assert reads > 2
        assert total_missed < count
        ring.close()
    finally:
        _, complaints = writer.communicate("\n")
    assert complaints == ""


def is_whole(ticks):
    number = ticks["number"].astype(np.float64)
    single = ["t", "t_device", "run_t", "u1", "u2", "x", "y", "theta"]
    counts = ["frame_seq", "contacts", "run", "cue", "lost", "late"]
    lists = ["score", "rate", "activation"]
    return (
        all((ticks[field] == number).all() for field in single + counts)
        and all((ticks[field] == number[:, np.newaxis]).all() for field in lists)
        and (ticks["values"] == number.astype(np.float32)[:, np.newaxis]).all()
    )


def test_a_reader_that_ends_leaves_the_memory_and_prints_nothing(ring, name):
    ring.write(Tick(t=5.0), 0, math.nan, -1, 0, 0)
    code = "import sys; from app.process.ring import TickRing; print(TickRing.attach(sys.argv[1]).newest()['t'])"
    for _ in range(2):
        seen = subprocess.run([sys.executable, "-c", code, name], capture_output=True, text=True, check=True)
        assert (seen.stdout, seen.stderr) == ("5.0\n", "")
    assert ring_file(name).exists()

"""Checking, fitting and measuring from recordings on disk."""

import itertools
import math
import uuid
from dataclasses import replace

import numpy as np
import pytest

from app.calibration.script import calibration_script
from app.cues import cue_index
from app.faults import State
from app.layout import Channel, Joint, ShirtLayout
from app.messages import Tick
from app.process.ring import TickRing
from app.recording.recorded_trajectory import read_trajectory
from app.recording.writer import RunWriter
from app.session.recordings import check_recording, fit_recordings, judge_step, measure_recording
from app.world.floorplan import FloorPlan, PrescribedPath

RATE = 100.0
JOINTS = ("right_elbow", "left_elbow")
LAYOUT = ShirtLayout(
    name="Small",
    channels=tuple(Channel(name=f"{joint}_{i}", joint=joint) for joint in JOINTS for i in (1, 2)),
    joints=tuple(Joint(name=joint, label=joint) for joint in JOINTS),
)
PATH = PrescribedPath(name="main", title="Main", points=((0.0, 0.0), (10.0, 0.0)), instruction="Drive.")
PLAN = FloorPlan(name="p", title="P", walls=(), paths=(PATH,))


def record(folder, ticks, cues=()):
    ring = TickRing.create(f"bodydrive-test-{uuid.uuid4().hex[:12]}")
    try:
        meta = {"sample_rate": RATE, "layout": LAYOUT.model_dump(mode="json"), "gestures": []}
        writer = RunWriter(folder, meta, len(LAYOUT.channels), 0)
        for number, tick in enumerate(ticks):
            ring.write(tick, 1, number / RATE, cue_index(cues, number / RATE), 0, 0)
        writer.start(ring, 0, 1)
        writer.close(ring.number)
    finally:
        ring.unlink()
        ring.close()
    return folder


def step_ticks(step, seed=0):
    """Return ticks of joints that follow the cues, through two channels each, with noise."""
    random = np.random.default_rng(seed)
    for number in range(round(step.duration * RATE) + 1):
        t = number / RATE
        cue = step.cues[cue_index(step.cues, t)] if cue_index(step.cues, t) >= 0 else None
        angle = dict.fromkeys(JOINTS, 0.0)
        if cue is not None and cue.kind == "free":
            angle = {"right_elbow": 0.5 - 0.5 * math.cos(4 * t), "left_elbow": 0.5 - 0.5 * math.cos(3 * t)}
        if cue is not None and cue.joint and cue.kind in {"move", "return"}:
            share = (t - cue.start) / (cue.end - cue.start)
            angle[cue.joint] = 0.5 - 0.5 * math.cos(math.pi * (share if cue.kind == "move" else 1 - share))
        values = [gain * angle[joint] for joint in JOINTS for gain in (1.0, -0.6)]
        values = np.array(values) + random.normal(0, 0.002, 4)
        yield Tick(t=t, t_device=t, frame_seq=number, values=values.astype(np.float32))


@pytest.fixture
def recorded(tmp_path):
    steps = calibration_script(LAYOUT)
    return [(step, record(tmp_path / step.id, step_ticks(step), step.cues)) for step in steps]


def unrelated_ticks(step, seed):
    """Return ticks of signals that sway on their own, whatever the cue says."""
    random = np.random.default_rng(seed)
    starts = random.uniform(0, 6.28, 8)
    for number in range(round(step.duration * RATE) + 1):
        t = number / RATE
        slow = [math.sin((3.0 + 0.6 * i) * t + starts[i]) for i in range(4)]
        values = np.array(slow) + random.normal(0, 0.002, 4)
        yield Tick(t=t, t_device=t, frame_seq=number, values=values.astype(np.float32))


def test_steps_that_follow_the_cue_need_no_words(recorded):
    for at in range(len(recorded)):
        assert judge_step(LAYOUT, recorded[: at + 1], [], recorded[at][0]) is None


def test_signals_that_have_nothing_to_do_with_the_cue_are_told_when_each_step_ends(tmp_path):
    recorded = []
    for seed, step in enumerate(calibration_script(LAYOUT)):
        recorded.append((step, record(tmp_path / step.id, unrelated_ticks(step, seed), step.cues)))
        words = judge_step(LAYOUT, recorded, [], step)
        assert bool(words) is (step.kind != "rest"), step.id  # how still a rest was is known once something moved
    profile = fit_recordings(LAYOUT, recorded, [], None)
    for step, _ in recorded:
        if step.kind == "prompt":  # the words of the result
            joint = next(joint for joint in profile.joints if joint.name == step.joint)
            assert joint.has_to_be_repeated
            assert judge_step(LAYOUT, recorded, [], step) == joint.description


@pytest.mark.parametrize("seed", range(6))
def test_a_free_movement_without_any_movement_is_told_also_where_noise_rises_by_chance(tmp_path, seed):
    def still(step, seed):
        for tick in unrelated_ticks(step, seed):
            noise = np.random.default_rng((seed, tick.frame_seq)).normal(0, 0.002, 4).astype(np.float32)
            yield replace(tick, values=noise)

    steps = calibration_script(LAYOUT)[:2]
    recorded = [(step, record(tmp_path / step.id, still(step, seed), step.cues)) for step in steps]
    unused = ["right_elbow_1", "left_elbow_1"]  # the main movement of a single sensor is always clear
    assert "No joint moves clearly enough." in str(judge_step(LAYOUT, recorded, unused, steps[1]))


def test_a_joint_without_a_usable_sensor_is_told_when_its_step_ends(recorded):
    unused = ["left_elbow_1", "left_elbow_2"]
    step = next(step for step, _ in recorded if step.joint == "left_elbow")
    assert "None of its sensors can be used" in str(judge_step(LAYOUT, recorded, unused, step))
    assert judge_step(LAYOUT, recorded[2:], [], step) is None  # rest and free movement are not there yet


def test_a_calibration_is_fitted_from_its_recordings_alone(recorded):
    for step, folder in recorded:
        assert check_recording(folder, step.duration) is None
    profile = fit_recordings(LAYOUT, recorded, [], None)
    assert all(joint.map == "pca" for joint in profile.joints)
    assert [(joint.name, joint.guided.repetitions) for joint in profile.joints] == [(joint, 3) for joint in JOINTS]
    for joint in profile.joints:
        assert joint.prompted
        assert joint.evr > 0.95
        assert joint.direction[0] > 0  # the first channel rises with the movement
    without = fit_recordings(LAYOUT, recorded, ["left_elbow_1"], None)
    assert "left_elbow_1" in without.left_out


def test_a_step_whose_shirt_fell_silent_is_not_taken(tmp_path):
    step = calibration_script(LAYOUT)[0]
    ticks = list(step_ticks(step))
    for tick in ticks[100:140]:
        tick.values = None
    folder = record(tmp_path / "rest", ticks, step.cues)
    assert "silent for 0.4 seconds" in str(check_recording(folder, step.duration))


def trial_ticks(state_at):
    for number in range(1101):
        t = number / RATE
        yield Tick(t=50.0 + t, x=max(0.0, t - 1.0), y=0.0, v=1.0, state=state_at(t), u1=0.5)


def test_a_trial_is_measured_from_when_motion_was_permitted(tmp_path):
    folder = record(tmp_path / "a", trial_ticks(lambda t: State.CHECKING if t < 1.0 else State.ARMED))
    measures = measure_recording(folder, PLAN, PLAN.paths[0])
    assert measures["reached"] is True
    assert 9.4 <= measures["time"] <= 10.1  # within the goal's radius
    assert 9.4 <= measures["dist"] <= 10.1
    assert measures["e_diff"] == pytest.approx(0.0, abs=1e-6)
    line = read_trajectory(folder)
    assert (line.t[0], line.x[0]) == (0.0, 0.0)
    assert all(before <= after for before, after in itertools.pairwise(line.x))


def test_a_trial_that_never_moved_has_no_measures(tmp_path):
    folder = record(tmp_path / "a", trial_ticks(lambda _t: State.CHECKING))
    with pytest.raises(ValueError, match="never permitted to move"):
        measure_recording(folder, PLAN, PLAN.paths[0])
    with pytest.raises(ValueError, match="no recording"):
        read_trajectory(tmp_path / "nowhere")

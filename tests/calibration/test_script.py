"""The script of the calibration, and the repetitions that are cut from what was recorded."""

import numpy as np
import pytest
from calibration.simulated_person import layout_of

from app.calibration.fit.repetitions import Prompt, repetitions_of_prompts, repetitions_of_run
from app.calibration.prompts_file import read_prompts
from app.calibration.script import REPETITIONS, calibration_script
from app.cues import Cue, cue_index
from app.messages import NO_CUE

STEPS = calibration_script(layout_of(("right_elbow", "left_shoulder", "right_wrist", "tongue")))


def test_steps_come_in_order_with_ids_of_their_own():
    assert [step.kind for step in STEPS] == ["rest", "free", *["prompt"] * 4]
    assert [step.joint for step in STEPS[2:]] == ["right_elbow", "left_shoulder", "right_wrist", "tongue"]
    assert len({step.id for step in STEPS}) == len(STEPS)


def test_patients_are_asked_in_plain_words():
    assert [step.title for step in STEPS[2:]] == [
        "Bend your right elbow",
        "Push your left shoulder forward",
        "Bend your right wrist",
        "Move: Tongue",
    ]


@pytest.mark.parametrize("step", STEPS, ids=lambda step: step.id)
def test_cues_fill_the_step_without_a_gap(step):
    assert step.cues[0].kind == "ready"
    assert step.cues[0].start == 0.0
    assert step.cues[0].end == pytest.approx(2.0)
    for before, after in zip(step.cues, step.cues[1:], strict=False):
        assert after.start == before.end
    assert step.cues[-1].end == step.duration


def test_rest_and_free_movement_last_as_long_as_the_paper_says():
    lengths = {cue.kind: cue.end - cue.start for step in STEPS[:2] for cue in step.cues}
    assert lengths["rest"] == pytest.approx(3.0)
    assert lengths["free"] == pytest.approx(10.0)


def test_somebody_new_may_drive_by_other_people_s_map_after_less_than_half_a_minute():
    before = [step.duration for step in STEPS if step.kind in ("rest", "free")]
    assert STEPS[len(before)].kind == "prompt"  # nothing else comes before
    assert sum(before) < 30.0


def test_each_gesture_is_prompted_three_times_and_comes_back_slower():
    for step in STEPS[2:]:
        moves = [cue for cue in step.cues if cue.kind == "move"]
        returns = [cue for cue in step.cues if cue.kind == "return"]
        assert [cue.repetition for cue in moves] == list(range(1, REPETITIONS + 1))
        assert all(cue.joint == step.joint for cue in step.cues)
        assert all(back.end - back.start > move.end - move.start for move, back in zip(moves, returns, strict=True))


def test_cue_index_follows_the_clock():
    cues = (Cue(start=1.0, end=2.0, kind="rest"), Cue(start=2.0, end=3.0, kind="free"))
    assert [cue_index(cues, t) for t in (0.5, 1.0, 1.99, 2.0, 3.0)] == [NO_CUE, 0, 0, 1, NO_CUE]


FS = 100.0
LAYOUT = layout_of()


def counted(n):
    """Return frames with their row number in channel 0, so that a wrong cut is found."""
    return np.arange(n, dtype=np.float64)[:, np.newaxis] * np.ones(20)


def test_a_recorded_step_gives_its_three_repetitions():
    step = calibration_script(LAYOUT)[2]
    t = np.arange(round(step.duration * FS)) / FS
    cue = np.array([cue_index(step.cues, seconds + 1e-9) for seconds in t])
    found = repetitions_of_run(counted(len(t)), cue, step.cues, FS)
    assert [one.joint for one in found] == ["right_elbow"] * 3
    for one, start in zip(found, (2.0, 5.5, 9.0), strict=True):
        assert one.values[one.moving][0, 0] == pytest.approx(start * FS)
        assert one.values[one.moving][-1, 0] == pytest.approx((start + 1) * FS - 1)
        assert one.values[0, 0] == pytest.approx(start * FS - 50)


def test_a_table_of_prompts_is_cut_with_what_is_around_it():
    t = np.arange(1000) / FS
    one, other = repetitions_of_prompts(
        t, counted(1000), [Prompt(9.5, 12.0, "left_elbow"), Prompt(0.2, 1.2, "right_elbow")], FS
    )
    assert (one.joint, other.joint) == ("right_elbow", "left_elbow")
    assert one.values[:, 0].tolist() == list(range(220))
    assert one.values[one.moving][:, 0].tolist() == list(range(20, 120))
    assert other.values[other.moving][:, 0].tolist() == list(range(950, 1000))


def test_overlapping_rows_of_one_joint_are_one_repetition():
    t = np.arange(1000) / FS
    rows = [Prompt(1, 2, "left_elbow"), Prompt(1.5, 2.5, "left_elbow"), Prompt(1.6, 1.9, "right_elbow")]
    found = repetitions_of_prompts(t, counted(1000), rows, FS)
    assert [(one.joint, one.moving.stop - one.moving.start) for one in found] == [
        ("left_elbow", 150),
        ("right_elbow", 30),
    ]


def table(folder, text):
    file = folder / "prompts.csv"
    file.write_text(text)
    return file


def test_a_table_of_prompts_is_read(tmp_path):
    file = table(tmp_path, "joint,start,end,remark\nleft_elbow,1,2.5,quick\n right_elbow,3,4,\n")
    assert read_prompts(file, LAYOUT, 0.0, 10.0) == [Prompt(1.0, 2.5, "left_elbow"), Prompt(3.0, 4.0, "right_elbow")]


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("start,end,joint\n1,2,knee\n", "line 2: there is no joint 'knee'"),
        ("start,end,joint\n1,2,left_elbow\n4,3,left_elbow\n", "line 3: the prompt ends at 3 s"),
        ("start,end,joint\n20,30,left_elbow\n", "line 2: the prompt from 20 to 30 s lies outside"),
        ("start,end,joint\none,2,left_elbow\n", "line 2, column 'start': 'one' is not a number"),
        ("start,end,joint\n,2,left_elbow\n", "line 2: 'start' has no number"),
        ("start,joint\n1,left_elbow\n", "no column 'end'"),
        ("start,end\n1,2\n", "no column 'joint'"),
        ("start,end,joint\n", "no row below the header"),
    ],
)
def test_a_bad_table_of_prompts_is_refused_with_its_line(tmp_path, text, words):
    with pytest.raises(ValueError, match=words):
        read_prompts(table(tmp_path, text), LAYOUT, 0.0, 10.0)

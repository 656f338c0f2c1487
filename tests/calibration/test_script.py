"""The script of the calibration, and the repetitions that are cut from what was recorded."""

import pytest
from calibration.simulated_person import layout_of

from app.calibration.script import REPETITIONS, SHORT_REPETITIONS, calibration_script, has_short_script, short_script
from app.cues import Cue, cue_index
from app.messages import NO_CUE

STEPS = calibration_script(layout_of(("right_elbow", "left_shoulder", "right_wrist", "tongue")))


def test_steps_come_in_order_with_ids_of_their_own():
    assert [step.kind for step in STEPS] == ["rest", "free", *["prompt"] * 4]
    assert [step.joint for step in STEPS[2:]] == ["right_elbow", "left_shoulder", "right_wrist", "tongue"]
    assert len({step.id for step in STEPS}) == len(STEPS)


def test_patients_are_asked_in_plain_words():
    assert [str(step.title) for step in STEPS[2:]] == [
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


def test_the_short_calibration_prompts_the_joints_of_the_controls_by_the_beginnings_of_the_whole_steps():
    """Recordings of it are read by the cues of the whole one, whose indices are the same."""
    layout = layout_of(("right_elbow", "left_shoulder", "right_shoulder", "trunk", "head", "tongue"))
    whole = {step.id: step for step in calibration_script(layout)}
    short = short_script(layout)
    assert [step.joint for step in short] == [None, None, "left_shoulder", "right_shoulder", "trunk", "head"]
    assert all(step.cues == whole[step.id].cues[: len(step.cues)] for step in short)
    assert [max(cue.repetition for cue in step.cues) for step in short[2:]] == [SHORT_REPETITIONS] * 4
    assert all(step.duration == step.cues[-1].end for step in short)
    assert "turn your head" in str(short[1].instruction)
    assert sum(step.duration for step in short) < 60.0


def test_only_a_layout_with_all_joints_of_the_controls_has_a_short_calibration():
    assert has_short_script(layout_of(("head", "trunk", "left_shoulder", "right_shoulder")))
    assert not has_short_script(layout_of(("head", "trunk", "left_shoulder")))

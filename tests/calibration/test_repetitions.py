import numpy as np
import pytest
from calibration.simulated_person import layout_of

from app.calibration.fit.repetitions import Prompt, repetitions_of_prompts, repetitions_of_run
from app.calibration.prompts_file import read_prompts
from app.calibration.script import calibration_script
from app.cues import cue_index

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

"""With other people known, held-out repetitions decide which map of a calibration drives each joint."""

import math

import pytest
from session.test_recordings import LAYOUT, record, step_ticks

from app.calibration.prior.documents import OwnPrior, PersonEntry
from app.calibration.prior.map_prior import MapPrior
from app.calibration.script import calibration_script
from app.session.recordings import entry_of_recordings, fit_recordings

CLEAR, UNCLEAR = "left_elbow", "right_elbow"
SWAYING = LAYOUT.channels_of_joint[UNCLEAR][1]


def swaying_ticks(step):
    """Yield ticks in which one sensor of the unclear joint also follows the trunk, which sways all the time."""
    for tick in step_ticks(step):
        tick.values[SWAYING] += 0.8 * math.sin(2.3 * tick.t)
        yield tick


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    folder = tmp_path_factory.mktemp("calibration")
    return [(step, record(folder / step.id, swaying_ticks(step), step.cues)) for step in calibration_script(LAYOUT)]


@pytest.fixture(scope="module")
def entry(recorded):
    return entry_of_recordings(LAYOUT, recorded)


def fitted(recorded, entry):
    """Return the joints of the calibration, by name, with four other people who have this entry."""
    others = MapPrior.of(OwnPrior(layout=LAYOUT, people={f"P-{number}": entry for number in range(4)}))
    return {joint.name: joint for joint in fit_recordings(LAYOUT, recorded, [], others).joints}


def moving_the_other_way(entry: PersonEntry) -> PersonEntry:
    """Return the entry of a person whose prompted movements lower the signals that those of others raise."""
    joints = {}
    for name, joint in entry.joints.items():
        turned = {part: tuple(-x for x in getattr(joint.moments, part)) for part in ("moment", "stroke_mean")}
        joints[name] = joint.model_copy(update={"moments": joint.moments.model_copy(update=turned)})
    return entry.model_copy(update={"joints": joints})


def test_other_people_s_help_is_used_where_it_is_better_on_repetitions_that_were_kept_apart(recorded, entry):
    joint = fitted(recorded, entry)[UNCLEAR]
    assert joint.prior.check.in_phase > joint.prior.pca_check.in_phase + 0.05
    assert (joint.map, joint.best_map, joint.prior.repetitions) == ("prior", "prior", 3)
    assert None not in (joint.prior.hits, joint.prior.false_per_minute)


def test_the_own_map_is_kept_where_other_people_s_help_only_loses_hits(recorded, entry):
    joint = fitted(recorded, entry)[CLEAR]
    assert joint.prior.check.hit_rate < joint.prior.pca_check.hit_rate
    assert (joint.map, joint.best_map, joint.prior.is_better) == ("pca", "pca", False)


def test_the_map_learnt_from_the_cues_drives_where_other_people_move_otherwise(recorded, entry):
    joint = fitted(recorded, moving_the_other_way(entry))[UNCLEAR]
    assert joint.prior.check.in_phase < 0.5
    assert (joint.map, joint.best_map, joint.prior.is_better) == ("guided", "guided", False)


def test_a_joint_that_was_not_prompted_drives_by_other_people(recorded, entry):
    joint = fitted([(step, folder) for step, folder in recorded if step.joint != CLEAR], entry)[CLEAR]
    assert (joint.map, joint.prior.repetitions) == ("prior", 0)


def test_without_other_people_the_standard_map_drives_until_a_person_chooses(recorded):
    assert {joint.map for joint in fit_recordings(LAYOUT, recorded, [], None).joints} == {"pca"}

"""The prior that ships with the simulated shirt, tried on people whom it was not made of."""

import numpy as np
import pytest

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.linear_map import Arrangement
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.prior_map import find_arrangements, with_best_maps, with_prior_maps
from app.calibration.prior.shipped import SHIPPED_SEED, shipped_prior
from app.calibration.profile import CalibrationProfile
from app.calibration.script import calibration_script
from app.calibration.vocabulary import standard_parameters
from app.hardware.shirt.standard import standard_layout
from app.pipeline.replay.batch import decode_block
from app.session.calibration.garment import Garment
from app.source import OWN_GROUPS
from app.study.simulated_calibration import (
    SAMPLE_RATE,
    StepRecording,
    record_calibration,
    record_step,
    recording_of,
    wearer,
)

LATE = 0.5  # s by which a simulated person may follow a cue


def shares(profile: CalibrationProfile, recorded: list[StepRecording]) -> list[tuple[float, float]]:
    """Return for each prompted joint the share of its activation that is in the movements, and the time with some."""
    parameters = standard_parameters(profile)
    found = []
    for step, values, cue in recorded:
        if step.kind != "prompt":
            continue
        run = decode_block(parameters, SAMPLE_RATE, np.arange(len(values)) / SAMPLE_RATE, values)
        asked = np.array([index >= 0 and step.cues[index].kind == "move" for index in cue])
        late = asked.copy()
        for _ in range(round(LATE * SAMPLE_RATE)):
            late[1:] |= late[:-1]
        gesture = next(i for i, one in enumerate(parameters.gestures) if one.joint == step.joint)
        activation = run.activation[:, gesture]
        found.append((activation[late].sum() / max(activation.sum(), 1e-9), float((activation[asked] > 0).mean())))
    return found


@pytest.mark.parametrize("seed", [5, 6])
def test_somebody_new_drives_by_it_after_ten_seconds_of_movement(seed: int) -> None:
    released = shipped_prior(standard_layout())
    assert released is not None
    person = wearer(standard_layout(), seed)
    recorded = record_calibration(person)
    free = recording_of(person, recorded).free
    rest = next(values for step, values, _ in recorded if step.kind == "rest")
    clean = CleanRecording.of(standard_layout(), SAMPLE_RATE, free, rest)
    by_others = with_best_maps(with_prior_maps(fit_profile(clean), MapPrior.of(released), clean).profile)
    assert {joint.map for joint in by_others.joints} == {"prior"}
    for in_phase, hit in shares(by_others, recorded):
        assert in_phase > 0.95
        assert hit > 0.3


def test_its_rings_tell_how_somebody_new_wears_the_elbows() -> None:
    released = shipped_prior(standard_layout())
    assert released is not None
    prior, person = MapPrior.of(released), wearer(standard_layout(), 5)
    assert set(prior.rings) == {"right_elbow", "left_elbow"}
    script = calibration_script(standard_layout())
    recorded = [(step, *record_step(person, step)) for step in script if step.kind in ("rest", "free")]
    free = recording_of(person, recorded).free
    assert set(find_arrangements(prior, free, SAMPLE_RATE).values()) == {Arrangement()}
    sensors = standard_layout().rings["left_elbow"]
    for turned, way in (
        (np.roll(sensors, 1), Arrangement(shift=1)),
        (sensors[::-1], Arrangement(shift=7, mirrored=True)),
    ):
        worn = free.copy()
        worn[:, sensors] = free[:, turned]
        assert find_arrangements(prior, worn, SAMPLE_RATE) == {"right_elbow": Arrangement(), "left_elbow": way}


def test_a_shirt_whose_layout_named_rings_later_is_the_same_garment() -> None:
    layout = standard_layout()
    one, other = Garment(layout, "worn", None), Garment(layout.without_rings, "worn", None)
    assert layout.without_rings.rings == {}
    assert one.hash == other.hash != Garment(layout, "worn", 1).hash


def test_other_sensors_with_the_layout_of_a_shirt_are_another_garment() -> None:
    garments = [Garment(standard_layout(), group, None) for group in ("worn", *OWN_GROUPS.values())]
    assert len({garment.hash for garment in garments}) == len(garments)
    assert {(garment.simulated, garment.shipped_prior) for garment in garments} == {(False, None)}


def test_another_simulated_shirt_has_no_prior() -> None:
    assert Garment(standard_layout(), "simulated", SHIPPED_SEED).shipped_prior is not None
    assert Garment(standard_layout(), "simulated", 2).shipped_prior is None
    assert Garment(standard_layout(), "worn", None).shipped_prior is None

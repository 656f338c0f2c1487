"""Versions of a map: adapted and restored; a trial keeps the version that it was driven with."""

from typing import Any

import pytest
from clinic_rows import ClinicRows

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters
from app.refusals import Conflict
from app.store.map_versions import family, go_back, save_adapted, version_before, versions_of
from app.store.parameters import as_document, current_parameters, save_parameters
from app.store.tables import ParameterSet, Profile, Trial


class PatientMaps:
    """A patient with an accepted calibration."""

    def __init__(self, rows: ClinicRows) -> None:
        self.rows, self.db = rows, rows.db
        self.patient = rows.patient()
        self.session = rows.open_session(self.patient)
        self.calibrate()

    def calibrate(self) -> None:
        self.rows.map(self.session)

    @property
    def now(self) -> DriveParameters:
        return as_document(*current_parameters(self.db, self.patient.id))

    @property
    def version(self) -> int:
        return current_parameters(self.db, self.patient.id)[1].version

    def set(self, **changes: Any) -> None:
        save_parameters(self.db, current_parameters(self.db, self.patient.id)[1], self.now.model_copy(update=changes))

    def adapt(self, by: float) -> Profile:
        """Move the mean of each joint and the dead-zone of each gesture."""
        now = self.now
        joints = tuple(joint.model_copy(update={"mean": (joint.mean[0] + by,)}) for joint in now.profile.joints)
        gestures = tuple(
            gesture.model_copy(update={"dead_zone": gesture.dead_zone + by, "full": gesture.full + by})
            for gesture in now.gestures
        )
        profile = now.profile.model_copy(update={"joints": joints})
        adapted = now.model_copy(update={"profile": profile, "gestures": gestures})
        return save_adapted(self.db, self.patient.id, self.session.id, adapted, {"by": by})

    def back(self) -> Profile:
        return go_back(self.db, self.patient.id, self.session.id)

    def drive(self) -> Trial:
        return self.rows.trial(self.session)


@pytest.fixture
def maps(rows: ClinicRows) -> PatientMaps:
    return PatientMaps(rows)


def test_an_adapted_map_is_a_version_of_its_own(maps: PatientMaps) -> None:
    before = maps.now
    maps.set(title="Indoors", cutoff=2.0)
    row = maps.adapt(0.02)
    assert (row.version, row.origin, row.parent, row.difference) == (2, "adaptation", 1, {"by": 0.02})
    now = maps.now
    assert (now.title, now.cutoff, now.bindings) == ("Indoors", 2.0, before.bindings)
    assert now.profile.joints[0].mean == (0.02,)
    assert now.gestures[0].dead_zone == pytest.approx(0.22)
    assert now.hash != before.hash
    kept = maps.db.query(Profile).filter_by(version=1).one()
    assert CalibrationProfile.model_validate(kept.document) == before.profile


def test_going_back_restores_what_was_driven_to_the_last_digit(maps: PatientMaps) -> None:
    before = maps.now.hash
    maps.adapt(0.02)
    row = maps.back()
    assert (row.version, row.origin, row.parent, row.difference) == (3, "back", 2, {"back_to": 1})
    assert maps.now.hash == before


def test_each_tap_goes_one_version_further_back_and_ends_at_the_calibration(maps: PatientMaps) -> None:
    hashes = [maps.now.hash]
    for _ in range(2):
        maps.adapt(0.02)
        hashes.append(maps.now.hash)
    assert version_before(maps.db, maps.patient.id) == 2
    maps.back()
    assert maps.now.hash == hashes[1]
    assert version_before(maps.db, maps.patient.id) == 1
    maps.back()
    assert maps.now.hash == hashes[0]
    assert maps.version == 5
    assert version_before(maps.db, maps.patient.id) is None
    with pytest.raises(Conflict, match="straight from a calibration"):
        maps.back()


def test_a_map_that_went_back_adapts_again_and_back_again(maps: PatientMaps) -> None:
    before = maps.now.hash
    maps.adapt(0.02)
    maps.back()
    maps.adapt(0.05)
    assert version_before(maps.db, maps.patient.id) == 3
    maps.back()
    assert maps.now.hash == before


def test_what_a_person_set_since_stays_when_going_back(maps: PatientMaps) -> None:
    maps.adapt(0.02)
    right, left = maps.now.gestures
    by_hand = right.model_copy(update={"full": 2.5})
    maps.set(gestures=(by_hand, left), mode_u2="acceleration")
    maps.back()
    now = maps.now
    assert now.gestures[0] == by_hand
    assert now.gestures[1].dead_zone == 0.2
    assert now.mode_u2 == "acceleration"


def test_trials_keep_the_version_that_they_were_driven_with(maps: PatientMaps) -> None:
    first = maps.drive()
    maps.adapt(0.02)
    second, third = maps.drive(), maps.drive()
    maps.back()
    listed = versions_of(maps.db, maps.patient.id)
    assert [(one.version, one.origin, one.parent, one.trials) for one in listed] == [
        (3, "back", 2, []),
        (2, "adaptation", 1, [second.id, third.id]),
        (1, "calibration", None, [first.id]),
    ]
    rows = [maps.db.get_one(ParameterSet, trial.parameters_id) for trial in (first, second)]
    assert [row.profile_id for row in rows] == [1, 2]


def test_a_new_calibration_is_no_child_of_what_was_adapted_before(maps: PatientMaps) -> None:
    maps.adapt(0.02)
    maps.calibrate()
    maps.adapt(0.02)
    maps.back()
    assert family(maps.db, maps.patient.id, maps.version) == {3, 4, 5}
    assert family(maps.db, maps.patient.id, 2) == {1, 2}
    assert version_before(maps.db, maps.patient.id) is None

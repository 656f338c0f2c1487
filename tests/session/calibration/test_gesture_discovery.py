"""Gestures found in recordings on disk: of the calibration under way, and of the newest map."""

import shutil

import pytest
from clinic_rows import rows_in
from session.same_process import SameProcess
from session.test_recordings import LAYOUT, record, step_ticks

from app.calibration.script import calibration_script
from app.calibration.vocabulary import standard_parameters
from app.refusals import Conflict
from app.session.calibration.gesture_discovery import GestureDiscoveries
from app.session.recordings import fit_recordings
from app.store.calibrations import begin_calibration, set_step
from app.store.map_versions import save_adapted
from app.store.runs import add_run
from app.store.tables import PatientSession

COMPUTING = SameProcess()


class RecordedCalibration:
    """A patient whose steps are all recorded, and whose result is not accepted yet."""

    def __init__(self, database, folder):
        self.database, self.folder = database, folder
        self.discoveries = GestureDiscoveries(database, self.folder_of, COMPUTING)
        self.steps = calibration_script(LAYOUT)
        recorded = [(step, record(folder / step.id, step_ticks(step), step.cues)) for step in self.steps]
        self.profile = fit_recordings(LAYOUT, recorded, [], None)
        with rows_in(database) as rows:
            session = rows.open_session()
            begin_calibration(rows.db, session, {}, [step.id for step in self.steps])
            for step in self.steps:
                add_run(rows.db, step.id, session.id, step.kind, step.id)
                set_step(rows.db, session.id, step.id, "done", "", step.id)
            session.result = self.profile.model_dump(mode="json")
            self.patient, self.session = session.patient_id, session.id

    def folder_of(self, run):
        return self.folder / run

    def accept(self):
        with rows_in(self.database) as rows:
            session = rows.db.get_one(PatientSession, self.session)
            rows.map(session, self.profile)
            session.accepted = True

    def result(self):
        return self.discoveries.of_session(self.session)

    def newest(self):
        return self.discoveries.of_patient(self.patient)


@pytest.fixture
def recorded(database, tmp_path):
    return RecordedCalibration(database, tmp_path)


def test_the_calibration_under_way_is_judged_by_its_recordings_before_and_after_it_is_accepted(recorded):
    with pytest.raises(Conflict):
        recorded.newest()
    found = recorded.result()
    assert (found.source, found.message) == ("recordings", None)
    assert {(one.joint, one.direction) for one in found.gestures} == {
        (joint, way) for joint in LAYOUT.joint_names for way in (1, -1)
    }
    for one in found.gestures:
        assert one.prediction.hit_check.repetitions == 3
        assert one.prediction.rest_check.seconds == pytest.approx(2 * 0.5 + 3 * 0.7, abs=0.1)
    recorded.accept()
    assert recorded.result() == recorded.newest() == found


def with_twice_the_span(joint):
    halved = tuple(weight / 2 for weight in joint.pca.rates[0])
    return joint.model_copy(update={"pca": joint.pca.model_copy(update={"rates": (halved,)})})


def test_an_adapted_map_is_judged_by_the_recordings_of_the_calibration_behind_it(recorded):
    recorded.accept()
    before = recorded.newest()
    joints = tuple(with_twice_the_span(joint) for joint in recorded.profile.joints)
    adapted = standard_parameters(recorded.profile.model_copy(update={"joints": joints}))
    with recorded.database.transaction() as db:
        save_adapted(db, recorded.patient, recorded.session, adapted, {"by": "hand"})
    after = {one.name: one for one in recorded.newest().gestures}
    assert recorded.newest().source == "recordings"
    for one in before.gestures:  # twice the span: half the rate, against the profile's own noise
        assert after[one.name].signal_to_noise == pytest.approx(one.signal_to_noise / 2, rel=0.05)


def test_steps_that_were_done_again_are_not_taken_for_those_behind_the_map(recorded):
    recorded.accept()
    with recorded.database.transaction() as db:
        session = db.get_one(PatientSession, recorded.session)
        session.result = recorded.profile.model_copy(update={"created": "later"}).model_dump(mode="json")
        session.accepted = False
    assert (recorded.newest().source, recorded.result().source) == ("profile", "recordings")


def test_recordings_that_were_tidied_up_are_missed_in_words(recorded):
    recorded.accept()
    shutil.rmtree(recorded.folder_of("rest"))
    found = recorded.newest()
    assert found.source == "profile"
    assert "calibrate again" in str(found.message)
    assert {one.direction for one in found.gestures} == {1}

"""A proposal to adapt the map is made of trials of one source: those that were worn, or those that were simulated."""

from sqlalchemy.orm import Session

from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import standard_parameters
from app.source import UNKNOWN_SOURCE, Source
from app.store.adaptation_material import material_for
from app.store.parameters import current_parameters, save_parameters, save_profile
from app.store.patients import add_patient, start_session
from app.store.people import add_clinic
from app.store.runs import add_run, add_trial, finish_trial

WORN = Source(shirt="udp", body=None, chair="virtual", simulated=False)
SIMULATED = Source(shirt="simulator", body="person", chair="virtual", simulated=True)


def test_worn_simulated_and_unknown_trials_are_never_material_together(
    db: Session, profile: CalibrationProfile
) -> None:
    """Safety S26: a movement that nobody made does not change the map of a person, nor the other way round."""
    add_clinic(db, "Clinic")
    patient = add_patient(db, "P-1", "Heron", "")
    session = start_session(db, patient.id)
    save_parameters(db, save_profile(db, patient.id, session.id, profile), standard_parameters(profile))
    for name, source in (("worn", WORN), ("simulated", SIMULATED), ("unknown", UNKNOWN_SOURCE)):
        trial = add_trial(
            db,
            run=add_run(db, name, session.id, "drive", name, source),
            patient_id=patient.id,
            parameters_id=current_parameters(db, patient.id)[0].id,
            floorplan="hall",
            floorplan_title="Hall",
            path="loop",
            path_points=[[0.0, 0.0], [1.0, 0.0]],
        )
        finish_trial(db, trial.id, "goal", None)
    for simulated, name in ((False, "worn"), (True, "simulated"), (None, "unknown")):
        material = material_for(db, patient.id, session.id, simulated=simulated)
        assert (material.run_ids, material.fresh, [past.run_id for past in material.past]) == ([name], 1, [name])

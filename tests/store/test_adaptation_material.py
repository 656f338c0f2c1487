"""A proposal to adapt the map is made of trials of one source: those that were worn, or those that were simulated."""

from clinic_rows import SIMULATED, WORN, ClinicRows

from app.source import UNKNOWN_SOURCE
from app.store.adaptation_material import material_for


def test_worn_simulated_and_unknown_trials_are_never_material_together(rows: ClinicRows) -> None:
    """Safety S26: a movement that nobody made does not change the map of a person, nor the other way round."""
    session = rows.open_session()
    for name, source in (("worn", WORN), ("simulated", SIMULATED), ("unknown", UNKNOWN_SOURCE)):
        rows.trial(session, source=source, run=name)
    for simulated, name in ((False, "worn"), (True, "simulated"), (None, "unknown")):
        material = material_for(rows.db, session.patient_id, session.id, simulated=simulated)
        assert (material.run_ids, material.fresh, [past.run_id for past in material.past]) == ([name], 1, [name])

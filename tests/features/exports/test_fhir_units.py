"""Each measure that FHIR carries has its UCUM code, in Observations that are valid R4B."""

import pytest
from clinic_rows import rows_in
from exported_clinic import make_clinic, material_of
from fhir.resources.R4B.bundle import Bundle
from stored_interface_test import MEASURES as TEST_MEASURES
from stored_interface_test import store_interface_test

from app.clock import utc_now
from app.features.exports.fhir_form import fhir_bundle
from app.scoring.measures import EXPORTED
from app.scoring.measures import TEST_MEASURES as TEST_UNITS
from app.store.tables import Trial

# Written down once more, from what each measure is: metres, seconds, degrees, plain numbers ("1" in UCUM).
OF_TRIALS = {
    "m": (
        *("dist", "cross_track_rms", "cross_track_max", "follow_error_rms", "follow_error_max"),
        *("turn_drift", "gap_clearance"),
    ),
    "m2": ("e_diff",),
    "s": ("time", "contact_time", "halt_time", "pause_time", "person_stop_time"),
    "m/s": ("mean_speed",),
    "deg": ("heading_error_deg",),
    "/m": ("pulses_per_metre",),
    "1": (
        *("dist_ratio", "stops", "collisions", "stages_done", "follow_near"),
        *("cones_touched", "door_contacts", "turn_reversals", "sparc", "ldlj"),
        *("halts", "pauses", "person_stops"),
    ),
}
OF_TESTS = {
    "/min": ("acquisitions_per_minute",),
    "bit/s": ("throughput",),
    "s": ("first_entry", "dial_in"),
    "1": ("path_efficiency",),
}
CODES = {name: code for codes in (OF_TRIALS, OF_TESTS) for code, names in codes.items() for name in names}
VALUES = {name: number + 0.5 for number, names in enumerate(OF_TRIALS.values()) for name in names}


@pytest.fixture
def bundle(tmp_path) -> Bundle:
    """Return the Bundle of a trial that has every measure, and of a complete two-minute test."""
    settings = make_clinic(tmp_path)
    with rows_in(settings) as rows:
        rows.db.query(Trial).one().measures = {"reached": True, **VALUES}
        store_interface_test(rows.db, 1).run.ended = utc_now()
    return Bundle.model_validate(fhir_bundle(material_of(settings, "fhir"), {}))


def test_each_measure_has_its_value_and_its_ucum_code(bundle) -> None:
    observations = [entry.resource for entry in bundle.entry if entry.resource.get_resource_type() == "Observation"]
    found = {one.code.coding[0].code: one.valueQuantity for one in observations}
    assert len(found) == len(observations)
    assert {name: quantity.code for name, quantity in found.items()} == CODES
    assert {quantity.system for quantity in found.values()} == {"http://unitsofmeasure.org"}
    assert all(quantity.unit == quantity.code for quantity in found.values())
    expected = VALUES | {name: TEST_MEASURES[name] for code in OF_TESTS.values() for name in code}
    assert {name: float(quantity.value) for name, quantity in found.items()} == expected


def test_no_measure_is_left_out_of_this_table() -> None:
    assert set(CODES) == {*EXPORTED, *TEST_UNITS}

"""The measures of trials and two-minute tests as FHIR R4B: a Bundle of a Patient, a Device, and their Observations.

See https://hl7.org/fhir/R4B/observation.html; units are UCUM codes.
"""

import uuid
from typing import Any, Literal

from app import __version__
from app.features.exports.export_material import ExportMaterial
from app.features.exports.recorded_runs import RecordedRun, RecordedTest, RecordedTrial
from app.scoring.interface_test.interface_course import COMPLETE
from app.scoring.measures import EXPORTED, TEST_MEASURES, Measure, is_number
from app.scoring.units import UCUM
from app.source import source_description
from app.texts import Text
from app.world.place_texts import place_text

MEASURE_CODES = "urn:bodydrive:measure"
TEST_METHOD = Text("exports-method-test")
TEST_DATA = {"system": "http://terminology.hl7.org/CodeSystem/v3-ActReason", "code": "HTEST"}  # nobody's health


def fhir_bundle(material: ExportMaterial, verdicts: dict[int, dict[str, str]]) -> dict[str, Any]:
    """Return the kept trials and the complete tests as a Bundle; the same ones give the same document."""
    clinic = material.clinic
    patient, device = _address(clinic, material.code, "patient"), _address(clinic, __version__, "device")
    entries = [
        _entry(patient, {"resourceType": "Patient", "identifier": [_identifier(clinic, material.code)]}),
        _entry(device, _device()),
    ]
    for run in material.runs:
        if run.trial is not None and run.trial.kept:
            method = Text(
                "exports-method-trial", plan=place_text(run.trial.floorplan, run.trial.title), path=run.trial.path
            )
            verdict = verdicts.get(run.trial.id, {})
            observations = _observations(run, run.trial, "trial", method, EXPORTED, verdict)
        elif run.test is not None and run.test.end == COMPLETE:
            observations = _observations(run, run.test, "test", TEST_METHOD, TEST_MEASURES, {})
        else:
            continue
        references = {"subject": {"reference": patient}, "device": {"reference": device}}
        entries += [
            _entry(_address(clinic, material.code, f"{run.folder.name}/{name}"), {**observation, **references})
            for name, observation in observations.items()
        ]
    return {"resourceType": "Bundle", "type": "collection", "entry": entries}


def _observations(
    run: RecordedRun,
    done: RecordedTrial | RecordedTest,
    kind: Literal["trial", "test"],
    method: Text,
    measures: dict[str, Measure],
    verdicts: dict[str, str],
) -> dict[str, dict[str, Any]]:
    """Return an Observation for each measure that a trial or a test has, without its patient and device."""
    note = Text(
        f"exports-note-{kind}",
        source=source_description(run.source),
        session=run.session,
        number=done.number,
        version=done.map_version,
        hash=done.parameters_hash,
    )
    return {
        name: {
            "resourceType": "Observation",
            **({"meta": {"security": [TEST_DATA]}} if run.source.simulated else {}),
            "status": "final",
            "code": {
                "coding": [{"system": MEASURE_CODES, "code": name, "display": str(measure.defined_as)}],
                "text": str(measure.defined_as),
            },
            "effectiveDateTime": done.started.isoformat(),
            "valueQuantity": {"value": done.measures[name], "unit": measure.ucum, "system": UCUM, "code": measure.ucum},
            "method": {"text": str(method)},
            **({"interpretation": [{"text": verdicts[name]}]} if verdicts.get(name) else {}),
            "note": [{"text": str(note)}],
        }
        for name, measure in measures.items()
        if is_number(done.measures.get(name))
    }


def _device() -> dict[str, Any]:
    return {
        "resourceType": "Device",
        "deviceName": [{"name": "bodydrive", "type": "model-name"}],
        "version": [{"value": __version__}],
    }


def _identifier(clinic: str, code: str) -> dict[str, str]:
    """Return a patient's code in the namespace of the clinic, which alone gives its codes once."""
    return {"system": _address(clinic, "patient-code"), "value": code}


def _entry(address: str, resource: dict[str, Any]) -> dict[str, Any]:
    return {"fullUrl": address, "resource": resource}


def _address(*parts: str) -> str:
    return f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, '/'.join(('urn:bodydrive', *parts)))}"

"""The measures of trials as FHIR R4B: one Bundle of a Patient, a Device and an Observation for each measure.

See https://hl7.org/fhir/R4B/observation.html; units are UCUM codes.
"""

import uuid
from typing import Any

from app import __version__
from app.exports.export_material import ExportMaterial
from app.exports.measure_units import MEASURES, is_number
from app.source import source_words
from app.store.records.recorded_runs import RecordedRun, RecordedTrial

UCUM = "http://unitsofmeasure.org"
MEASURE_CODES = "urn:bodydrive:measure"
PATIENT_CODES = "urn:bodydrive:patient-code"
TEST_DATA = {"system": "http://terminology.hl7.org/CodeSystem/v3-ActReason", "code": "HTEST"}  # nobody's health


def fhir_bundle(material: ExportMaterial, verdicts: dict[int, dict[str, str]]) -> dict[str, Any]:
    """Return the kept trials as a Bundle; the same trials give the same document."""
    patient, device = _address(material.code, "patient"), _address(__version__, "device")
    entries = [
        _entry(patient, {"resourceType": "Patient", "identifier": [_identifier(material.code)]}),
        _entry(device, _device()),
    ]
    for run in material.runs:
        if run.trial is not None and run.trial.kept:
            words = verdicts.get(run.trial.id, {})
            entries += [
                _entry(
                    _address(material.code, f"{run.folder.name}/{name}"),
                    _observation(run, run.trial, name, words.get(name, ""), patient, device),
                )
                for name in MEASURES
                if is_number(run.trial.measures.get(name))
            ]
    return {"resourceType": "Bundle", "type": "collection", "entry": entries}


def _observation(
    run: RecordedRun, trial: RecordedTrial, name: str, verdict: str, patient: str, device: str
) -> dict[str, Any]:
    words, unit = MEASURES[name]
    note = (
        f"{source_words(run.source)}. Session {run.session}, trial {trial.number}. "
        f"Map version {trial.map_version}, parameter set {trial.parameters_hash}."
    )
    return {
        "resourceType": "Observation",
        **({"meta": {"security": [TEST_DATA]}} if run.source.simulated else {}),
        "status": "final",
        "code": {"coding": [{"system": MEASURE_CODES, "code": name, "display": words}], "text": words},
        "subject": {"reference": patient},
        "device": {"reference": device},
        "effectiveDateTime": trial.started.isoformat(),
        "valueQuantity": {"value": trial.measures[name], "unit": unit, "system": UCUM, "code": unit},
        "method": {"text": f"{trial.title}, path {trial.path}"},
        **({"interpretation": [{"text": verdict}]} if verdict else {}),
        "note": [{"text": note}],
    }


def _device() -> dict[str, Any]:
    return {
        "resourceType": "Device",
        "deviceName": [{"name": "bodydrive", "type": "model-name"}],
        "version": [{"value": __version__}],
    }


def _identifier(code: str) -> dict[str, str]:
    return {"system": PATIENT_CODES, "value": code}


def _entry(address: str, resource: dict[str, Any]) -> dict[str, Any]:
    return {"fullUrl": address, "resource": resource}


def _address(*parts: str) -> str:
    return f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, '/'.join(('urn:bodydrive', *parts)))}"

"""An export as one zip file, made run by run: first what describes it, then the files of each recording.

Every step opens the file again, so that the web process can have each one done elsewhere, and say how far it is.
"""

import json
import tempfile
import zipfile
from functools import partial
from pathlib import Path
from typing import Any

from app import __version__
from app.features.exports import bids_form
from app.features.exports.csv_tables import interface_test_csv, trial_csv, verdict_texts, write_csv, write_parquet
from app.features.exports.export_material import ExportMaterial, run_facts
from app.features.exports.fhir_form import fhir_bundle
from app.features.exports.forms import Form
from app.features.exports.recorded_runs import RecordedRun
from app.features.exports.xdf_form import write_xdf
from app.package import FAST, Step, add_file, entry
from app.recording.groups import RunGroups, read_in_groups
from app.texts import Text

IGNORED = "trials.csv\ninterface_tests.csv\nexport.json\n*.missing.txt\n"  # of a BIDS validator


def export_steps(material: ExportMaterial, form: Form) -> list[Step]:
    """Return the steps that make an export, to be called one after the other with the zip file to be made."""
    first: Step = partial(_begin, material, form)
    if form == "fhir":
        return [first]
    return [first, *(partial(_add_run, material.code, form, run) for run in material.runs)]


def _begin(material: ExportMaterial, form: Form, package: Path) -> int:
    verdicts = verdict_texts(material)
    package.unlink(missing_ok=True)
    contents = {"export.json": _json(_description(material, form))}
    if form == "fhir":
        contents["bundle.json"] = _json(fhir_bundle(material, verdicts))
    else:
        contents["trials.csv"] = trial_csv(material, verdicts).encode()
        if tests := interface_test_csv(material.code, material.runs):
            contents["interface_tests.csv"] = tests.encode()
    with zipfile.ZipFile(package, "x") as opened, tempfile.TemporaryDirectory(dir=package.parent) as name:
        for file, content in contents.items():
            opened.writestr(entry(file), content, compresslevel=FAST)
        if form == "bids":
            opened.writestr(entry(".bidsignore"), IGNORED)
            for described in bids_form.dataset_files(Path(name), material.code, __version__):
                add_file(opened, described, described.name)
        return opened.start_dir


def _add_run(code: str, form: Form, run: RecordedRun, package: Path) -> int:
    with zipfile.ZipFile(package, "a") as opened, tempfile.TemporaryDirectory(dir=package.parent) as name:
        folder = Path(name)
        try:
            recorded = read_in_groups(run.folder)
        except ValueError:
            opened.writestr(entry(f"{run.stem}.missing.txt"), f"{Text('exports-recording-missing')}\n")
            return opened.start_dir
        if not recorded.meta:
            opened.writestr(entry(f"{run.stem}.missing.txt"), f"{recorded.loss}\n")
            return opened.start_dir
        for file in _run_files(code, form, run, recorded, folder):
            add_file(opened, file, file.relative_to(folder).as_posix())
        return opened.start_dir


def _run_files(code: str, form: Form, run: RecordedRun, recorded: RunGroups, folder: Path) -> list[Path]:
    facts = run_facts(code, run, recorded.meta, str(recorded.loss or ""))
    if form == "bids":
        place = {"patient": code, "session": run.session, "task": run.task, "run": run.number}
        return bids_form.write_bids(recorded, facts, folder, place)
    if form == "parquet":
        return write_parquet(recorded, facts, folder, run.stem)
    if form == "xdf":
        return write_xdf(recorded, facts, folder, run.stem)
    about = folder / f"{run.stem}.json"
    about.write_bytes(_json(facts))
    return [about, *write_csv(recorded, folder, run.stem)]


def _description(material: ExportMaterial, form: Form) -> dict[str, Any]:
    return {
        "format": form,
        "patient": material.code,
        "software": __version__,
        "sessions": sorted({run.session for run in material.runs}),
        "runs": len(material.runs),
        "sources": sorted({run.source.group for run in material.runs}),
    }


def _json(document: Any) -> bytes:
    return json.dumps(document, indent=1, ensure_ascii=False).encode() + b"\n"

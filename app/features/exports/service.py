"""An export as one zip file, made run by run: first what describes it, then the files of each recording.

Every step opens the file again, so that the web process can have each one done elsewhere, and say how far it is.
"""

import json
import tempfile
import zipfile
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

from app import __version__
from app.csv_cells import SPREADSHEET_BEGIN, csv_line
from app.features.exports import bids_form
from app.features.exports.export_material import SIMULATED_WORDS, ExportMaterial, run_facts
from app.features.exports.fhir_form import fhir_bundle
from app.features.exports.flat_table import write_csv, write_parquet
from app.features.exports.forms import Form
from app.features.exports.recorded_runs import RecordedRun, RecordedTest
from app.features.exports.xdf_form import write_xdf
from app.package import FAST, Step, add_file, entry
from app.recording.format import META_FILE
from app.recording.groups import RunGroups, read_in_groups
from app.scoring.interface_test.workload import Workload
from app.scoring.measures import EXPORTED, TEST_MEASURES, VERDICT_WORDS, is_number
from app.scoring.verdict.verdicts import trial_verdicts
from app.source import source_description

IGNORED = "trials.csv\ninterface_tests.csv\nexport.json\n*.missing.txt\n"  # of a BIDS validator
UNKNOWN = "unknown"


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
        if tests := _interface_test_csv(material.code, material.runs):
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
            opened.writestr(entry(f"{run.stem}.missing.txt"), "The recording of this run is missing.\n")
            return opened.start_dir
        if not recorded.meta:
            opened.writestr(entry(f"{run.stem}.missing.txt"), f"{recorded.loss}\n")
            return opened.start_dir
        for file in _run_files(code, form, run, recorded, folder):
            add_file(opened, file, file.relative_to(folder).as_posix())
        return opened.start_dir


def _run_files(code: str, form: Form, run: RecordedRun, recorded: RunGroups, folder: Path) -> list[Path]:
    facts = run_facts(code, run, recorded.meta, recorded.loss)
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


def _recorded_with(folder: Path) -> str:
    """Return the version that a recording names; "unknown" when it is gone, cannot be read, or names none."""
    try:
        meta = json.loads((folder / META_FILE).read_bytes())
    except (OSError, ValueError):
        return UNKNOWN
    return str(meta.get("software", UNKNOWN)) if isinstance(meta, dict) else UNKNOWN


TRIAL_ABOUT = (
    *("patient", "session", "run", "trial", "floor_plan", "path", "started", "end", "kept", "reason_left_out"),
    *("source", "simulated", "map_version", "parameters_hash", "software", "exported_with"),
    *("origin_clinic", "imported_by", "imported"),
)


def verdict_texts(material: ExportMaterial) -> dict[int, dict[str, str]]:
    """Return the words of the verdicts on each trial against the one before it: trial -> measure -> words."""
    found: dict[int, dict[str, str]] = {}
    for task in material.tasks:
        for row in task.rows:
            verdicts = trial_verdicts(task.rows, task.clinic, row["id"], None).verdicts
            told = {name: verdict.word for name, verdict in verdicts.items() if verdict.word != "number"}
            found[row["id"]] = {name: VERDICT_WORDS[word] for name, word in told.items()}
    return found


def trial_csv(material: ExportMaterial, verdicts: dict[int, dict[str, str]]) -> str:
    """Return the trials as CSV; a measure that the trial does not have is an empty cell."""
    heads = [column for name, measure in EXPORTED.items() for column in (f"{name} [{measure.ucum}]", f"{name} verdict")]
    lines = [csv_line([*TRIAL_ABOUT, *heads])]
    lines += [
        csv_line(list(_trial_cells(material.code, run, verdicts))) for run in material.runs if run.trial is not None
    ]
    return SPREADSHEET_BEGIN + "".join(lines)


def _trial_cells(code: str, run: RecordedRun, verdicts: dict[int, dict[str, str]]) -> Iterator[str | float | None]:
    trial = run.trial
    assert trial is not None
    yield from (code, run.session, run.number, trial.number, trial.title, trial.path)
    yield from (trial.started.isoformat(), trial.end or "", "yes" if trial.kept else "no", trial.reason or "")
    yield from (source_description(run.source), SIMULATED_WORDS[run.source.simulated])
    yield from (trial.map_version, trial.parameters_hash, _recorded_with(run.folder), __version__)
    yield from ("", "", "") if (origin := run.origin) is None else (origin.clinic, origin.person, origin.at.isoformat())
    for name in EXPORTED:
        value = trial.measures.get(name)
        yield value if is_number(value) else None
        yield verdicts.get(trial.id, {}).get(name, "")


TEST_ABOUT = (
    *("patient", "session", "run", "test", "started", "end", "source", "simulated"),
    *("map_version", "parameters_hash", "software", "exported_with"),
)


def _interface_test_csv(code: str, runs: tuple[RecordedRun, ...]) -> str:
    """Return the two-minute tests as CSV; what was not measured or answered is an empty cell. "" without tests."""
    rows = [csv_line(list(_test_cells(code, run, run.test))) for run in runs if run.test is not None]
    if not rows:
        return ""
    measures = [f"{name} [{measure.ucum}]" for name, measure in TEST_MEASURES.items()]
    answers = [f"workload {name} [0-100]" for name in Workload.model_fields]
    return "".join([SPREADSHEET_BEGIN, csv_line([*TEST_ABOUT, *measures, *answers]), *rows])


def _test_cells(code: str, run: RecordedRun, test: RecordedTest) -> Iterator[str | float | None]:
    yield from (code, run.session, run.number, test.number, test.started.isoformat(), test.end or "")
    yield from (source_description(run.source), SIMULATED_WORDS[run.source.simulated])
    yield from (test.map_version, test.parameters_hash, _recorded_with(run.folder), __version__)
    yield from (test.measures.get(name) for name in TEST_MEASURES)
    yield from (test.workload.get(name) for name in Workload.model_fields)

"""What the store has for an export: plain values that can be sent to the process that writes it."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from app.features.exports.recorded_runs import RecordedRun, recorded_runs
from app.refusals import DiskFull, NotFound
from app.scoring.interruptions import interruption_text
from app.scoring.verdict.spread import Spread, SpreadsOf
from app.source import source_description
from app.store.consent import require_consent
from app.store.database import Database
from app.store.files.room_for_files import room_refusal
from app.store.learning_trials import counted_trials
from app.store.log import write_log
from app.store.patients import find_patient
from app.store.people import clinic_mark
from app.texts import Text

SIMULATED_WORDS = {True: "yes", False: "no", None: "unknown"}
NOTHING = Text("exports-nothing")

# Times the size of the recordings: the zip file of their CSV, and a recording as text beside it while it is packed. The
# text of a simulated trial is 2.1 times its recording.
LARGEST = 4.0


@dataclass(frozen=True, slots=True)
class ExportedTask:
    """The counted trials of one task and source, for their verdicts."""

    rows: list[dict[str, Any]]  # as `CountedTrial.row` returns them
    clinic: dict[str, Spread]


@dataclass(frozen=True, slots=True)
class ExportMaterial:
    """Everything of the store that an export is made from."""

    patient_id: int
    code: str
    runs: tuple[RecordedRun, ...]  # in the order recorded
    tasks: tuple[ExportedTask, ...]
    clinic: str = ""  # its mark: identifiers that leave the clinic name it, as codes of patients are the clinic's own


def exported_material(
    database: Database,
    patient_id: int,
    session: int | None,
    form: str,
    person: str,
    runs: Path,
    spreads_of: SpreadsOf,
    *,
    place: Path,
) -> ExportMaterial:
    """Return what an export of one session (its number), or of all of a patient (None), is made from; log the export.

    `runs` is the folder of all recordings, `person` who exports, `place` the folder in which the file is made.

    Raises
    ------
    NotFound
        When there is no such patient or session, or nothing was recorded in it.
    Conflict
        When the patient has not consented to sharing outside the clinic.
    DiskFull
        When the disk of `place` has no room for the export and for recording beside it.
    """
    with database.transaction() as db:
        patient = find_patient(db, patient_id)
        require_consent(db, patient_id, "sharing")
        recorded = recorded_runs(db, patient_id, session, runs)
        if not recorded:
            raise NotFound(NOTHING)
        if form != "fhir":
            _require_room(recorded, place)
        tasks = {
            (run.trial.floorplan, run.trial.path, run.source.group): list[dict[str, Any]]()
            for run in recorded
            if run.trial is not None
        }
        for floorplan, path, group in tasks:
            counted = counted_trials(db, patient_id, floorplan, path)
            tasks[floorplan, path, group] += [trial.row() for trial in counted if trial.group == group]
        mark = clinic_mark(db)
        write_log(db, person, "export", patient=patient_id, session=session, form=form, runs=len(recorded))
    exported_tasks = tuple(ExportedTask(rows, spreads_of(*task)) for task, rows in tasks.items())
    return ExportMaterial(patient_id, patient.code, tuple(recorded), exported_tasks, mark)


def _require_room(recorded: list[RecordedRun], place: Path) -> None:
    size = sum(file.stat().st_size for run in recorded for file in run.folder.glob("*"))
    refusal = room_refusal("export", LARGEST * size, place)
    if refusal:
        raise DiskFull(refusal)


def run_facts(code: str, run: RecordedRun, meta: dict[str, Any], damage: str) -> dict[str, str]:
    """Return what each file of a recording says of it: whose, of what, with which source and software."""
    trial = run.trial
    done = run.trial or run.test
    return {
        "patient": code,
        "session": str(run.session),
        "run": str(run.number),
        "kind": run.kind,
        "task": run.task,
        "trial": "" if trial is None else str(trial.number),
        "interruptions": "" if trial is None else str(interruption_text(trial.measures) or ""),
        "test": "" if run.test is None else str(run.test.number),
        "started": run.started.isoformat(),
        "source": source_description(run.source),
        "shirt": run.source.shirt,
        "simulated": SIMULATED_WORDS[run.source.simulated],
        "software": str(meta.get("software", "unknown")),
        "parameters_hash": "" if done is None else done.parameters_hash,
        "damage": damage,
    }

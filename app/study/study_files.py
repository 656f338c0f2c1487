"""The files of a study: tables, figures and its parameters, all files or none."""

import csv
import io
import json
import shutil
import tempfile
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, wait
from contextlib import contextmanager
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray
from pydantic_core import to_jsonable_python

from app import __version__
from app.hardware.body.person_parameters import PersonParameters, PracticeEffect
from app.source import STUDY_SOURCE, source_description
from app.study.experiment import StudyResult
from app.study.second_process import SameProcess
from app.texts import Text

if TYPE_CHECKING:
    import pyarrow as pa

Draw = Callable[[Path], None]

TRIAL_COLUMNS = ("trial", "dist", "e_diff", "time", "cross_track_rms", "collisions", "reached", "simulated")
TRAJECTORY_COLUMNS = ("t", "x", "y", "theta", "v", "omega")


def check_folder(folder: Path, overwrite: bool) -> None:
    """Check before a study runs that its files can be written to `folder`.

    Raises
    ------
    ValueError
        One sentence that says what is in the way and what to do.
    """
    if folder.exists() and not folder.is_dir():
        raise ValueError(Text("study-folder-is-file", folder=str(folder)))
    if folder.is_dir() and any(folder.iterdir()) and not overwrite:
        raise ValueError(Text("study-folder-not-empty", folder=str(folder)))


def write_study(
    result: StudyResult, folder: Path, draw: Draw, overwrite: bool = False, second: Executor | None = None
) -> None:
    """Write a study into `folder`, all files or none.

    `draw` draws the figures into the folder given to it, in `second` beside the writing of the other files.

    Raises
    ------
    ValueError
        When `folder` is a file, or holds something and may not be overwritten.
    OSError
        When the place cannot be written; nothing is left behind then.
    """
    with atomic_folder(folder, overwrite) as part:
        drawing = (second or SameProcess()).submit(draw, part)
        try:
            _write_tables(result, part)
        finally:
            wait([drawing])  # nothing may be written into a folder that is being removed
        drawing.result()


def _write_tables(result: StudyResult, folder: Path) -> None:
    import pyarrow.parquet

    (folder / "trials.csv").write_text(trials_csv(result), encoding="utf-8")
    pyarrow.parquet.write_table(trajectories_table(result), folder / "trajectories.parquet", compression="zstd")
    document = json.dumps(summary(result), indent=1, allow_nan=False)
    (folder / "study.json").write_text(f"{document}\n", encoding="utf-8")


@contextmanager
def atomic_folder(folder: Path, overwrite: bool) -> Iterator[Path]:
    """Yield a temporary folder beside `folder`; it is renamed to `folder` at the end, and removed after an error.

    Raises
    ------
    ValueError
        When `folder` is a file, or holds something and may not be overwritten.
    """
    check_folder(folder, overwrite)
    folder = folder.absolute()
    folder.parent.mkdir(parents=True, exist_ok=True)
    part = Path(tempfile.mkdtemp(dir=folder.parent, prefix=f".{folder.name}.", suffix=".part"))
    try:
        yield part
        part.chmod(0o755)
        _put_in_place(part, folder)
    except BaseException:
        shutil.rmtree(part, ignore_errors=True)
        raise


def trials_csv(result: StudyResult) -> str:
    """Return the table of trials, one row each; numbers in full precision, `reached` as true or false."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(TRIAL_COLUMNS)
    for trial in result.trials:
        row = {"trial": trial.number, "simulated": STUDY_SOURCE.simulated, **trial.measures}
        writer.writerow([cell(row[column]) for column in TRIAL_COLUMNS])
    return text.getvalue()


def trajectories_table(result: StudyResult) -> "pa.Table":
    """Return all trajectories as one table: trial, t (s since the trial's start), x, y, theta, v, omega."""
    import pyarrow as pa

    trials = result.trials
    columns: dict[str, NDArray[np.generic]] = {
        "trial": np.repeat([trial.number for trial in trials], [len(trial.t) for trial in trials]).astype(np.int32)
    }
    for name in TRAJECTORY_COLUMNS:
        columns[name] = np.concatenate([getattr(trial, name) for trial in trials])
    return pa.table(columns).replace_schema_metadata({"source": source_description(STUDY_SOURCE)})


def summary(result: StudyResult) -> dict[str, object]:
    """Return the conditions, the calibration, the trials and the learning curves, ready for JSON."""
    return {
        "software": f"bodydrive {__version__}",
        "source": source_description(STUDY_SOURCE),
        "seed": result.seed,
        "floorplan": result.floorplan.name,
        "path": result.path.name,
        "path_length": result.path.line.length,
        "sample_rate": result.sample_rate,
        "person": person_document(result.person),
        "calibration": {
            joint.name: {
                "evr": joint.evr,
                "has_to_be_repeated": joint.has_to_be_repeated,
                "reason": str(joint.description),
            }
            for joint in result.parameters.profile.joints
        },
        "parameters": result.parameters.model_dump(mode="json", exclude={"profile"}),
        "trials": [
            {"trial": trial.number, "stops_for_faults": trial.faults, **trial.measures} for trial in result.trials
        ],
        "learning": to_jsonable_python(result.learning),
    }


def person_document(person: PersonParameters) -> dict[str, object]:
    """Return a person's parameters by name, ready for JSON."""
    numbers = ((field.name, getattr(person, field.name)) for field in fields(person))
    return {name: value._asdict() if isinstance(value, PracticeEffect) else value for name, value in numbers}


def _put_in_place(part: Path, folder: Path) -> None:
    """Rename `part` to `folder`; an existing folder is removed only after the new one is in its place."""
    old = None
    if folder.exists():
        old = Path(tempfile.mkdtemp(dir=folder.parent, prefix=f".{folder.name}.", suffix=".old"))
        folder.replace(old)
    try:
        part.replace(folder)
    except OSError:
        if old:
            old.replace(folder)
        raise
    if old:
        shutil.rmtree(old, ignore_errors=True)


def cell(value: object) -> str:
    """Return a cell of a table: numbers in full precision, true or false in small letters."""
    return str(value).lower() if isinstance(value, bool | np.bool_) else repr(value)

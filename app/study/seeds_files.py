"""The files of a study with several seeds: as those of a study with one seed, over all seeds, all files or none."""

import csv
import dataclasses
import io
import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from pydantic_core import to_jsonable_python

from app import __version__
from app.scoring.measures import TRIAL_MEASURES
from app.source import STUDY_SOURCE, source_description
from app.study.experiment import StudyResult
from app.study.seeds import EARLY, MEASURES, MeasureOverSeeds, decimated, measure_over_seeds
from app.study.study_files import (
    TRIAL_COLUMNS,
    Draw,
    atomic_folder,
    cell,
    person_document,
    trajectories_table,
)
from app.texts import Text, Value

if TYPE_CHECKING:
    import pyarrow as pa


def write_seeds(results: Sequence[StudyResult], folder: Path, draw: Draw, overwrite: bool = False) -> None:
    """Write studies that differ in their seeds into `folder`, all files or none.

    `draw` draws the figures into the folder given to it.

    Raises
    ------
    ValueError
        When `folder` is a file, or holds something and may not be overwritten.
    OSError
        When the place cannot be written; nothing is left behind then.
    """
    import pyarrow.parquet

    with atomic_folder(folder, overwrite) as part:
        (part / "trials.csv").write_text(seeds_csv(results), encoding="utf-8")
        pyarrow.parquet.write_table(_trajectories(results), part / "trajectories.parquet", compression="zstd")
        document = json.dumps(seeds_summary(results), indent=1, allow_nan=False)
        (part / "study.json").write_text(document + "\n", encoding="utf-8")
        draw(part)


def seeds_csv(results: Sequence[StudyResult]) -> str:
    """Return the table of all trials of all seeds, one row each: `seed`, then the columns of a study with one seed."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(("seed", *TRIAL_COLUMNS))
    for result in results:
        for trial in result.trials:
            row = {"trial": trial.number, "simulated": STUDY_SOURCE.simulated, **trial.measures}
            writer.writerow([result.seed, *(cell(row[column]) for column in TRIAL_COLUMNS)])
    return text.getvalue()


def seeds_summary(results: Sequence[StudyResult]) -> dict[str, object]:
    """Return the conditions, the measures over all seeds, and each study's trials, ready for JSON."""
    first = results[0]
    return {
        "software": f"bodydrive {__version__}",
        "source": source_description(STUDY_SOURCE),
        "seeds": [result.seed for result in results],
        "trials_per_seed": len(first.trials),
        "floorplan": first.floorplan.name,
        "path": first.path.name,
        "path_length": first.path.line.length,
        "sample_rate": first.sample_rate,
        "person": person_document(first.person),
        "not_reached": sum(not trial.measures["reached"] for result in results for trial in result.trials),
        "over_seeds": {measure: dataclasses.asdict(measure_over_seeds(results, measure)) for measure in MEASURES},
        "studies": [
            {
                "seed": result.seed,
                "trials": [
                    {"trial": trial.number, "stops_for_faults": trial.faults, **trial.measures}
                    for trial in result.trials
                ],
                "learning": {
                    measure: to_jsonable_python({part: result.learning[measure][part] for part in ("text", "details")})
                    for measure in MEASURES
                },
            }
            for result in results
        ],
    }


def sentences(results: Sequence[StudyResult]) -> list[str]:
    """Return the measures over all seeds in plain sentences."""
    lines = [_sentence(measure, measure_over_seeds(results, measure), len(results)) for measure in MEASURES]
    trials = sum(len(result.trials) for result in results)
    missed = sum(not trial.measures["reached"] for result in results for trial in result.trials)
    if missed:
        lines.append(Text("study-left-out", missed=missed, count=trials))
    return [str(line) for line in lines]


def _sentence(measure: str, over: MeasureOverSeeds, seeds: int) -> Text:
    entry = TRIAL_MEASURES[measure]

    def number(value: float | None) -> Text | str:
        return Text("study-none-reached") if value is None else entry.level(value)

    values: dict[str, Value] = {
        "measure": entry.name,
        "first": number(over.median[0]),
        "last": number(over.median[-1]),
        "trials": len(over.median),
        "seeds": seeds,
        "falls": over.falls,
        "rises": over.rises,
        "no_trend": over.no_trend,
        "early": EARLY,
        "early_steps": over.early_steps,
    }
    if over.median_step is None:
        return Text("study-over-seeds", **values)
    return Text("study-over-seeds-step", **values, step=over.median_step)


def _trajectories(results: Sequence[StudyResult]) -> "pa.Table":
    """Return the trajectories of all seeds, about ten rows a second, with the column `seed` first."""
    import pyarrow as pa

    first = results[0]
    sparse = dataclasses.replace(first, trials=tuple(decimated(trial) for trial in first.trials))
    tables = []
    for result in (sparse, *results[1:]):
        table = trajectories_table(result)
        tables.append(table.add_column(0, "seed", pa.array(np.full(table.num_rows, result.seed, dtype=np.int32))))
    return pa.concat_tables(tables)

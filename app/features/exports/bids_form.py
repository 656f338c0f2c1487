"""Recordings as a BIDS-motion data set (https://bids-specification.readthedocs.io, modality "motion").

The shirt is one tracking system, with channels of the type MISC in V; the wheelchair another one, with POS, ORNT and
VEL. The first column of each file is LATENCY: the seconds since the start of the run at which the row was recorded.
"""

import json
import re
from contextlib import ExitStack
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.features.exports.csv_tables import channel_names
from app.recording.format import Columns
from app.recording.groups import RunGroups
from app.texts import Text

LATENCY = ("latency", "n/a", "LATENCY", "n/a", "s")
CHAIR = {  # recorded column -> name, component, type, tracked point, unit
    "x": ("chair_x", "x", "POS", "wheelchair", "m"),
    "y": ("chair_y", "y", "POS", "wheelchair", "m"),
    "theta": ("chair_theta", "z", "ORNT", "wheelchair", "rad"),
    "v": ("chair_v", "x", "VEL", "wheelchair", "m/s"),
    "omega": ("chair_omega", "z", "GYRO", "wheelchair", "rad/s"),
    "driven_v": ("chair_driven_v", "x", "VEL", "wheelchair", "m/s"),
    "driven_omega": ("chair_driven_omega", "z", "GYRO", "wheelchair", "rad/s"),
}
README = Text("exports-bids-readme")


def label(text: str) -> str:
    """Return a text as a BIDS label, which has letters and digits only."""
    return re.sub(r"[^0-9A-Za-z]", "", text) or "x"


def dataset_files(folder: Path, patient: str, version: str) -> list[Path]:
    """Write the files that describe the data set; return them."""
    description = {
        "Name": str(Text("exports-bids-name", patient=patient)),
        "BIDSVersion": "1.10.0",
        "DatasetType": "raw",
        "License": "n/a",
        "Authors": ["n/a"],
        "GeneratedBy": [{"Name": "bodydrive", "Version": version}],
    }
    contents = {
        "dataset_description.json": json.dumps(description, indent=2),
        "README": f"{README}\n",
        "participants.tsv": f"participant_id\nsub-{label(patient)}\n",
    }
    for name, content in contents.items():
        (folder / name).write_text(content)
    return [folder / name for name in contents]


def write_bids(run: RunGroups, facts: dict[str, Any], folder: Path, place: dict[str, Any]) -> list[Path]:
    """Write the files of one run; `place` has patient, session, task and run."""
    subject, session = f"sub-{label(place['patient'])}", f"ses-{place['session']:02d}"
    where = folder / subject / session / "motion"
    where.mkdir(parents=True, exist_ok=True)
    entities = f"{subject}_{session}_task-{label(place['task'])}"
    units = [channel.get("unit") or "V" for channel in run.meta["layout"]["channels"]]
    shirt = [(name, "n/a", "MISC", "n/a", unit) for name, unit in zip(channel_names(run.meta), units, strict=True)]
    systems = {"shirt": shirt, "wheelchair": list(CHAIR.values())}
    stems = {name: where / f"{entities}_tracksys-{name}_run-{place['run']:03d}" for name in systems}
    spans = dict.fromkeys(systems, Span())
    with ExitStack() as stack:
        tables = {name: stack.enter_context(Path(f"{stem}_motion.tsv").open("wb")) for name, stem in stems.items()}
        for columns in run.groups:
            for name, values in _rows(columns).items():
                tables[name].write(_tab_separated(values))
                spans[name] = spans[name].then(values[0])
    files = []
    for name, channels in systems.items():
        # The loop also turns between the frames of a slow shirt, so that the rate of the chair's rows is measured.
        nominal, span = float(run.meta["sample_rate"]), spans[name]
        rate = (span.rate or nominal) if name == "wheelchair" else nominal
        table = "\t".join(("name", "component", "type", "tracked_point", "units", "sampling_frequency"))
        lines = [table, *("\t".join((*channel, f"{rate:g}")) for channel in (LATENCY, *channels))]
        Path(f"{stems[name]}_channels.tsv").write_text("\n".join(lines) + "\n")
        sidecar = _sidecar(name, channels, rate, span, place, facts)
        Path(f"{stems[name]}_motion.json").write_text(json.dumps(sidecar, indent=2, ensure_ascii=False))
        files += [Path(f"{stems[name]}_{end}") for end in ("channels.tsv", "motion.json", "motion.tsv")]
    return files


class Span(NamedTuple):
    """How many rows there are, and the times of the first and the last one, s."""

    rows: int = 0
    first: float = 0.0
    last: float = 0.0

    def then(self, times: NDArray[np.float64]) -> "Span":
        """Return the span with these later rows, too."""
        if not len(times):
            return self
        return Span(self.rows + len(times), self.first if self.rows else float(times[0]), float(times[-1]))

    @property
    def duration(self) -> float:
        """Return the time from the first row to the last, s."""
        return self.last - self.first

    @property
    def rate(self) -> float:
        """Return how many rows there are in a second, Hz; 0 for fewer than two."""
        return round((self.rows - 1) / self.duration, 3) if self.duration > 0.0 else 0.0


def _rows(columns: Columns) -> dict[str, list[Any]]:
    frames = columns["has_frame"].astype(bool)
    time = columns["run_t"]
    return {
        "shirt": [time[frames], *columns["values"][frames].T],
        "wheelchair": [time, *(columns[name] for name in CHAIR)],
    }


def _tab_separated(values: list[Any]) -> bytes:
    """Return columns as lines without a header; a number that was not measured is `n/a`."""
    import pyarrow as pa
    from pyarrow import compute
    from pyarrow.csv import WriteOptions, write_csv

    texts = []
    for column in values:
        numbers = np.ascontiguousarray(column)
        texts.append(compute.fill_null(pa.array(numbers, mask=np.isnan(numbers)).cast(pa.string()), "n/a"))
    sink = pa.BufferOutputStream()
    options = WriteOptions(include_header=False, delimiter="\t", quoting_style="none")
    write_csv(pa.table(texts, names=[str(place) for place in range(len(texts))]), sink, options)
    return bytes(sink.getvalue())


def _sidecar(
    system: str, channels: list[Any], rate: float, span: Span, place: dict[str, Any], facts: dict[str, Any]
) -> dict[str, Any]:
    kinds = [channel[2] for channel in channels]
    return {
        "TaskName": label(place["task"]),
        "TaskDescription": place["task"],
        "SamplingFrequency": rate,
        "TrackingSystemName": system,
        "RecordingType": "continuous",
        "SamplingFrequencyEffective": span.rate or rate,
        "RecordingDuration": round(span.duration, 3),
        "TrackedPointsCount": 0 if system == "shirt" else 1,
        "MotionChannelCount": len(kinds) + 1,
        **{f"{kind}ChannelCount": kinds.count(kind) for kind in sorted({*kinds} - {"LATENCY"})},
        "LATENCYChannelCount": 1,
        "Manufacturer": "bodydrive",
        "SoftwareVersions": facts["software"],
        "MissingValues": "n/a",
        **{f"Bodydrive{name.title().replace('_', '')}": value for name, value in facts.items()},
    }

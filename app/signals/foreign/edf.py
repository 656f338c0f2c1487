"""Reads EDF, EDF+, BDF and BDF+ with edfio."""

from collections import defaultdict
from pathlib import Path
from typing import Any

import numpy as np

from app.signals.column_names import unique_names
from app.signals.foreign.recording import ForeignRecording, SampledStream, even_times, library, of_streams


def read(file: Path, part: str | None = None) -> ForeignRecording:
    """Return the signals at the highest of their rates, or those of one rate."""
    edfio = library("edfio")
    is_bdf = file.suffix.lower() == ".bdf" and hasattr(edfio, "read_bdf")
    content = (edfio.read_bdf if is_bdf else edfio.read_edf)(file)
    by_rate: dict[float, list[Any]] = defaultdict(list)
    for signal in content.signals:
        by_rate[float(signal.sampling_frequency)].append(signal)
    streams = [
        SampledStream(
            f"{rate:g} Hz",
            even_times(len(signals[0].data), rate),
            np.column_stack([np.asarray(signal.data, np.float64) for signal in signals]),
            unique_names(str(signal.label).strip() for signal in signals),
            [str(signal.physical_dimension).strip() for signal in signals],
        )
        for rate, signals in by_rate.items()
    ]
    return of_streams(file, streams, part)

"""The time lines of trials, made once in each language from their recordings and cached as compressed bytes."""

import gzip
from pathlib import Path
from typing import Any

from app.computing_process import ComputingProcess
from app.derived_results import DerivedResults
from app.scoring.timeline import timeline_of
from app.texts import current_language, reader_language

KEPT = 16  # time lines in memory, about 0.25 MB each


class Timelines:
    """Makes each time line once; the recording of an ended trial never changes."""

    def __init__(self, computing: ComputingProcess) -> None:
        self._computing = computing
        self._packed: DerivedResults[tuple[Path, str], bytes] = DerivedResults(KEPT)  # by recording and language

    def of(self, folder: Path, path_points: list[Any], end: str | None) -> bytes:
        """Return the time line of an ended trial as compressed JSON.

        Raises
        ------
        ValueError
            In one sentence, when there is no recording, or it holds nothing.
        """
        language = current_language()
        return self._packed.of(
            (folder, language), lambda: self._computing.ask(packed_timeline, folder, path_points, end, language)
        )


def packed_timeline(folder: Path, path_points: list[Any], end: str | None, language: str) -> bytes:
    """Return the time line of an ended trial as compressed JSON, in a language; ValueError when there is none."""
    with reader_language(language):
        return gzip.compress(timeline_of(folder, path_points, end).model_dump_json().encode(), 5, mtime=0)

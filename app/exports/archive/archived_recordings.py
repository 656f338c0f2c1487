"""Checks the recordings of an archive: each says what it was recorded from, and all its rows can be read."""

import json
from pathlib import Path
from typing import Annotated, Any

from pydantic import ConfigDict, Field, ValidationError

from app.cues import Cue
from app.layout import ShirtLayout
from app.messages import MAX_GESTURES
from app.quantities import Document, Hertz, Name
from app.recording.format import PER_CHANNEL
from app.recording.groups import read_in_groups
from app.store.records.archived_rows import first_words


class RecordingHeader(Document):
    """What every export and review reads of `run.json`; its other fields are read with care where they are used."""

    model_config = ConfigDict(extra="allow", frozen=True, allow_inf_nan=False)

    layout: ShirtLayout
    sample_rate: Hertz
    gestures: Annotated[tuple[Name, ...], Field(max_length=MAX_GESTURES)] = ()
    cues: tuple[Cue, ...] = ()
    software: str = ""
    kind: Name | None = None
    path: Name | None = None
    parameters: dict[str, Any] | None = None
    floorplan: dict[str, Any] | None = None


def wrong_recording(folder: Path) -> str:
    """Say in half a sentence what is wrong with a recording, empty when nothing is; damage that is known is not wrong.

    A recording of which nothing is known but its numbers, because `run.json` was lost, is exported by nobody.
    """
    import pyarrow as pa

    where = f"the recording '{folder.name}'"
    try:
        run = read_in_groups(folder)
        header = RecordingHeader.model_validate_json(json.dumps(run.meta), strict=True) if run.meta else None
        for rows in run.groups:
            many = len(rows["t"])
            if header is not None and many and rows[PER_CHANNEL].shape[1] != len(header.layout.channels):
                return f"{where} has other channels than its layout"
            if header is not None and many and rows["score"].shape[1] != len(header.gestures):
                return f"{where} has other gestures than it names"
    except ValidationError as error:
        return f"{where}, {first_words(error)}"
    except (pa.ArrowException, OSError, ValueError, TypeError, KeyError, AttributeError, NotImplementedError):
        return f"{where} cannot be read"
    return ""

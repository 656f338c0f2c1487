"""The version of the software that made a recording."""

import json
from pathlib import Path

from app.recording.format import META_FILE

UNKNOWN = "unknown"


def recorded_with(folder: Path) -> str:
    """Return the version that a recording names; "unknown" when it is gone, cannot be read, or names none."""
    try:
        meta = json.loads((folder / META_FILE).read_bytes())
    except (OSError, ValueError):
        return UNKNOWN
    return str(meta.get("software", UNKNOWN)) if isinstance(meta, dict) else UNKNOWN

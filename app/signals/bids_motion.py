"""What lies beside a table of BIDS-motion, which has no header: the names of its columns, and its sample rate."""

import json
from pathlib import Path
from typing import Final

from app.signals.csv_dialect import cells_of

MOTION: Final = "_motion.tsv"
CHANNELS: Final = "_channels.tsv"
SIDECAR: Final = "_motion.json"


def named_beside(path: Path, count: int) -> tuple[list[str], list[str]] | None:
    """Return the names and units of the columns of a table; None where no list of `count` channels lies beside it."""
    lines = _text_beside(path, CHANNELS).splitlines()
    if not lines:
        return None
    header, *rows = [cells_of(line, "\t") for line in lines if line.strip()]
    if "name" not in header or len(rows) != count:
        return None
    rows = [[*row, *[""] * len(header)] for row in rows]
    units = [row[header.index("units")] if "units" in header else "" for row in rows]
    return [row[header.index("name")] for row in rows], ["" if unit == "n/a" else unit for unit in units]


def rate_beside(path: Path) -> float | None:
    """Return the sample rate (Hz) that the description of a table states; None where it states none."""
    try:
        document = json.loads(_text_beside(path, SIDECAR))
    except ValueError:
        return None
    rate = document.get("SamplingFrequency") if isinstance(document, dict) else None
    return float(rate) if isinstance(rate, int | float) and rate > 0 else None


def _text_beside(path: Path, ending: str) -> str:
    """Return the content of a file of the same name with another ending, empty where there is none."""
    if not path.name.endswith(MOTION):
        return ""
    try:
        return path.with_name(path.name.removesuffix(MOTION) + ending).read_text(encoding="utf-8", errors="replace")
    except OSError:
        return ""

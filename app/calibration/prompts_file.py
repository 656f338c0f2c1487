"""Reads the table of prompts of a recorded file: start, end, joint."""

from pathlib import Path

from app.calibration.fit.repetitions import Prompt
from app.layout import ShirtLayout
from app.signals.columns import read_table
from app.texts import Text


def read_prompts(path: Path, layout: ShirtLayout, first: float, last: float) -> list[Prompt]:
    """Return the rows of a table of prompts for a recording that lasts from `first` to `last` (s).

    A prompt may reach beyond the end of the recording, but not lie outside of it.

    Raises
    ------
    ValueError
        One sentence that names the file and line, and what to do.
    """
    table = read_table(path, text=("joint",), only=("start", "end", "joint"))
    starts, ends = table.numbers("start"), table.numbers("end")
    if "joint" not in table.columns:
        raise ValueError(Text("calibration-prompts-no-joint", file=str(path)))
    prompts = []
    for row, (start, end, joint) in enumerate(zip(starts, ends, map(str, table.columns["joint"]), strict=True)):
        where = table.places.row(row)
        if joint not in layout.joint_names:
            names = ", ".join(layout.joint_names)
            raise ValueError(
                Text("calibration-prompts-joint", place=where, joint=joint, layout=layout.name, names=names)
            )
        if end <= start:
            raise ValueError(Text("calibration-prompts-order", place=where, start=_rounded(start), end=_rounded(end)))
        if end <= first or start >= last:
            times = {"start": start, "end": end, "first": first, "last": last}
            raise ValueError(
                Text("calibration-prompts-outside", place=where, **{name: _rounded(t) for name, t in times.items()})
            )
        prompts.append(Prompt(float(start), float(end), joint))
    return prompts


def _rounded(t: float) -> float:
    """Return a time with six digits: more tell nobody where to look."""
    return float(f"{t:g}")

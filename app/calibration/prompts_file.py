"""Reads the table of prompts of a recorded file: start, end, joint."""

from pathlib import Path

from app.calibration.fit.repetitions import Prompt
from app.layout import ShirtLayout
from app.signals.columns import read_columns, require_column, row_place


def read_prompts(path: Path, layout: ShirtLayout, first: float, last: float) -> list[Prompt]:
    """Return the rows of a table of prompts for a recording that lasts from `first` to `last` (s).

    A prompt may reach beyond the end of the recording, but not lie outside of it.

    Raises
    ------
    ValueError
        One sentence that names the file and line, and what to do.
    """
    table = read_columns(path, text=("joint",), only=("start", "end", "joint"))
    starts, ends = require_column(table, path, "start"), require_column(table, path, "end")
    if "joint" not in table:
        raise ValueError(f"{path}: there is no column 'joint', add it with the name of the joint that moved")
    prompts = []
    for row, (start, end, joint) in enumerate(zip(starts, ends, map(str, table["joint"]), strict=True)):
        where = row_place(path, row)
        if joint not in layout.joint_names:
            names = ", ".join(layout.joint_names)
            raise ValueError(f"{where}: there is no joint '{joint}' in '{layout.name}', use one of {names}")
        if end <= start:
            raise ValueError(
                f"{where}: the prompt ends at {end:g} s, which is not after its start at {start:g} s, "
                f"correct or remove it"
            )
        if end <= first or start >= last:
            raise ValueError(
                f"{where}: the prompt from {start:g} to {end:g} s lies outside the recording, which goes from "
                f"{first:g} to {last:g} s, correct or remove it"
            )
        prompts.append(Prompt(float(start), float(end), joint))
    return prompts

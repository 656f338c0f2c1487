"""The files of a small shirt."""

import numpy as np
import pytest

from app.layout import Channel, Joint, ShirtLayout

STROKES = {"right_elbow": (3, 7), "left_elbow": (5, 9)}  # s: where a movement begins
GAINS = (-1.0, 0.5, 0.2)


@pytest.fixture
def shirt(tmp_path):
    """Write signals.csv, layout.json and prompts.csv of a shirt of two joints; return the table, t first."""
    layout = ShirtLayout(
        name="two elbows",
        channels=tuple(Channel(name=f"{joint}_{i}", joint=joint) for joint in STROKES for i in range(len(GAINS))),
        joints=tuple(Joint(name=joint, label=joint) for joint in STROKES),
    )
    (tmp_path / "layout.json").write_text(layout.model_dump_json())
    t = np.arange(1200) / 100
    noise = np.random.default_rng(5)
    columns = [t]
    for starts in STROKES.values():
        bent = sum(0.5 - 0.5 * np.cos(np.pi * np.clip(t - start, 0, 2)) for start in starts)
        columns += [gain * bent + 0.004 * noise.normal(size=len(t)) for gain in GAINS]
    table = np.column_stack(columns)
    _write_table(tmp_path / "signals.csv", table)
    rows = [f"{start},{start + 1},{joint}" for joint, starts in STROKES.items() for start in starts]
    (tmp_path / "prompts.csv").write_text("\n".join(["start,end,joint", *rows]) + "\n")
    return table


@pytest.fixture
def write_table():
    return _write_table


def _write_table(file, table):
    names = [f"{joint}_{i}" for joint in STROKES for i in range(len(GAINS))]
    np.savetxt(file, table, "%.9g", ",", header=",".join(["t", *names]), comments="")

"""The files of a small shirt."""

import numpy as np
import pytest

from app.layout import Channel, Joint, ShirtLayout

STROKES = {"right_elbow": (3, 7), "left_elbow": (5, 9)}  # s: where a movement begins
GAINS = (-1.0, 0.5, 0.2)


@pytest.fixture
def shirt(tmp_path):
    """Write the files of a shirt of two joints; return the table, t first."""
    return write_shirt(tmp_path, "two elbows", STROKES, (GAINS, GAINS), seconds=12, seed=5)


def write_shirt(folder, name, strokes, gains, seconds, seed, form="%.9g"):
    """Write signals.csv, layout.json and prompts.csv of joints that bend for 1 s and return; return the table."""
    layout = ShirtLayout(
        name=name,
        channels=tuple(Channel(name=f"{joint}_{i}", joint=joint) for joint in strokes for i in range(len(GAINS))),
        joints=tuple(Joint(name=joint, label=joint) for joint in strokes),
    )
    (folder / "layout.json").write_text(layout.model_dump_json())
    t = np.arange(100 * seconds) / 100
    noise = np.random.default_rng(seed)
    columns = [t]
    for starts, of_joint in zip(strokes.values(), gains, strict=True):
        bent = sum(0.5 - 0.5 * np.cos(np.pi * np.clip(t - start, 0, 2)) for start in starts)
        columns += [gain * bent + 0.004 * noise.normal(size=len(t)) for gain in of_joint]
    table = np.column_stack(columns)
    write_table(folder / "signals.csv", table, form)
    rows = [f"{start},{start + 1},{joint}" for joint, starts in strokes.items() for start in starts]
    (folder / "prompts.csv").write_text("\n".join(["start,end,joint", *rows]) + "\n")
    return table


def write_table(file, table, form="%.9g"):
    names = [f"{joint}_{i}" for joint in STROKES for i in range(len(GAINS))]
    np.savetxt(file, table, form, ",", header=",".join(["t", *names]), comments="")

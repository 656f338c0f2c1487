"""The recordings of real people in the knitted sleeve, with prompts made from the measured angle."""

from pathlib import Path

import numpy as np

from app.calibration.fit.repetitions import Prompt
from app.signals.columns import read_columns
from app.signals.signals import read_layout, read_signals
from bench.prior.wearers import JointPart, Wearer, movement_of

FOLDER = Path(__file__).parents[3] / "shared" / "data" / "knit_people"
LEAD, SPREAD = 0.3, 0.15  # s by which cues come before the movement, mean and standard deviation
MOVEMENT = 10.0  # s


def knit_people(seed: int = 1) -> list[Wearer]:
    """Return one wearer per recording; those who shared a fitting of the sleeve are one group."""
    layout = read_layout(FOLDER / "layout.json")
    joint = layout.joint_names[0]
    rng = np.random.default_rng(seed)
    wearers = []
    for file in sorted(FOLDER.glob("*.parquet")):
        signals = read_signals(file, layout)
        angle = read_columns(file, only=("angle_deg",))["angle_deg"].astype(np.float64)
        rate, code = signals.sample_rate, file.stem[-3:]
        movement = movement_of(angle, rate)
        prompts = []
        for start, stop in movement.strokes:
            lead = rng.normal(LEAD, SPREAD)
            if stop / rate > lead:
                prompts.append(Prompt(max(0.0, start / rate - lead), stop / rate - lead, joint))
        wearers.append(
            Wearer(
                code=code,
                group=f"fitting {(int(code[1:]) + 1) // 2}",
                layout=layout,
                sample_rate=rate,
                t=np.arange(len(angle)) / rate,
                values=signals.values.astype(np.float64),
                free=slice(0, round(MOVEMENT * rate)),
                parts=(JointPart(joint, slice(0, len(angle)), tuple(prompts), movement),),
            )
        )
    return wearers

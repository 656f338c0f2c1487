"""The guided map beside the paper's on a real knit: four people's sleeves, read as four joints.

`python -m bench.learning.guided_map --seeds 20` prints the first table of docs/learning/guided-map.md.
"""

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from numpy.typing import NDArray

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import Prompt, repetitions_of_prompts, stretches_of_prompts
from app.calibration.guided.guided_map import GuidedFit, with_guided_maps
from app.calibration.linear_map import MapKind
from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import standard_parameters
from app.layout import Channel, Joint, ShirtLayout
from app.pipeline.replay.batch import decode_block
from app.signals.columns import read_columns
from app.signals.low_pass import STANDARD_CUTOFF, smooth
from app.signals.signals import read_signals

FOLDER = Path(__file__).parents[3] / "shared" / "data" / "knit_shirt"
JOINTS = ("right_elbow", "left_elbow", "right_shoulder", "left_shoulder")
LAYOUT = ShirtLayout(
    name="knit",
    channels=tuple(Channel(name=f"{joint}_{i}", joint=joint) for joint in JOINTS for i in range(5)),
    joints=tuple(Joint(name=joint, label=joint.replace("_", " ")) for joint in JOINTS),
)
RISING = 0.1  # of the angle's span per second: above it the joint moves up
SHORTEST = 0.1  # s of a movement
LARGE = 0.3  # of the angle's span: what is counted as a movement when hits are
LEAD, SPREAD = 0.3, 0.15  # s by which cues come before the movement, mean and standard deviation
CALIBRATION = 20.0  # s that everything is fitted to
OTHER_STRETCHES = (20.0, 30.0, 70.0, 80.0, 98.0)  # s: where the calibration begins instead
OTHER_SEEDS = 4

Array = NDArray[np.float64]


class Knit:
    """The recordings at a sample rate, the measured rising phases, and prompts made from them."""

    def __init__(self, rate: float = 100.0) -> None:
        signals = read_signals(FOLDER / "signals.csv", LAYOUT)
        angles = read_columns(FOLDER / "joint_angles.csv", only=JOINTS)
        self.rate = rate
        self.t = np.arange(0.0, signals.t[-1], 1 / rate)
        self.values = np.stack([np.interp(self.t, signals.t, one) for one in signals.values.T], axis=1)
        self.rising: dict[str, NDArray[np.bool_]] = {}
        self.phases: dict[str, list[tuple[int, int, float]]] = {}  # first row, row after the last, share of the span
        for joint in JOINTS:
            angle = np.interp(self.t, signals.t, angles[joint].astype(np.float64))
            smoothed = smooth(angle, STANDARD_CUTOFF, rate)  # as the signals are
            rising = np.diff(smoothed, prepend=smoothed[0]) * rate / np.ptp(angle) > RISING
            edges = np.flatnonzero(np.diff(np.concatenate(([0], rising, [0]))))
            phases = [(a, b) for a, b in zip(edges[::2], edges[1::2], strict=True) if b - a > SHORTEST * rate]
            self.rising[joint] = rising
            self.phases[joint] = [(a, b, float((smoothed[b - 1] - smoothed[a]) / np.ptp(angle))) for a, b in phases]

    def prompts(
        self,
        seed: int,
        start: float = 0.0,
        end: float = CALIBRATION,
        lead: float = LEAD,
        spread: float = SPREAD,
        most: int | None = None,
    ) -> list[Prompt]:
        """Return prompts from `start` to `end` (s), each `lead` ± `spread` (s) ahead; at most so many of a joint."""
        rng = np.random.default_rng(seed)
        rows = []
        for joint in JOINTS:
            within = [(a / self.rate, b / self.rate) for a, b, _ in self.phases[joint]]
            for a, b in [(a, b) for a, b in within if a > start + lead and b < end][:most]:
                by = rng.normal(lead, spread)
                rows.append(Prompt(max(start, a - by), b - by, joint))
        return rows

    def fit(
        self, rows: Sequence[Prompt], start: float = 0.0, end: float = CALIBRATION, values: Array | None = None
    ) -> GuidedFit:
        """Calibrate on the frames from `start` to `end` (s), with these prompts."""
        values = self.values if values is None else values
        window = (self.t >= start) & (self.t < end)
        repetitions = repetitions_of_prompts(self.t, values, rows, self.rate)
        stretches = stretches_of_prompts(self.t, values, rows, self.rate, until=end)
        clean = CleanRecording.of(LAYOUT, self.rate, values[window], None, repetitions, stretches)
        return with_guided_maps(fit_profile(clean), clean)

    def measures(
        self,
        profile: CalibrationProfile,
        kind: MapKind,
        start: float = 0.0,
        end: float = CALIBRATION,
        values: Array | None = None,
    ) -> Array:
        """Return (joints, 2) in-phase share, and hit rate in time, outside of the window, as `decode` gives them."""
        joints = [joint.model_copy(update={"map": kind if joint.guided else "pca"}) for joint in profile.joints]
        parameters = standard_parameters(profile.model_copy(update={"joints": tuple(joints)}))
        values = self.values if values is None else values
        decoded = decode_block(parameters, self.rate, self.t, values.astype(np.float32))
        outside = (self.t < start) | (self.t >= end)
        shares = []
        for gesture, activation in zip(parameters.gestures, decoded.activation.T, strict=True):
            measures = np.where(outside, activation, 0.0)
            moving = np.zeros(len(self.t), dtype=bool)
            for a, b, size in self.phases[gesture.joint]:
                moving[a:b] = size > LARGE and outside[a] and outside[b - 1]
            in_phase = measures[self.rising[gesture.joint]].sum() / measures.sum()
            shares.append((float(in_phase), float((measures[moving] > 0).mean())))
        return np.array(shares)


def table(knit: Knit, seeds: int) -> str:
    """Return the table of both maps on all joints, the median over the seeds, and how often the guided is offered."""
    lines = ["| joint | in phase: paper | guided | hit rate: paper | guided | offered |", "|---|---|---|---|---|---|"]
    fits = [knit.fit(knit.prompts(seed)).profile for seed in range(seeds)]
    paper, guided = (np.array([knit.measures(fit, kind) for fit in fits]) for kind in ("pca", "guided"))
    before, after = np.median(paper, axis=0), np.median(guided, axis=0)
    for i, joint in enumerate(fits[0].joints):
        offered = sum(fit.joints[i].guided is not None and fit.joints[i].best_map == "guided" for fit in fits)
        cells = (before[i, 0], after[i, 0], before[i, 1], after[i, 1])
        figures = " | ".join(f"{cell:.3f}" for cell in cells)
        lines.append(f"| {joint.name.replace('_', ' ')} | {figures} | {offered} of {seeds} |")
    medians = np.median(np.stack((before, after)), axis=1)
    lines.append("| median over the joints | " + " | ".join(f"{cell:.3f}" for cell in medians.T.ravel()) + " | |")
    gains = np.median(guided, axis=1) - np.median(paper, axis=1)
    return "\n".join([*lines, "", _gains("calibrated from 0 to 20 s", gains)])


def other_stretches(knit: Knit) -> str:
    """Return the gain with the calibration on other stretches of the recordings."""
    gains = []
    for start in OTHER_STRETCHES:
        for seed in range(OTHER_SEEDS):
            window = (start, start + CALIBRATION)
            fit = knit.fit(knit.prompts(seed, *window), *window).profile
            paper, guided = (knit.measures(fit, kind, *window) for kind in ("pca", "guided"))
            gains.append(np.median(guided, axis=0) - np.median(paper, axis=0))
    return _gains("calibrated on other stretches of 20 s", np.array(gains))


def _gains(which: str, gains: Array) -> str:
    """Return in words what the median over the joints gains (fits, 2): in phase and hits."""
    medians, worst = np.median(gains, axis=0), gains.min(axis=0)
    return (
        f"{which}, {len(gains)} fits: the median over the joints gains {medians[0]:+.3f} in phase (worst "
        f"{worst[0]:+.3f}) and {medians[1]:+.3f} hits (worst {worst[1]:+.3f})"
    )


def main(seeds: Annotated[int, typer.Option(min=1, help="Of the cues' lead.")] = 20) -> None:
    """Print the table, and what calibrations on other stretches gain."""
    if not FOLDER.exists():
        typer.echo(f"The recordings of the real knit are not here ({FOLDER}).")
        raise typer.Exit(1)
    knit = Knit()
    typer.echo(table(knit, seeds))
    typer.echo(other_stretches(knit))


if __name__ == "__main__":
    typer.run(main)

"""What putting the shirt on again does to simulated people's gestures, and what following it brings.

`python -m bench.learning.donning --people 12` prints the table of docs/learning/adapting.md, "Does it help?".
"""

from collections.abc import Callable
from typing import Annotated

import numpy as np
import typer
from numpy.typing import NDArray

from app.calibration.adaptation.channel_range import shift_ranges
from app.calibration.adaptation.donning_range import fit_ranges
from app.calibration.adaptation.movement import Movement
from app.calibration.profile import CalibrationProfile
from app.calibration.script import calibration_script
from app.calibration.vocabulary import PAPER_VOCABULARY, standard_parameters
from app.hardware.shirt.simulated_fabric import Fabric
from app.pipeline.channel_health import ChannelHealth
from app.pipeline.projection import projections
from app.scoring.map_losses.losses import MOST_SILENT
from app.study.experiment import SEEDS_APART
from app.study.participant import Participant
from app.study.sessions import calibrated_participant
from app.study.simulated_calibration import record_step

DONNINGS = 4  # times that each person puts the shirt on again
AFTERWARDS = 4  # free movements in which it is counted what S5 silences

Ranges = Callable[[CalibrationProfile, Movement], CalibrationProfile]
RANGES: dict[str, Ranges] = {
    "as calibrated": lambda profile, _free: profile,
    "shifted": lambda profile, free: shift_ranges(profile, [free], profile),
    "fitted": lambda profile, free: fit_ranges(profile, free, profile),
}


def main(people: Annotated[int, typer.Option(min=1, help="How many, seeds 1, 2, ...")] = 12) -> None:
    """Print how many gestures S5 silences, and by how much the rate of the same movement changes."""
    silenced = dict.fromkeys(RANGES, 0)
    changes: list[float] = []
    for seed in range(1, people + 1):
        first = calibrated_participant("redonned", seed)
        fabric = Fabric(first.profile.layout, seed + SEEDS_APART)
        before = _answers(first.profile, fabric)
        for session in range(2, 2 + DONNINGS):
            first.participant.person.begin_session(session)
            first.participant.don_again()
            free = _free(first.participant)
            fabric.don_again()
            changes += np.log(_answers(first.profile, fabric) / before).tolist()
            later = np.concatenate([_free(first.participant).values for _ in range(AFTERWARDS)])
            for name, ranges in RANGES.items():
                silenced[name] += _silenced(ranges(first.profile, free), later)
    gestures = people * DONNINGS * len(PAPER_VOCABULARY)
    for name, count in silenced.items():
        typer.echo(f"ranges {name}: S5 silences {count} of {gestures} gestures for more than {MOST_SILENT:.0%}")
    typer.echo(f"the same movement: its rate changes by a factor with a standard deviation of {np.std(changes):.1%}")


def _free(participant: Participant) -> Movement:
    step = next(step for step in calibration_script(participant.layout) if step.kind == "free")
    values, _cue = record_step(participant, step)
    return Movement(values, participant.sample_rate, np.zeros(len(values), dtype=np.bool_))


def _answers(profile: CalibrationProfile, fabric: Fabric) -> NDArray[np.float64]:
    """Return how much the score (n_gestures,) of each joint's map changes in `fabric` when the joint moves."""
    return np.array(
        [
            abs(float(np.array(joint.direction) @ fabric.gains[list(joint.channels), fabric.joints.index(joint.name)]))
            for joint in profile.joints
            if joint.name in PAPER_VOCABULARY
        ]
    )


def _silenced(profile: CalibrationProfile, values: NDArray[np.floating]) -> int:
    """Return how many bound gestures S5 silences for more than 5 % of frames (n, n_channels)."""
    parameters = standard_parameters(profile)
    uses = projections(parameters).uses
    health = ChannelHealth(profile, np.asarray(uses.any(axis=0)), profile.sample_rate)
    bad = health.block(np.asarray(values, dtype=np.float64), None)
    return sum(float((bad & uses[i]).any(axis=1).mean()) > MOST_SILENT for i in parameters.bound_gestures)


if __name__ == "__main__":
    typer.run(main)

"""Checks the forecasts of gestures on many simulated people, who are calibrated as usual and then recorded for longer.

`python -m bench.learning.forecasts --wearers 20` prints the table of docs/learning/gestures.md.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Annotated, NamedTuple

import numpy as np
import typer
from numpy.typing import NDArray

from app.calibration.cued_runs import CuedRun, run_of_cues
from app.calibration.gestures.ability import Ability, abilities
from app.calibration.gestures.cross_check import hit_level
from app.calibration.gestures.discovery import discover
from app.calibration.gestures.evidence import Evidence, gather_evidence
from app.calibration.gestures.prediction import count_crossings, false_per_minute, rest_statistics
from app.calibration.profile import CalibrationProfile
from app.calibration.script import MOVE, PAUSE, RETURN, Step, calibration_script
from app.cues import Cue
from app.hardware.base import BodyView
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import PRACTISED
from app.hardware.shirt.standard import standard_layout
from app.study.participant import Participant
from app.study.simulated_calibration import fit_recorded, record_step
from app.texts import Text

SAMPLE_RATE = 100.0  # Hz
REST = 60.0  # s, held out
REPETITIONS = 10  # of each suggested gesture, held out
LOWERED = 3.0  # times the noise: a lowered dead-zone, so that there are false activations to count


class Kind(NamedTuple):
    """A kind of participant."""

    title: str
    tremor: float  # standard deviation, of a joint's range
    unevenness: float  # of the logarithm of a prompted movement's size, on top of the usual


KINDS = (
    Kind("able", 0.0, 0.0),
    Kind("tremor 1 %", 0.01, 0.0),
    Kind("tremor 3 %", 0.03, 0.0),
    Kind("uneven", 0.0, 0.4),
    Kind("uneven, tremor 3 %", 0.03, 0.4),
)


class Uneven(SimulatedPerson):
    """A person whose prompted movements differ in size."""

    def __init__(self, kind: Kind, seed: int) -> None:
        super().__init__(replace(PRACTISED, tremor=kind.tremor), seed)
        self._spread = kind.unevenness
        self._sizes = np.random.default_rng(seed)
        self._size = 1.0
        self._cue: Cue | None = None

    def step(self, dt: float, view: BodyView) -> NDArray[np.float64]:
        """Advance by `dt`, with a random size for each prompted movement."""
        if view.cue is not self._cue:
            self._cue = view.cue
            if view.cue is not None and view.cue.kind == "move":
                self._size = float(np.exp(self._spread * self._sizes.normal()))
            elif view.cue is None or view.cue.kind != "return":
                self._size = 1.0  # the tremor at rest is not scaled
        return super().step(dt, view) * self._size


@dataclass(slots=True)
class Tally:
    """Sums over people and gestures: predicted and counted numbers."""

    gestures: int = 0
    minutes: float = 0.0
    predicted_false: float = 0.0  # in all
    counted_false: int = 0
    predicted_lowered: float = 0.0  # with the lowered dead-zone
    counted_lowered: int = 0
    bounds_held: int = 0  # number of gestures whose counted rate was below the 95 % bound of the forecast
    predicted_hits: float = 0.0
    counted_hits: int = 0
    movements: int = 0
    errors: list[float] = field(default_factory=list)  # predicted minus counted hit rate, per gesture


def compare(kind: Kind, seed: int, tally: Tally, rest: float = REST, repetitions: int = REPETITIONS) -> None:
    """Calibrate one participant and compare the forecasts of suggested gestures with counts on later runs."""
    participant = Participant(Uneven(kind, seed), standard_layout(), SAMPLE_RATE, seed)
    recorded = [(step, *record_step(participant, step)) for step in calibration_script(participant.layout)]
    profile = fit_recorded(participant.layout, SAMPLE_RATE, recorded)
    runs = [run_of_cues(values, cue, step.cues) for step, values, cue in recorded]
    found = discover(profile, runs)
    before = gather_evidence(profile, runs)
    bound = {name for binding in found.suggestion.bindings for name in binding.gestures}
    chosen = [gesture for gesture in found.gestures if gesture.name in bound]
    later = [_more(participant, _rest(rest))]
    later += [_more(participant, _prompts(gesture.joint, repetitions)) for gesture in chosen]
    after = gather_evidence(profile, later)
    made = {ability.name: ability for ability in abilities(profile, after)}
    for gesture in chosen:
        forecast, truth = gesture.prediction, made[gesture.name]
        if forecast is None or forecast.false_per_minute is None or forecast.hit_rate is None:
            raise ValueError(f"seed {seed}: '{gesture.name}' has no forecast")
        quiet = [gesture.direction * piece for piece in after.at_rest(truth.column)]
        minutes = sum(map(len, quiet)) / SAMPLE_RATE / 60.0
        counted = count_crossings(quiet, gesture.dead_zone)
        _count_lowered(tally, profile, before, truth, quiet, minutes)
        level = hit_level(gesture.dead_zone, gesture.full)
        hits = sum(peak >= level for peak in truth.peaks)
        tally.gestures += 1
        tally.minutes += minutes
        tally.predicted_false += forecast.false_per_minute * minutes
        tally.counted_false += counted
        tally.bounds_held += counted / minutes < (forecast.counted_at_most or 0.0)
        tally.predicted_hits += forecast.hit_rate * len(truth.peaks)
        tally.counted_hits += hits
        tally.movements += len(truth.peaks)
        tally.errors.append(forecast.hit_rate - hits / len(truth.peaks))


def _count_lowered(
    tally: Tally,
    profile: CalibrationProfile,
    before: Evidence,
    truth: Ability,
    quiet: list[NDArray[np.float64]],
    minutes: float,
) -> None:
    lowered = LOWERED * profile.joints[truth.column].rest_rate
    known = rest_statistics(
        [*before.at_rest(truth.column), *before.in_pauses(truth.column, truth.joint.name)], SAMPLE_RATE
    )
    if known is not None:
        tally.predicted_lowered += false_per_minute(known, lowered) * minutes
        tally.counted_lowered += count_crossings(quiet, lowered)


def _more(participant: Participant, cues: Sequence[Cue]) -> CuedRun:
    """Record a further run with these cues."""
    step = Step("more", "rest", None, Text("more"), Text("more"), cues[-1].end, tuple(cues))
    values, cue = record_step(participant, step)
    return run_of_cues(values, cue, cues)


def _rest(seconds: float) -> list[Cue]:
    return [Cue(start=0.0, end=seconds, kind="rest")]


def _prompts(joint: str, repetitions: int) -> list[Cue]:
    cues = [Cue(start=0.0, end=1.0, kind="ready", joint=joint)]
    for number in range(1, repetitions + 1):
        for kind, seconds in (("move", MOVE), ("return", RETURN), ("rest", PAUSE)):
            start = cues[-1].end
            cues.append(Cue(start=start, end=start + seconds, kind=kind, joint=joint, repetition=number))
    return cues


def row(kind: Kind, tally: Tally) -> str:
    """Return a line of the table."""
    per_minute = 1.0 / tally.minutes
    cells = [
        kind.title,
        str(tally.gestures),
        f"{tally.predicted_false * per_minute:.2f}",
        f"{tally.counted_false * per_minute:.2f}",
        f"{tally.predicted_lowered * per_minute:.1f}",
        f"{tally.counted_lowered * per_minute:.1f}",
        f"{tally.bounds_held / tally.gestures:.0%}",
        f"{tally.predicted_hits / tally.movements:.3f}",
        f"{tally.counted_hits / tally.movements:.3f}",
        f"{float(np.std(tally.errors)):.3f}",
    ]
    return f"| {' | '.join(cells)} |"


def main(wearers: Annotated[int, typer.Option(min=1, help="Of each kind.")] = 20) -> None:
    """Print one line of the table for each kind of participant."""
    for kind in KINDS:
        tally = Tally()
        for seed in range(1, wearers + 1):
            compare(kind, seed, tally)
        typer.echo(row(kind, tally))


if __name__ == "__main__":
    typer.run(main)

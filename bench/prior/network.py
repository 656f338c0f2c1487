"""`python -m bench.prior.network`: would a small network beside the linear map help, on simulated people kept apart?

Eight units with a rectified linear output, trained on what the linear map of other people leaves of the labels, read
the same features; the rate of the network is the linear one and theirs. The mean of both rates, each divided by its
dead-zone, decodes. Only the linear map learns from a person's own prompts.

A garment is to have a network when it raises the share in phase at the 10th percentile by 0.01, or halves the false
activations at rest, after any time of own prompts (docs/decisions/0032-no-network-without-a-gain.md).
"""

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
import typer
from numpy.typing import NDArray

from app.calibration.features import features
from app.calibration.prior.frames import prompted_frames
from app.calibration.prior.moments import Moments, mean_of
from app.calibration.prior.scale import MOVEMENT, log_ranges, scales
from app.calibration.prior.solving import OwnFrames, solve, thresholds
from bench.prior.simulated import simulated_people
from bench.prior.wearers import (
    OWN_PROMPTS,
    TABLE_HEAD,
    Figures,
    JointPart,
    Wearer,
    figures_of,
    prompted_stretches,
    summary,
)

LINEAR, MEAN = "linear map of other people", "mean of the linear map and the network"  # as the table names them
UNITS = 8
EVERY = 5  # frames: neighbouring ones say nearly the same
ROUNDS = 60  # through the frames
LEAST_GAIN = 0.01  # of the share in phase at the 10th percentile
MOST_FALSE = 0.5  # of the false activations of the linear map

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class Labelled:
    """One joint of one person: what the pool learns from, and what is decoded."""

    wearer: Wearer
    part: JointPart
    frames: OwnFrames  # of all prompts
    scale: Array

    @classmethod
    def of(cls, wearer: Wearer, part: JointPart) -> "Labelled":
        """Return the labelled frames of a joint; every channel of a simulated shirt can be used."""
        channels = list(wearer.layout.channels_of_joint[part.joint])
        free = wearer.values[wearer.free][: round(MOVEMENT * wearer.sample_rate), channels]
        scale = scales(log_ranges(free, wearer.sample_rate), np.ones(len(channels), np.bool_))
        frames = prompted_frames(prompted_stretches(wearer, part.prompts), channels, scale, wearer.sample_rate)
        if frames is None:
            raise ValueError(f"{wearer.code}, {part.joint}: no prompted movement was found")
        return cls(wearer, part, frames, scale)

    def own(self, seconds: float, people: Moments) -> OwnFrames | None:
        """Return the labelled frames of the first `seconds` of prompts."""
        until = float(self.wearer.t[self.part.rows.start]) + seconds
        prompts = [prompt for prompt in self.part.prompts if prompt.end < until]
        channels = list(self.wearer.layout.channels_of_joint[self.part.joint])
        rate = self.wearer.sample_rate
        return prompted_frames(prompted_stretches(self.wearer, prompts, until), channels, self.scale, rate, people)

    @property
    def features(self) -> Array:
        """The features (n, d) of the joint's whole part."""
        channels = list(self.wearer.layout.channels_of_joint[self.part.joint])
        return features(self.wearer.values[self.part.rows][:, channels] / self.scale, self.wearer.sample_rate)


class Network:
    """What other people's frames teach beyond their linear map."""

    def __init__(self, pool: Sequence[Labelled], linear: Array) -> None:
        from sklearn.exceptions import ConvergenceWarning
        from sklearn.neural_network import MLPRegressor

        inputs = np.concatenate([one.frames.features[::EVERY] for one in pool])
        labels = np.concatenate([one.frames.label[::EVERY] for one in pool])
        self._size = np.sqrt((inputs**2).mean(axis=0)) + np.finfo(float).tiny
        self._linear = linear
        self._units = MLPRegressor(
            hidden_layer_sizes=(UNITS,), max_iter=ROUNDS, tol=0.0, n_iter_no_change=ROUNDS, random_state=0
        )
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)  # a fixed number of rounds is what is wanted
            self._units.fit(inputs / self._size, labels - inputs @ linear)
        strokes = self.rate(np.concatenate([one.frames.features[one.frames.label > 0] for one in pool]))
        # The same thresholds as those of the linear map: from the mean and the deviation of the pool's strokes.
        moments = Moments.of(strokes[:, None], np.ones(len(strokes), np.int8))
        self.dead_zone, self.full = thresholds(np.ones(1), moments)

    def rate(self, inputs: Array) -> Array:
        """Return the rate (n,) of features (n, d)."""
        rate: Array = inputs @ self._linear + self._units.predict(inputs / self._size)
        return rate


def judged(one: Labelled, people: Moments, network: Network, seconds: float) -> tuple[Figures, Figures]:
    """Return the figures of the linear map alone, and of its mean with the network."""
    own = one.own(seconds, people) if seconds else None
    weights = solve(people, one.wearer.sample_rate, own)
    dead_zone, full = thresholds(weights, people)
    inputs = one.features
    linear = inputs @ weights / dead_zone
    both = (linear + network.rate(inputs) / network.dead_zone) / 2.0
    alone = activation(linear, full / dead_zone)
    return (
        figures_of(one.wearer, one.part, alone),
        figures_of(one.wearer, one.part, activation(both, (full / dead_zone + network.full / network.dead_zone) / 2.0)),
    )


def activation(rate: Array, full: float) -> Array:
    """Return the activation (n,) of a rate in units of its dead-zone: 0 at the dead-zone, 1 at `full`."""
    return np.clip((rate - 1.0) / (full - 1.0), 0.0, 1.0)


def main(people: Annotated[int, typer.Option(min=9, help="Simulated people.")] = 20) -> None:
    """Compare the linear map of other people with and without a network, one person kept apart."""
    wearers = simulated_people(people)
    found: dict[tuple[float, str], list[Figures]] = {}
    for i in range(len(wearers[0].parts)):
        labelled = [Labelled.of(one, one.parts[i]) for one in wearers]
        for one in labelled:
            pool = [other for other in labelled if other is not one]
            moments = mean_of([Moments.of(other.frames.features, other.frames.label) for other in pool])
            network = Network(pool, solve(moments, one.wearer.sample_rate))
            for seconds in OWN_PROMPTS:
                for name, figures in zip((LINEAR, MEAN), judged(one, moments, network, seconds), strict=True):
                    found.setdefault((seconds, name), []).append(figures)
    typer.echo(TABLE_HEAD)
    for (seconds, name), rows in found.items():
        typer.echo(f"| {seconds:g} s | {name} | {summary(rows)} |")
    typer.echo(verdict(found))


def verdict(found: Mapping[tuple[float, str], Sequence[Figures]]) -> str:
    """Return in a sentence after which amounts of own prompts the rule offers a network; keys: seconds, map."""
    times = sorted({seconds for seconds, _ in found})
    helps = [f"{seconds:g} s" for seconds in times if is_better(found[seconds, LINEAR], found[seconds, MEAN])]
    after = f"own prompts of {', '.join(helps)}" if helps else "no amount of own prompts"
    return f"A network would be offered after {after}."


def is_better(alone: Sequence[Figures], both: Sequence[Figures]) -> bool:
    """Return whether the network is worth its place: the rule at the top of this file."""
    gain = np.percentile([one.in_phase for one in both], 10) - np.percentile([one.in_phase for one in alone], 10)
    false_alone, false_both = (float(np.mean([one.false_per_minute for one in rows])) for rows in (alone, both))
    return bool(gain >= LEAST_GAIN or (false_alone > 0.0 and false_both <= MOST_FALSE * false_alone))


if __name__ == "__main__":
    typer.run(main)

"""Trials of the simulated person, a shirt that is put on again, and maps of other kinds."""

import numpy as np
from calibration.simulated_person import JOINTS

from app.calibration.adaptation.movement import Movement
from app.calibration.linear_map import LinearMap
from building import guided_map


def trial(person, size=1.0, noise=1.0, repetitions=4, joints=JOINTS):
    """Return a trial in which each joint makes `repetitions` strokes, one joint after the other."""
    person.noise, before = person.noise * noise, person.noise
    pieces = [person.rest(3.0)]
    for _ in range(repetitions):
        for joint in joints:
            pieces += [person.repetition(joint, size=size).values, person.rest(1.0)]
    person.noise = before
    values = np.concatenate(pieces)
    return Movement(values, person.sample_rate, np.ones(len(values), dtype=bool))


def put_on_again(person, share=0.25):
    person.gains = person.gains * (1 + share * person.rng.normal(size=person.gains.shape))


def with_map_of(joint, kind):
    """Return the joint with a map of this kind, which reads it as its PCA map does."""
    if kind == "prior":
        prior = LinearMap(
            rates=(joint.pca.rates[0], *((0.0,) * len(joint.channels),) * 4),
            dead_zone=joint.pca.dead_zone,
            full=joint.pca.full,
            people=8,
        )
        return joint.model_copy(update={"map": kind, "prior": prior})
    guided = guided_map(joint.pca.rates, joint.pca.dead_zone, joint.pca.full)
    return joint.model_copy(update={"map": kind, "guided": guided})


def known(figure: float | None) -> float:
    """Return a figure that a test expects to be known."""
    assert figure is not None
    return figure

"""Simulated people in one simulated shirt: the same fabric, put on anew, with each person's own gains."""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from app.calibration.fit.repetitions import Prompt
from app.calibration.script import MOVE, PAUSE, RETURN
from app.cues import Cue
from app.hardware.base import BodyView
from app.hardware.body.person import SimulatedPerson
from app.hardware.body.person_parameters import PRACTISED
from app.hardware.shirt.simulated_fabric import Fabric
from app.hardware.shirt.standard import standard_layout
from app.layout import ShirtLayout
from bench.prior.wearers import JointPart, Wearer, movement_of

SAMPLE_RATE = 100.0  # Hz
SHIRT = 4_000  # seed of the fabric, which everybody wears
FIRST_PERSON = 4_100  # seed of the first person: no demonstration, study or test uses these
JOINTS = ("right_elbow", "right_shoulder")
REST, FREE, REPETITIONS = 2.0, 12.0, 14
GAINS = (0.7, 1.4)  # of each channel, from person to person


def simulated_people(count: int, joints: Sequence[str] = JOINTS) -> list[Wearer]:
    """Return the recordings of `count` people: rest, free movement, then each joint prompted for 49 s."""
    layout = standard_layout()
    return [_wearer(layout, number, joints) for number in range(count)]


def _wearer(layout: ShirtLayout, number: int, joints: Sequence[str]) -> Wearer:
    seed = FIRST_PERSON + number
    fabric = Fabric(layout, SHIRT)
    for _ in range(number + 1):
        fabric.don_again()
    person = SimulatedPerson(replace(PRACTISED), seed)
    order = np.array([person.joints.index(name) for name in fabric.joints], dtype=np.intp)
    cues = _cues(joints)
    dt = 1.0 / SAMPLE_RATE
    count = round(cues[-1].end * SAMPLE_RATE)
    postures, values = np.empty((count, len(person.joints))), np.empty((count, len(layout.channels)))
    at = 0
    for i in range(count):
        while cues[at].end <= i * dt:
            at += 1
        postures[i] = person.step(dt, BodyView(cue=cues[at], cue_elapsed=i * dt - cues[at].start))
        values[i] = fabric.step(postures[i][order], dt)
    rng = np.random.default_rng(seed)
    values = 1.5 + (values - 1.5) * np.exp(rng.uniform(math.log(GAINS[0]), math.log(GAINS[1]), len(layout.channels)))
    parts = []
    for joint in joints:
        own = [cue for cue in cues if cue.joint == joint]
        rows = slice(round(own[0].start * SAMPLE_RATE), round(own[-1].end * SAMPLE_RATE))
        prompts = tuple(Prompt(cue.start, cue.end, joint) for cue in own if cue.kind == "move")
        place = postures[rows, person.joints.index(joint)]
        parts.append(JointPart(joint, rows, prompts, movement_of(place, SAMPLE_RATE)))
    return Wearer(
        code=f"s{number + 1}",
        group=f"s{number + 1}",
        layout=layout,
        sample_rate=SAMPLE_RATE,
        t=np.arange(count, dtype=np.float64) * dt,
        values=values,
        free=slice(round(REST * SAMPLE_RATE), round((REST + FREE) * SAMPLE_RATE)),
        parts=tuple(parts),
    )


def _cues(joints: Sequence[str]) -> list[Cue]:
    cues = [Cue(start=0.0, end=REST, kind="rest"), Cue(start=REST, end=REST + FREE, kind="free")]
    cues.append(Cue(start=cues[-1].end, end=cues[-1].end + REST, kind="rest"))
    for joint in joints:
        for repetition in range(1, REPETITIONS + 1):
            for kind, length in (("move", MOVE), ("return", RETURN), ("rest", PAUSE)):
                start = cues[-1].end
                cues.append(Cue(start=start, end=start + length, kind=kind, joint=joint, repetition=repetition))
    return cues

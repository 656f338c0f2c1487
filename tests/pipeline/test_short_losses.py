"""A channel that is bad for a moment never moves the chair (safety S5): each kind of map, at rest and in movement.

The activation with the break is held against the activation without it, on simulated people and on real knit.
"""

import itertools
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
import pytest

from app.calibration.prior.documents import OwnPrior
from app.calibration.prior.map_prior import MapPrior
from app.calibration.vocabulary import DriveParameters, standard_parameters
from app.faults import State
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import NO_CUE, SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.decoder import Decoder
from app.pipeline.replay.batch import decode_block
from app.pipeline.safety_gate import Conditions
from app.process.ring import TickRing
from bench.prior.__main__ import calibrated, entries_of
from bench.prior.knit import FOLDER, knit_people
from bench.prior.simulated import simulated_people
from bench.prior.wearers import JointPart, Wearer, figures_of

OWN_PROMPTS = 20.0  # s
MAPS = ("pca", "guided", "prior", "displacement")
BREAKS = (1, 10, 30, 200)  # frames: 10 ms to 2 s
BEFORE, AFTER = 1000, 1300  # frames around a break
MOST_UNWANTED = 0.2  # s
HELD = {"feature": "displacement", "dead_zone": 0.15, "full": 0.6}


class Subject(NamedTuple):
    """A person and one joint of theirs, by each kind of map."""

    wearer: Wearer
    part: JointPart
    parameters: dict[str, DriveParameters]
    known: dict[tuple[str, int], np.ndarray]

    @property
    def channels(self) -> list[int]:
        """The channels of the joint."""
        return self.wearer.layout.channels_of_joint[self.part.joint]

    def moments(self, seed: int) -> dict[str, int]:
        """Return a row of the recording in each phase of a movement."""
        rng = np.random.default_rng(seed)
        rows = self.part.rows
        last = rows.stop - rows.start - AFTER
        strokes = [one for one in self.part.movement.strokes if one[0] > 2500 and one[1] + 60 < last]
        start, stop = strokes[rng.integers(len(strokes))]
        still = np.flatnonzero(self.part.movement.still[2500:last]) + 2500
        moments = {"in the stroke": (start + stop) // 2, "on the way back": stop + 60}
        if len(still):
            moments["at rest"] = int(rng.choice(still))
        return {name: rows.start + row for name, row in moments.items()}

    def without_break(self, kind: str, at: int) -> np.ndarray:
        """Return the activation around a row as recorded; each length of a break is held against the same."""
        if (kind, at) not in self.known:
            self.known[kind, at] = activation(
                self.parameters[kind], self.wearer.values[max(0, at - BEFORE) : at + AFTER]
            )
        return self.known[kind, at]


def subjects_of(wearers: Sequence[Wearer], chosen: slice) -> list[Subject]:
    """Return the chosen people, each decoded by a prior of the people of other groups."""
    entries = entries_of(wearers)
    layout, groups = wearers[0].layout, {one.code: one.group for one in wearers}
    found = []
    for wearer in wearers[chosen]:
        people = {code: entry for code, entry in entries.items() if groups[code] != wearer.group}
        prior = MapPrior.of(OwnPrior(layout=layout, people=people))
        for part in wearer.parts:
            profile = calibrated(wearer, part, prior, OWN_PROMPTS)
            joint = next(one for one in profile.joints if one.name == part.joint)
            sets = {}
            for kind in MAPS:
                chosen_map = joint.model_copy(update={"map": "pca" if kind == "displacement" else kind})
                if chosen_map.map == "pca" or chosen_map.linear is not None:
                    alone = profile.model_copy(update={"joints": (chosen_map,), "cross_talk": None})
                    sets[kind] = standard_parameters(alone)
            gesture = sets["displacement"].gestures[0].model_copy(update=HELD)
            sets["displacement"] = sets["displacement"].model_copy(update={"gestures": (gesture,)})
            found.append(Subject(wearer, part, sets, {}))
    return found


def activation(parameters: DriveParameters, values: np.ndarray) -> np.ndarray:
    """Return the activation of the gesture; it is bound to no control, so that no speeds are computed."""
    rate = parameters.profile.sample_rate
    unbound = parameters.model_copy(update={"bindings": ()})
    return decode_block(unbound, rate, np.arange(len(values)) / rate, values.astype(np.float32)).activation[:, 0]


def unwanted(subject: Subject, kind: str, at: int, length: int, channel: int) -> float:
    """Return for how long (s) a break of a channel activates the gesture where it was not active without."""
    broken = subject.wearer.values[max(0, at - BEFORE) : at + AFTER].copy()
    start = min(at, BEFORE)
    broken[start : start + length, channel] = np.nan
    parameters = subject.parameters[kind]
    whole, with_break = subject.without_break(kind, at), activation(parameters, broken)
    return float(((with_break > 0.0) & (whole == 0.0)).sum()) / parameters.profile.sample_rate


@pytest.fixture(scope="module")
def simulated() -> list[Subject]:
    return subjects_of(simulated_people(6), slice(0, 2))


@pytest.fixture(scope="module")
def knit() -> list[Subject]:
    if not FOLDER.exists():
        pytest.skip("the recordings of the real knit are not on this machine")
    return subjects_of(knit_people()[::4], slice(None, None, 2))  # of fittings of their own


@pytest.fixture(params=["simulated", "knit"])
def subjects(request) -> list[Subject]:
    return request.getfixturevalue(request.param)


@pytest.mark.parametrize("kind", MAPS)
@pytest.mark.parametrize("length", BREAKS)
def test_a_short_break_activates_nothing_that_the_movement_did_not(subjects, kind, length):
    worst, cases = 0.0, 0
    for seed, subject in enumerate(subjects):
        if kind not in subject.parameters:
            continue
        for name, at in subject.moments(seed).items():
            channel = int(np.random.default_rng([seed, length]).choice(subject.channels))
            cases += 1
            worst = max(worst, unwanted(subject, kind, at, length, channel))
            assert worst <= MOST_UNWANTED, (subject.wearer.code, name, channel)
    assert cases >= 6


@pytest.mark.parametrize("kind", MAPS)
def test_an_estimate_never_begins_or_ends_with_a_step(subjects, kind):
    """A channel that returns with a level of its own, at rest, is no movement either."""
    for seed, subject in enumerate(subjects):
        moments = subject.moments(seed)
        if kind not in subject.parameters or "at rest" not in moments:
            continue
        at = moments["at rest"]
        values = subject.wearer.values[at - BEFORE : at + AFTER].copy()
        whole = subject.without_break(kind, at)
        profile = subject.parameters[kind].profile
        channel = subject.channels[seed % len(subject.channels)]
        values[BEFORE : BEFORE + 50, channel] = np.nan
        values[BEFORE + 50 :, channel] += 0.3 * (profile.high[channel] - profile.low[channel])
        broken = activation(subject.parameters[kind], values)
        assert ((broken > 0.0) & (whole == 0.0)).sum() <= MOST_UNWANTED * profile.sample_rate


@pytest.mark.parametrize("kind", ["pca", "guided", "prior"])
def test_frame_by_frame_and_at_once_break_alike(simulated, kind):
    parameters = simulated[0].parameters[kind]
    at = simulated[0].moments(1)["in the stroke"]
    values = simulated[0].wearer.values[at - BEFORE : at + AFTER].astype(np.float32)
    first, second, third = simulated[0].channels[:3]
    values[BEFORE : BEFORE + 30, first] = np.nan
    values[BEFORE + 20 : BEFORE + 60, second] = np.nan  # overlaps with the first
    values[BEFORE + 60 :, third] = np.nan  # never comes back
    values[BEFORE + 300 : BEFORE + 310, first] = np.nan
    block = decode_block(parameters, 100.0, np.arange(len(values)) / 100.0, values)
    decoder = Decoder(parameters, 100.0)
    rows = []
    for frame in values:
        decoder.step(frame, 1.0)
        rows.append((decoder.score[0], decoder.rate[0], decoder.activation[0]))
    streamed = np.array(rows).T
    for name, own in zip(("score", "rate", "activation"), streamed, strict=True):
        np.testing.assert_allclose(getattr(block, name)[:, 0], own, atol=1e-6, err_msg=name)


@pytest.mark.parametrize(("dead", "least"), [(1, 0.95), (2, 0.85)])
@pytest.mark.parametrize("kind", ["pca", "prior"])
def test_with_dead_sensors_the_others_go_on(knit, kind, dead, least):
    """Share of the hits that are left, the median over people and sets of dead sensors of one to two of five."""
    whole, left = [], []
    for subject in knit[:6]:
        wearer, parameters = subject.wearer, subject.parameters[kind]
        whole.append(figures_of(wearer, subject.part, activation(parameters, wearer.values)).hit)
        for channels in itertools.combinations(subject.channels, dead):
            values = wearer.values.copy()
            values[:, list(channels)] = np.nan
            left.append(figures_of(wearer, subject.part, activation(parameters, values)).hit)
    assert np.median(left) >= least * np.median(whole)


def test_a_sensor_that_its_joint_does_not_tell_is_not_estimated(simulated):
    """Of a joint with one good sensor left, nothing is known well enough."""
    parameters = simulated[0].parameters["pca"]
    values = simulated[0].wearer.values[:1000].copy()
    values[500:, simulated[0].channels[1:]] = np.nan
    decoder = Decoder(parameters, 100.0)
    for frame in values.astype(np.float32):
        decoder.step(frame, 1.0)
    assert decoder.bad == [True]
    assert decoder.estimated == 0


def test_estimated_channels_are_named(simulated):
    parameters = simulated[0].parameters["pca"]
    values = simulated[0].wearer.values[:400].astype(np.float32)
    weakest = simulated[0].channels[int(np.abs(parameters.profile.joints[0].direction).argmin())]
    values[200:300, weakest] = np.nan
    decoder = Decoder(parameters, 100.0)
    seen = []
    for frame in values:
        decoder.step(frame, 1.0)
        seen.append(decoder.estimated)
    assert set(seen[:200] + seen[300:]) == {0}
    assert set(seen[200:300]) == {1 << weakest}


def test_the_tick_says_which_channels_are_estimated_and_the_chair_goes_on(simulated):
    parameters = simulated[0].parameters["pca"]
    values = simulated[0].wearer.values[:300].astype(np.float32)
    weakest = simulated[0].channels[int(np.abs(parameters.profile.joints[0].direction).argmin())]
    values[:, weakest] = np.nan  # dead from the start
    chain = Chain(100.0, parameters.model_copy(update={"mode_u1": "velocity"}), VirtualChair(None, Pose(0.0, 0.0, 0.0)))
    ring = TickRing.create("test_estimated")
    try:
        assert chain.arm()
        for i, frame in enumerate(values):
            tick = chain.step(SensorFrame(i, i / 100.0, i / 100.0, frame), i / 100.0, Conditions())
        ring.write(tick, 0, 0.0, NO_CUE, 0, 0)
        assert int(ring.newest()["estimated"]) == 1 << weakest
        assert tick.state is State.ARMED
    finally:
        ring.unlink()

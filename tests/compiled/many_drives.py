"""Prints the hashes of many random drives, decodes and studies: equal, bit for bit, however they are computed.

Each drive has a parameter set, signals and a chair of its own. Frames are lost, sensors break, screens and chairs fall
silent, limits and dial change, and somebody stops, clears and arms again.
"""

import hashlib
import json
import struct
import sys
from dataclasses import fields

import numpy as np

from app.calibration.vocabulary import DriveParameters
from app.faults import State
from app.geometry import Pose
from app.hardware.chair.simulator import VirtualChair
from app.messages import SensorFrame
from app.pipeline.chain import Chain
from app.pipeline.compiled import IS_COMPILED
from app.pipeline.replay.batch import decode_block
from app.pipeline.safety_gate import ChairCondition, Conditions
from app.speed_limits import Speeds
from app.study.experiment import run_study
from app.world.scene import find_place
from building import make_parameters, make_signals

DRIVES, STUDIES = 60, 3
MOST_FRAMES, LONGEST = 9000, 25.0  # of a drive; s
PLACES = ("clinic", "follow_me.easy", None)
RATES = (20.0, 50.0, 100.0, 400.0, 1000.0)  # Hz
BROKEN = (np.nan, np.inf, 0.5, 50.0, -200.0)
CHECK = {"in_phase": 0.5, "hit_rate": 0.5, "false_per_minute": 1.0, "false_count": 1}


def random_parameters(random, seed, rate):
    channels, dead_zone = int(random.choice([8, 20, 52])), float(random.uniform(0.05, 0.4))
    made = make_parameters(sample_rate=rate, seed=seed, n_channels=channels, dead_zone=dead_zone)
    document = made.model_dump(mode="json")
    for axis in ("mode_u1", "mode_u2"):
        document[axis] = str(random.choice(["velocity", "acceleration"]))
    document["cutoff"] = float(random.choice([1.0, 3.0, 6.0]))
    document["turn_cruise_time"] = 3.0
    for binding in document["bindings"]:
        binding["gain"] = float(random.uniform(0.4, 2.0))
    profile = document["profile"]
    if random.random() < 0.5:
        profile["low"], profile["high"] = [-6.0] * channels, [6.0] * channels
    guided = set()
    for joint in profile["joints"]:
        if random.random() < 0.35:
            joint["map"], joint["guided"] = "guided", guided_map(random, np.array(joint["pca"]["rates"][0]))
            guided.add(joint["name"])
        elif random.random() < 0.35:
            joint["map"], joint["prior"] = "prior", prior_map(random, np.array(joint["pca"]["rates"][0]))
            guided.add(joint["name"])
    for gesture in document["gestures"]:
        if random.random() < 0.2 and gesture["joint"] not in guided:
            gesture |= {"feature": "displacement", "dead_zone": 0.1, "full": 0.5}
    return DriveParameters.model_validate(document)


def guided_map(random, weights):
    noise = 0.01 * random.normal(size=len(weights))
    return {
        "rates": [weights.tolist()],
        "short": (0.3 * weights + noise).tolist(),
        "long": (0.2 * weights).tolist(),
        "dead_zone": 0.2,
        "full": 1.0,
        "lag": 0.0,
        "repetitions": 3,
        "pca_check": CHECK,
        "check": CHECK,
    }


def prior_map(random, weights):
    earlier = [(weights * random.uniform(-0.5, 1.0)).tolist() for _ in range(4)]
    levels = {"short": (0.3 * weights).tolist(), "long": weights.tolist()}
    return {"rates": [weights.tolist(), *earlier], **levels, "dead_zone": 0.2, "full": 1.0, "people": 8}


def random_signals(random, parameters, seed, rate):
    values = make_signals(parameters, int(min(MOST_FRAMES, rate * LONGEST)), seed)
    if seed % 2:  # a converter with few steps
        values = (np.round(values * 1024) / 1024).astype(np.float32)
    count, channels = values.shape
    for _ in range(random.integers(0, 3)):
        begin = int(random.integers(0, count))
        values[begin : begin + int(random.integers(1, rate)), int(random.integers(channels))] = random.choice(BROKEN)
    if seed % 5 == 0:
        begin = int(random.integers(count // 2, count))
        values[begin : begin + int(rate)] = values[begin]
    return values


def random_chair(seed):
    place = PLACES[seed % len(PLACES)]
    plan = find_place(place) if place else None
    start = plan.paths[0].start if plan else Pose(0.0, 0.0, 0.0)
    return VirtualChair(plan, start, "wheelchair" if seed % 4 == 3 else "unicycle")


def upset(chance, random, chain, conditions):
    """Change limits, or let a screen, a chair or the web process fail, each with a small chance."""
    conditions.screen_age, conditions.supervisor_age, conditions.chair = 0.0, 0.0, ChairCondition.READY
    if chance < 0.003:
        chain.set_dial(float(random.uniform(0.2, 1)))
    elif chance < 0.005:
        chain.set_clinic(Speeds(forward=float(random.uniform(0.3, 1.5))))
    elif chance < 0.006:
        conditions.screen_age = 1.0
    elif chance < 0.007:
        conditions.chair = ChairCondition.INHIBITED
    elif chance < 0.0075:
        conditions.supervisor_age = float("nan")


def drive(seed):
    """Return the hashes of the ticks and of the decode, and the share of the time in which motion was permitted."""
    random = np.random.default_rng(seed)
    rate = float(random.choice(RATES))
    parameters = random_parameters(random, seed, rate)
    values = random_signals(random, parameters, seed, rate)
    chain, conditions, ticks = Chain(rate, parameters, random_chair(seed)), Conditions(), hashlib.sha256()
    chain.arm()
    t, t_device, seen = 10.0, 3.0, []
    for i, frame in enumerate(values):
        chance = random.random() * rate / 10
        step = float(random.uniform(0, 0.12)) if chance < 0.05 else (1 + 0.1 * random.normal()) / rate
        t += max(1e-5, step)
        t_device += (1 + int(random.integers(0, 4)) * (chance < 0.02)) / rate
        upset(chance, random, chain, conditions)
        came = SensorFrame(i, t_device, t, frame) if not 0.02 < chance < 0.05 else None
        tick = chain.step(came, t, conditions)
        ticks.update(numbers(tick))
        if came is not None:
            seen.append((i, t, t_device, int(tick.state)))
        if chain.gate.state is State.FAULT and random.random() < 5 / rate:
            chain.gate.clear(chain.gate.stops)
        if chain.gate.state is State.DISARMED and random.random() < 20 / rate:
            chain.arm()
    indices, arrivals, device, states = map(np.array, zip(*seen, strict=True))
    state = states.astype(np.uint8) if seed % 2 else None
    decoded = decode_block(parameters, rate, arrivals, values[indices], t_device=device, state=state)
    whole = hashlib.sha256(b"".join(np.ascontiguousarray(getattr(decoded, one.name)) for one in fields(decoded)))
    return ticks.hexdigest(), whole.hexdigest(), float(np.mean(states == State.ARMED))


def numbers(tick):
    row = [tick.t, tick.u1, tick.u2, tick.v, tick.omega, tick.x, tick.y, tick.theta, tick.in_contact, tick.contacts]
    row += [tick.scene_t, tick.state, tick.fault, tick.stops, *tick.score, *tick.rate, *tick.drive, *tick.activation]
    return struct.pack(f"{len(row)}d", *row)


def study(seed):
    """Return the hash of a short study: a simulated person in the simulated shirt calibrates and drives two trials."""
    plan = find_place("clinic")
    result = run_study(2, seed, plan, plan.paths[0].name)
    columns = [getattr(trial, name) for trial in result.trials for name in ("t", "x", "y", "theta", "v", "omega")]
    measures = json.dumps([trial.measures for trial in result.trials])
    return hashlib.sha256(b"".join(column.tobytes() for column in columns) + measures.encode()).hexdigest()


if __name__ == "__main__":
    found = {
        "compiled": IS_COMPILED,
        "drives": [drive(seed) for seed in range(DRIVES)],
        "studies": [study(seed) for seed in range(1, 1 + STUDIES)],
    }
    json.dump(found, sys.stdout)

"""The chain over a whole recording at once: the numbers of the loop, hundreds of times faster than frame by frame.

Steps without memory are computed on arrays; ramps and the chair, where each step needs the one before, use the objects
of the loop. The gate's decisions are not made again but read from the recording; a file without decisions counts as
armed throughout.
"""

# Compiled in a wheel (hatch_build.py).

from bisect import bisect_right
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.calibration.map_rates import map_rates
from app.calibration.vocabulary import DriveParameters
from app.faults import State
from app.geometry import Twist
from app.hardware.base import Chair
from app.pipeline.channel_health import ChannelHealth
from app.pipeline.channel_substitution import ChannelSubstitution, Surprise
from app.pipeline.controls import Controls
from app.pipeline.decoder import LONGEST_GAP, Decoder
from app.pipeline.frame_loss import LossWindow
from app.pipeline.projection import Projections, projections
from app.pipeline.ramp import Ramp
from app.pipeline.return_doubt import ReturnDoubt
from app.pipeline.safety_gate import LARGEST_STEP
from app.pipeline.shaping import Cruise, Shaper, forward_ramp, turn_ramp
from app.pipeline.stop_ramp import STOP_DECELERATION, STOP_TURN_DECELERATION, stop_rate, towards_zero

Array = NDArray[np.float64]
CHUNK = 5_000  # frames at once, so that the temporary arrays stay in the processor's cache


@dataclass(slots=True)
class DecodedRun:
    """A decoded recording; per gesture (n, n_gestures), otherwise (n,). Units as in `app.messages.Tick`.

    `silent`: where a gesture does nothing, because of bad channels that others cannot stand in for, or lost frames.
    """

    score: Array
    rate: Array
    drive: Array
    activation: Array
    silent: NDArray[np.bool_]
    u1: Array
    u2: Array
    v: Array
    omega: Array
    x: Array
    y: Array
    theta: Array


def decode_block(
    parameters: DriveParameters,
    sample_rate: float,
    t: Array,
    values: NDArray[np.float32],
    *,
    t_device: Array | None = None,
    state: NDArray[np.uint8] | None = None,
    chair: Chair | None = None,
) -> DecodedRun:
    """Decode all frames of a recording.

    Parameters
    ----------
    parameters
        The parameters to decode with.
    sample_rate
        Of the shirt, Hz.
    t
        (n,) when each frame came, s; the chair moves by this clock.
    values
        (n, n_channels) signal units.
    t_device
        (n,) the shirt's own clock, s; `t` when not given.
    state
        (n,) recorded `State` of the gate; armed throughout when not given.
    chair
        The chair to drive; without one, a unicycle that starts at the origin of a floor without walls.
    """
    device = t if t_device is None else t_device
    read = projections(parameters)
    score, projected, silent, margins, surprises = _projected(parameters, read, sample_rate, values)
    periods = _periods(device, sample_rate)
    silent |= _too_lossy(t, periods)[:, np.newaxis]
    if any(gesture.feature == "displacement" for gesture in parameters.gestures):
        rate, drive, activation = _step_by_step(parameters, sample_rate, periods, values, silent)
    else:
        dead_zone = np.array([gesture.dead_zone for gesture in parameters.gestures])
        reach = np.array([gesture.full for gesture in parameters.gestures]) - dead_zone
        rate = map_rates(projected, read.is_read, periods, parameters.cutoff, sample_rate)
        doubt = ReturnDoubt(parameters, sample_rate)
        doubts = _doubts(doubt, periods, surprises)
        silent |= doubts < np.array(doubt.largest)
        drive = np.maximum(rate + doubts - margins - dead_zone, 0.0)
        drive[silent] = 0.0
        activation = np.minimum(drive / reach, 1.0)
    u1, u2 = _controls(parameters, activation)
    dt = np.clip(np.diff(t, prepend=t[:1]), 0.0, LARGEST_STEP)
    permitted = np.ones(len(dt), dtype=np.bool_) if state is None else state == State.ARMED
    v, omega = _twists(parameters, u1, u2, dt, permitted)
    x, y, theta = _drive(chair, v, omega, dt, permitted) if chair else _unicycle(v, omega, dt)
    return DecodedRun(score, rate, drive, activation, silent, u1, u2, v, omega, x, y, theta)


def _projected(
    parameters: DriveParameters, read: Projections, sample_rate: float, values: NDArray[np.float32]
) -> tuple[Array, Array, NDArray[np.bool_], Array, list[Surprise]]:
    """Return scores and projections of the maps, which gestures are lost, their margins, and what returned.

    Scores (n, n_gestures); projections (n, n_parts), of every part that some gesture reads; lost gestures and margins
    (n, n_gestures) as `ChannelSubstitution` has them.
    """
    count = len(read.score)
    weights = np.concatenate((read.score, read.parts[read.is_read]))
    lost = np.zeros((len(values), count), dtype=np.bool_)
    margins = np.zeros((len(values), count))
    health = ChannelHealth(parameters.profile, np.asarray(read.uses.any(axis=0)), sample_rate)
    substitution = ChannelSubstitution(parameters)
    surprises: list[Surprise] = []
    projected = np.empty((len(values), len(weights)))
    for start in range(0, len(values), CHUNK):
        part = slice(start, start + CHUNK)
        wrong = health.bad_in_block(values[part], values[max(0, start - health.memory) : start] if start else None)
        frames = values[part].astype(np.float64)
        if wrong is not None or substitution.is_active:
            lost[part] = substitution.lost
            margins[part] = substitution.margins
            frames, changes, returned = substitution.fill(frames, wrong, values[start - 1] if start else None)
            for change in changes:
                lost[start + change.row : start + CHUNK] = change.lost
                margins[start + change.row : start + CHUNK] = change.margins
            surprises.extend(Surprise(start + row, step) for row, step in returned)
        elif not np.isfinite(frames.sum()):  # a channel that no gesture reads is NaN or infinite
            frames[~np.isfinite(frames)] = 0.0
        projected[part] = frames @ weights.T
    return projected[:, :count] - read.offset, projected[:, count:], lost, margins, surprises


def _doubts(doubt: ReturnDoubt, periods: Array, surprises: list[Surprise]) -> Array:
    """Return the doubt of each gesture (n, n_gestures) about channels that returned; none reads a displacement."""
    amounts = np.zeros((len(periods), len(doubt.largest)))
    ends = [surprise.row for surprise in surprises[1:]] + [len(periods)]
    for (row, step), end in zip(surprises, ends, strict=bool(surprises)):
        doubt.add(step)
        amounts[row:end] = doubt.over(periods[row + 1 : end])
        doubt.fade(float(periods[row + 1 : end + 1].sum()), was_quiet=False)
    return amounts


def _periods(device: Array, sample_rate: float) -> Array:
    """Return the time step of each frame in whole periods, as `decoder.periods_between` counts them."""
    step = np.diff(device, prepend=device[:1] - 1.0 / sample_rate)
    step[~((step > 0) & (step < np.inf))] = 1.0 / sample_rate
    return np.clip(np.round(step * sample_rate), 1.0, max(1.0, LONGEST_GAP * sample_rate))


def _too_lossy(t: Array, periods: Array) -> NDArray[np.bool_]:
    """Return where so many frames are missing that the gestures count as neutral."""
    lossy = np.zeros(len(t), dtype=np.bool_)
    if periods.max(initial=1.0) > 1.0:
        window = LossWindow()
        for i, (arrival, period) in enumerate(zip(t.tolist(), periods.tolist(), strict=True)):
            window.step(arrival, int(period) - 1)
            lossy[i] = window.too_lossy
    return lossy


def _step_by_step(
    parameters: DriveParameters,
    sample_rate: float,
    periods: Array,
    values: NDArray[np.float32],
    silent: NDArray[np.bool_],
) -> tuple[Array, Array, Array]:
    """Return rate, drive and activation from the loop's decoder: the baseline of a displacement has a memory."""
    decoder = Decoder(parameters, sample_rate)
    rows = np.empty((3, len(values), len(parameters.gestures)))
    for i, (frame, since) in enumerate(zip(values, periods.tolist(), strict=True)):
        decoder.step(frame, since)
        if silent[i].all():
            decoder.quieten()
        rows[:, i] = decoder.rate, decoder.drive, decoder.activation
    return rows[0], rows[1], rows[2]


def _controls(parameters: DriveParameters, activation: Array) -> tuple[Array, Array]:
    u1, u2 = (
        sum((gain * activation[:, i] for i, gain in terms), start=np.zeros(len(activation)))
        for terms in Controls(parameters).terms
    )
    return np.clip(u1, -1.0, 1.0), np.clip(u2, -1.0, 1.0)


def _twists(
    parameters: DriveParameters, u1: Array, u2: Array, dt: Array, permitted: NDArray[np.bool_]
) -> tuple[Array, Array]:
    shaper = Shaper(parameters)
    forward, turn = forward_ramp(parameters.speeds), turn_ramp(parameters.speeds)
    time = _Time(dt, dt.tolist(), permitted.tolist(), np.diff(permitted, prepend=permitted[:1]))
    return (
        _ramped(_Axis(shaper.speed, forward, STOP_DECELERATION, shaper.cruise), u1, time),
        _ramped(_Axis(shaper.turn_rate, turn, STOP_TURN_DECELERATION, shaper.turn_cruise), u2, time),
    )


class _Axis(NamedTuple):
    """How one axis of the twist follows from its control."""

    shape: Callable[[float, float, float, float], float]
    ramp: Ramp
    stop_deceleration: float
    cruise: Cruise | None  # the time-out in acceleration mode


class _Time(NamedTuple):
    """The steps of both axes."""

    dt: Array  # s
    steps: list[float]  # the same
    permitted: list[bool]
    changes: NDArray[np.bool_]  # where `permitted` changes


def _ramped(axis: _Axis, control: Array, time: _Time) -> Array:
    """Return one axis of the twists: each speed follows from the one before.

    While neither the speed nor the control changes, the steps up to the next change of the control are skipped.
    """
    ramp, shape, cruise = axis.ramp, axis.shape, axis.cruise
    steps, permitted, controls = time.steps, time.permitted, control.tolist()
    changes = np.flatnonzero((np.diff(control, prepend=np.nan) != 0.0) | time.changes).tolist()
    changes.append(len(controls))
    speeds: list[float] = []
    ends: list[int] = []  # up to where each of the speeds stays
    last = rate = stop = 0.0
    was_permitted = True
    i = 0
    while i < len(controls):
        step = steps[i]
        if permitted[i]:
            speed = ramp.bounded(last, rate, shape(controls[i], last, rate, step), step)
            rate = (speed - last) / step if step > 0.0 else rate
        else:
            if was_permitted:
                stop, rate = stop_rate(last, axis.stop_deceleration), 0.0
                if cruise:
                    cruise.reset()
            speed = towards_zero(last, stop * step)
        was_permitted = permitted[i]
        i += 1
        if speed == last and step > 0.0:
            start, i = i, changes[bisect_right(changes, i - 1)]
            if cruise and was_permitted:
                passed = cruise.coast(controls[start - 1], time.dt[start:i])
                i = start + passed if speed else i
        speeds.append(speed)
        ends.append(i)
        last = speed
    return np.repeat(speeds, np.diff(ends, prepend=0))


def _drive(chair: Chair, v: Array, omega: Array, dt: Array, permitted: NDArray[np.bool_]) -> tuple[Array, Array, Array]:
    poses = []
    for forward, turn, step, may in zip(v.tolist(), omega.tolist(), dt.tolist(), permitted.tolist(), strict=True):
        state = chair.drive(Twist(forward, turn), step, may)
        poses.append((state.x, state.y, state.theta))
    x, y, theta = np.array(poses).reshape(-1, 3).T
    return x, y, theta


def _unicycle(v: Array, omega: Array, dt: Array) -> tuple[Array, Array, Array]:
    turned = omega * dt
    theta = np.cumsum(turned)
    heading = theta - turned
    return np.cumsum(v * np.cos(heading) * dt), np.cumsum(v * np.sin(heading) * dt), theta

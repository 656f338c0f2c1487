"""Fits a calibration profile from rest, free movement and prompted repetitions (docs/signal-chain.md)."""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

import app
from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.joint_evidence import cross_talk, signal_to_noise, with_lag
from app.calibration.fit.joint_fit import FittedJoint, fit_joint
from app.calibration.fit.repetitions import Repetition
from app.calibration.gaps import Frames
from app.calibration.linear_map import LinearMap
from app.calibration.map_grades import JointMeasurements, grade
from app.calibration.profile import CalibrationProfile, JointMap
from app.clock import utc_now
from app.texts import Text

NOISE_BLOCK = 0.5  # s
QUIET_SHARE = 0.25  # of the blocks that are taken as free of movement: also free movement has its pauses
SECOND_DIFFERENCE = 6.0  # variance of the second difference of white noise, in variances of the noise
DIGITS = 6  # significant digits: more of them only make the document longer


def fit_profile(recording: CleanRecording) -> CalibrationProfile:
    """Return the calibration profile of one person in one shirt, with the standard map of each joint.

    Raises
    ------
    ValueError
        One sentence: no joint has a usable channel.
    """
    layout, sample_rate, left_out = recording.layout, recording.sample_rate, recording.left_out
    moved, resting, repetitions = recording.free, recording.rest, recording.repetitions
    channels = {
        joint: tuple(i for i in indices if layout.channels[i].name not in left_out)
        for joint, indices in layout.channels_of_joint.items()
    }
    fitted = {
        joint: fit_joint(used, moved, resting, recording.repetitions_of(joint), sample_rate)
        for joint, used in channels.items()
        if used and moved[:, list(used)].var(axis=0).any()  # 0 also where squares underflow
    }
    if not fitted:
        raise ValueError(Text("calibration-no-joint", layout=layout.name))
    matrix = _cross_talk(fitted, repetitions, sample_rate)
    pieces = [moved, *(repetition.values for repetition in repetitions)]
    joints = tuple(
        _joint_map(
            name,
            fitted,
            matrix,
            movement_covariance(channels[name], pieces),
            len(layout.channels_of_joint[name]),
            layout.joint_titles,
            had_rest=resting is not None,
        )
        for name in fitted
    )
    return CalibrationProfile(
        created=utc_now().isoformat(timespec="seconds"),
        software=app.__version__,
        layout=layout,
        sample_rate=sample_rate,
        left_out=dict(left_out),
        low=recording.low,
        high=recording.high,
        noise=channel_noise(moved if resting is None else resting, sample_rate),
        joints=joints,
        cross_talk=None if matrix is None else tuple(tuple(map(float, row)) for row in matrix),
    )


def joints_without_map(profile: CalibrationProfile) -> dict[str, Text]:
    """Return the layout's joints that the profile has no map for, each with the reason and what to do."""
    mapped = {joint.name for joint in profile.joints}
    return {name: Text("calibration-no-sensor") for name in profile.layout.joint_names if name not in mapped}


def _cross_talk(
    fitted: Mapping[str, FittedJoint], repetitions: Sequence[Repetition], sample_rate: float
) -> NDArray[np.float64] | None:
    """Return the cross-talk matrix (k, k): 0 where one of the two joints was not prompted; None when no joint was."""
    prompted = [i for i, joint in enumerate(fitted.values()) if joint.agreement is not None]
    if not prompted:
        return None
    names = list(fitted)
    activation = np.zeros((len(names), len(names)))
    for row in prompted:
        joint_repetitions = [repetition for repetition in repetitions if repetition.joint == names[row]]
        for column in prompted:
            joint = fitted[names[column]]
            rates = [
                joint.rate(repetition.values, sample_rate)[with_lag(repetition, sample_rate)]
                for repetition in joint_repetitions
            ]
            above = (np.concatenate(rates) - joint.dead_zone) / (joint.full - joint.dead_zone)
            activation[row, column] = np.clip(above, 0.0, 1.0).mean()
    return cross_talk(activation)


def _joint_map(
    name: str,
    fitted: Mapping[str, FittedJoint],
    matrix: NDArray[np.float64] | None,
    covariance: tuple[tuple[float, ...], ...],
    channels: int,
    titles: Mapping[str, Text | str],
    *,
    had_rest: bool,
) -> JointMap:
    joint = fitted[name]
    strongest = None
    if matrix is not None and len(fitted) > 1 and joint.agreement is not None:
        row = matrix[list(fitted).index(name)].copy()
        row[list(fitted).index(name)] = -1.0
        strongest = (titles[list(fitted)[int(row.argmax())]], float(row.max()))
    used = len(joint.direction.channels)
    ratio = signal_to_noise(joint.full if joint.reaches_full else 0.0, joint.rest_rate)
    letter, reason = grade(
        JointMeasurements(
            evr=joint.evr,
            signal_to_noise=ratio,
            reaches_full=joint.reaches_full,
            repeatability=joint.repeatability,
            agreement=joint.agreement,
            angle_deg=joint.angle_deg,
            strongest_cross_talk=strongest,
            channels=used,
            channels_out=channels - used,
            prompted_share=joint.prompted_share,
            span_from_prompts=joint.span_from_prompts,
            had_rest=had_rest,
        )
    )
    return JointMap(
        name=name,
        channels=joint.direction.channels,
        mean=tuple(map(float, joint.direction.mean)),
        evr=min(1.0, joint.evr),
        prompted=joint.agreement is not None,
        angle_deg=joint.angle_deg,
        signal_to_noise=ratio,
        repeatability=joint.repeatability,
        rest_rate=joint.rest_rate,
        pca=LinearMap(
            rates=(tuple(map(float, joint.direction.weights * (joint.sign / joint.span))),),
            dead_zone=joint.dead_zone,
            full=joint.full,
        ),
        step=joint.steps.sudden,
        filtered_step=joint.steps.filtered,
        covariance=covariance,
        grade=letter,
        reason=reason,
    )


def movement_covariance(channels: Sequence[int], pieces: Sequence[Frames]) -> tuple[tuple[float, ...], ...]:
    """Return the covariance (k, k) of channels over pieces (n, n_channels), each about its own mean.

    From it follows what a channel that breaks later would show (`app/pipeline/channel_substitution.py`). Signals drift
    from piece to piece, and that is no movement.
    """
    used = [piece[:, list(channels)] for piece in pieces if len(piece)]
    centred = [piece - piece.mean(axis=0) for piece in used]
    covariance = sum(rows.T @ rows for rows in centred) / sum(map(len, centred))
    return tuple(tuple(_rounded(value) for value in row) for row in np.maximum(covariance, covariance.T).tolist())


def channel_noise(values: Frames, sample_rate: float) -> tuple[float, ...]:
    """Return the standard deviation of the noise of each channel in frames (n, n_channels), from its quietest quarter.

    A channel that is later much quieter than its noise is stuck (`app/pipeline/channel_health.py`). Second differences
    leave drift and slow movement out. In oversampled signals they understate the noise, so that fewer channels count as
    stuck.
    """
    length = min(len(values), max(5, round(NOISE_BLOCK * sample_rate)))
    blocks = values[: len(values) // length * length].reshape(-1, length, values.shape[1])
    # Block by block, so that the differences stay in the processor's cache.
    variance = [(np.diff(block, n=2, axis=0) ** 2).mean(axis=0) / SECOND_DIFFERENCE for block in blocks]
    return tuple(_rounded(value) for value in np.quantile(np.sqrt(variance), QUIET_SHARE, axis=0).tolist())


def _rounded(value: float) -> float:
    return float(f"{value:.{DIGITS}g}")

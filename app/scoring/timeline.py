"""The time line of a recorded trial for the screen: chair, controls, gestures, signals and events on one time base.

The columns are decimated to at most 2000 points.
"""

from collections.abc import Sequence
from pathlib import Path as FilePath
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic import ValidationError

from app.calibration.vocabulary import DriveParameters
from app.faults import EXPLANATIONS, PEOPLE_STOPS, Fault, State
from app.layout import ShirtLayout
from app.quantities import Document
from app.recording.format import Columns
from app.recording.reader import RunRecording, read_run
from app.scoring.decimation import Decimation
from app.texts import Text
from app.world.floorplan import FloorPlan
from app.world.movers import Track
from app.world.path import Path
from app.world.place_texts import plan_for_reader

MOST_POINTS = 2000
CHANNELS_SHOWN = 4  # of a joint: those that weigh most in its map
WINDOW = 1.5  # m along the path, around the last place, that is searched for the chair's place
LOST = 1.0  # m beside the path; when further, the whole path is searched
DIGITS = 4  # after the decimal point: a tenth of a millimetre


Numbers = NDArray[np.float64]
Column = list[float | None]  # None: unknown at that time
EventKind = Literal["checking", "armed", "stop", "fault", "disarmed", "contact", "goal"]


class GestureLine(Document):
    """One gesture over time, with its definition and the controls that it is bound to."""

    name: str
    joint: str
    direction: int
    feature: str
    controls: list[str]  # to which the gesture is bound
    dead_zone: float  # FS/s, FS for a held posture
    full: float
    score: Column  # FS
    rate: Column  # FS/s, FS for a held posture
    activation: Column  # 0..1


class ChannelLine(Document):
    """The signal of one channel over time."""

    name: str
    values: Column  # signal units


class JointLines(Document):
    """The signals of a joint's channels with the largest weights."""

    name: str
    label: str
    channels: list[ChannelLine]
    of: int  # number of all channels of the joint


class MoverLine(Document):
    """The poses of one mover over time."""

    x: Column  # m
    y: Column  # m
    theta: Column  # rad


class Event(Document):
    """An event of a trial."""

    t: float  # s since motion was first permitted
    kind: EventKind
    message: Text


class Timeline(Document):
    """A recorded trial, all columns of one length; times in s since motion was first permitted."""

    t: Column
    x: Column  # m
    y: Column  # m
    theta: Column  # rad
    v: Column  # m/s, as commanded
    omega: Column  # rad/s
    u1: Column
    u2: Column
    along: Column  # m along the prescribed path; empty for a path without length
    across: Column  # m beside the path, left positive
    scene_t: Column  # s, time of the scene's movers
    movers: list[MoverLine]
    state: list[int]  # app.faults.State
    contact: list[bool]
    gestures: list[GestureLine]
    joints: list[JointLines]
    events: list[Event]
    floorplan: FloorPlan | None  # at the time of the trial; None when the recording holds none
    message: str  # damage of the recording; empty when it is whole


def timeline_of(folder: FilePath, path_points: Sequence[Sequence[float]], end: str | None) -> Timeline:
    """Return the time line of a trial from its recording.

    Parameters
    ----------
    folder
        Of the recording.
    path_points
        The prescribed path of the trial, (x, y) in m each.
    end
        How the trial ended.

    Raises
    ------
    ValueError
        One sentence, when there is no recording, or the recording holds nothing.
    """
    run = read_run(folder)
    if run.rows == 0:
        raise ValueError(
            Text("trial-recording-damaged", damage=run.damage) if run.damage else Text("trial-recording-empty")
        )
    rows = run.columns
    t = since_armed(rows)
    decimation = Decimation(run.rows, MOST_POINTS)
    x, y = decimation.sampled(rows["x"]), decimation.sampled(rows["y"])
    along, across = _path_coordinates(path_points, x, y)
    scene_t, plan = decimation.sampled(rows["scene_t"]), plan_of(run)
    return Timeline(
        t=column(decimation.sampled(t)),
        x=column(x),
        y=column(y),
        along=along,
        across=across,
        **{name: column(decimation.sampled(rows[name])) for name in ("theta", "v", "omega")},
        **{name: column(decimation.peaks(rows[name])) for name in ("u1", "u2")},
        scene_t=column(scene_t),
        movers=_movers(plan, scene_t),
        state=decimation.sampled(rows["state"]).tolist(),
        contact=decimation.any(rows["in_contact"]).tolist(),
        gestures=_gestures(run, decimation),
        joints=_joints(run, decimation),
        events=events_of(rows, t, end),
        floorplan=None if plan is None else plan_for_reader(plan),
        message=str(run.loss or ""),
    )


class Poses(NamedTuple):
    """The chair's poses over time, with the speed, the scene's time and the head for a 3D view; (n,) each."""

    t: Numbers  # s since motion was first permitted
    x: Numbers  # m
    y: Numbers  # m
    theta: Numbers  # rad
    v: Numbers  # m/s
    scene_t: Numbers  # s
    head: NDArray[np.float64]  # (n, 3) yaw, pitch, roll in rad; NaN where unknown


def recorded_poses(folder: FilePath, most_per_second: float) -> tuple[FloorPlan, Poses]:
    """Return where a recorded trial was driven, and its poses; ValueError when the recording names no place."""
    run = read_run(folder)
    plan = plan_of(run)
    if plan is None:
        raise ValueError(Text("trial-recording-no-place"))
    return plan, poses_of(run, most_per_second)


def poses_of(run: RunRecording, most_per_second: float) -> Poses:
    """Return the poses of a recorded run, at most `most_per_second`; ValueError when the recording holds nothing."""
    rows = run.columns
    if run.rows == 0:
        raise ValueError(Text("trial-recording-empty"))
    t = since_armed(rows)
    periods = np.floor((t - t[0]) * most_per_second)
    chosen = np.flatnonzero(np.diff(periods, prepend=-1.0) > 0)  # the first row of each period
    head = [rows[f"head_{axis}"][chosen] for axis in ("yaw", "pitch", "roll")]
    return Poses(
        t=t[chosen],
        **{name: rows[name][chosen] for name in ("x", "y", "theta", "v")},
        scene_t=rows["scene_t"][chosen],
        head=np.stack(head, axis=1).astype(np.float64),
    )


def since_armed(rows: Columns) -> Numbers:
    """Return the times (n,) s since motion was first permitted, or since the first row when it never was."""
    t: Numbers = rows["t"]
    armed = np.flatnonzero(rows["state"] == State.ARMED)
    since: Numbers = t - t[armed[0] if len(armed) else 0]
    return since


def column(values: NDArray[np.generic]) -> Column:
    """Return rounded numbers for JSON, None where one is not finite."""
    rounded = np.round(values.astype(np.float64), DIGITS)
    if np.isfinite(rounded).all():
        finite: Column = rounded.tolist()
        return finite
    return [value if np.isfinite(value) else None for value in rounded.tolist()]


def _path_coordinates(
    path_points: Sequence[Sequence[float]], x: NDArray[np.generic], y: NDArray[np.generic]
) -> tuple[Column, Column]:
    """Return each place's distance along the path and beside it (m); two empty columns for a path without length."""
    try:
        line = Path(path_points)
    except ValueError:
        return [], []
    coordinates, along = [], 0.0
    for place in zip(x.tolist(), y.tolist(), strict=True):
        along, across = line.project_near(*place, along, WINDOW)
        if abs(across) > LOST:
            along, across = line.project(*place)
        coordinates.append((along, across))
    both = np.array(coordinates)
    return column(both[:, 0]), column(both[:, 1])


def _movers(plan: FloorPlan | None, scene_t: NDArray[np.generic]) -> list[MoverLine]:
    lines = []
    for mover in plan.movers if plan else ():
        track = Track(mover)
        places = np.array([track.at(t).pose for t in scene_t.tolist()])
        lines.append(MoverLine(x=column(places[:, 0]), y=column(places[:, 1]), theta=column(places[:, 2])))
    return lines


def plan_of(run: RunRecording) -> FloorPlan | None:
    """Return the floor plan that a run's recording names; None when it names none."""
    try:
        return FloorPlan.model_validate(run.meta.get("floorplan"))
    except ValidationError:
        return None


def _gestures(run: RunRecording, decimation: Decimation) -> list[GestureLine]:
    parameters = parameters_of(run)
    if parameters is None or run.columns["score"].shape[1] != len(parameters.gestures):
        return []
    lines = []
    for i, gesture in enumerate(parameters.gestures):
        columns = {name: column(decimation.peaks(run.columns[name][:, i])) for name in ("score", "rate", "activation")}
        lines.append(
            GestureLine(
                **gesture.model_dump(include={"name", "joint", "direction", "feature", "dead_zone", "full"}),
                controls=[binding.control for binding in parameters.bindings if gesture.name in binding.gestures],
                **columns,
            )
        )
    return lines


def _joints(run: RunRecording, decimation: Decimation) -> list[JointLines]:
    try:
        layout = ShirtLayout.model_validate(run.meta.get("layout"))
    except ValidationError:
        return []
    values = run.columns["values"]
    if values.shape[1] != len(layout.channels):
        return []
    weights = _weights(parameters_of(run), len(layout.channels))
    labels = layout.joint_labels
    lines = []
    for joint, channels in layout.channels_of_joint.items():
        # The channels with the largest weights, in the order of the shirt; without a map, the first ones.
        chosen = sorted(sorted(channels, key=lambda channel: -weights[channel])[:CHANNELS_SHOWN])
        lines.append(
            JointLines(
                name=joint,
                label=labels.get(joint, joint),
                channels=[
                    ChannelLine(name=layout.channels[i].name, values=column(decimation.peaks(values[:, i])))
                    for i in chosen
                ],
                of=len(channels),
            )
        )
    return lines


def parameters_of(run: RunRecording) -> DriveParameters | None:
    """Return the parameters that a run's recording holds; None when it holds none."""
    try:
        return DriveParameters.model_validate(run.meta.get("parameters"))
    except ValidationError:
        return None


def _weights(parameters: DriveParameters | None, n_channels: int) -> Numbers:
    """Return each channel's absolute weight (n_channels,) in the map of its joint; 0 where it is in none."""
    weights = np.zeros(n_channels)
    for joint in parameters.profile.joints if parameters else ():
        weights[list(joint.channels)] = np.abs(joint.direction)
    return weights


def events_of(columns: Columns, t: NDArray[np.float64], end: str | None) -> list[Event]:
    """Return the events of a trial in the order of time.

    Parameters
    ----------
    columns
        Of the whole recording: `state`, `fault` and `contacts`, (n,) each.
    t
        (n,) s, times of the rows; the events' times are taken from them.
    end
        How the trial ended; "goal" adds the event of reaching the goal, at the last row with motion permitted.
    """
    events = _state_events(columns, t) + _contacts(columns["contacts"], t)
    armed = np.flatnonzero(columns["state"] == State.ARMED)
    if end == "goal" and len(armed):
        events.append(_event(t[armed[-1]], "goal"))
    return sorted(events, key=lambda event: event.t)


def _state_events(columns: Columns, t: NDArray[np.float64]) -> list[Event]:
    state = columns["state"]
    changes = np.flatnonzero(np.diff(state, prepend=np.uint8(State.DISARMED)))
    return [_state_event(int(state[row]), int(columns["fault"][row]), t[row]) for row in changes]


def _state_event(state: int, fault: int, t: float) -> Event:
    if state != State.FAULT:
        kinds: dict[int, EventKind] = {
            State.DISARMED: "disarmed",
            State.CHECKING: "checking",
            State.ARMED: "armed",
        }
        return _event(t, kinds[state])
    reason = Fault(fault)
    kind: EventKind = "stop" if reason in PEOPLE_STOPS else "fault"
    return Event(t=round(float(t), 3), kind=kind, message=EXPLANATIONS[reason].happened)


def _contacts(contacts: NDArray[np.generic], t: NDArray[np.float64]) -> list[Event]:
    return [_event(t[row], "contact") for row in np.flatnonzero(np.diff(contacts.astype(np.int64), prepend=0) > 0)]


def _event(t: float, kind: EventKind) -> Event:
    return Event(t=round(float(t), 3), kind=kind, message=Text(f"timeline-{kind}"))

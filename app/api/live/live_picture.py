"""Makes the live picture: the newest tick in numbers and words, and the condition of the channels."""

import math
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.api.live.message import (
    ArrivalsMoment,
    DriveMoment,
    FaultMessage,
    HeadMoment,
    LiveMessage,
    Number,
    Quality,
    RunMoment,
    ShirtMoment,
    TestMoment,
    TrialMoment,
)
from app.api.live.picture_sender import PictureSender
from app.arrivals import Arrivals
from app.calibration.channel_quality import channel_quality
from app.clock import monotonic
from app.faults import EXPLANATIONS, Fault, is_pause
from app.layout import ShirtLayout
from app.messages import ALIVE, NO_CUE
from app.session.chair_messages import STATE_NAMES, ChairMoment, chair_report
from app.session.control_link import ControlLink
from app.session.equipment.chairs import Chairs
from app.session.equipment.shirt import Equipment
from app.session.open_session import SessionFlow
from app.session.real_drive import RealDriveFlow
from app.session.run_flow import RunFlow
from app.session.run_watch import Halt
from app.session.runs import SessionRuns
from app.session.trial import TrialFlow
from app.texts import Text
from app.world.place_texts import place_text

STALE = 1.0  # s without a tick, after which the control process counts as lost
LOOK_BACK = 1.0  # s of frames for the condition of the channels
NOISY = 3.0  # times the median noise of the channels, above which a channel may be called noisy


class LivePicture:
    """Makes the live picture from the ticks; without a tick, shows the chair at its last pose."""

    def __init__(
        self,
        control: ControlLink,
        equipment: Equipment,
        chairs: Chairs,
        runs: SessionRuns,
        trials: TrialFlow,
        drives: RealDriveFlow,
        others: Sequence[RunFlow[Any]],
        session: SessionFlow,
    ) -> None:
        self._control = control
        self._equipment = equipment
        self._chairs = chairs
        self._runs = runs
        self._trials = trials
        self._drives = drives
        self._others = others
        self._session = session
        self._number = 0
        self._pose: list[float | None] = [0.0, 0.0, 0.0]
        self._scene_t = 0.0
        self._frame: np.void | None = None

    def picture(self) -> LiveMessage:
        """Return the current picture."""
        tick = self._newest()
        if tick is None:
            return self._nothing()
        self._pose = [_number(tick[name], 4) for name in ("x", "y", "theta")]
        self._scene_t = float(tick["scene_t"])
        gestures = [gesture.name for gesture in self._session.loaded.gestures] if self._session.loaded else []
        n = min(int(tick["n_gestures"]), len(gestures))
        fault = Fault(int(tick["fault"]))
        return LiveMessage(
            tick=int(tick["number"]),
            t=_number(tick["t"], 4),
            state=STATE_NAMES[int(tick["state"])],
            fault=None if is_pause(tick["state"], tick["fault"]) else fault_message(fault),
            control="alive",
            u1=_number(tick["u1"], 4),
            u2=_number(tick["u2"], 4),
            v=_number(tick["v"], 4),
            omega=_number(tick["omega"], 4),
            pose=self._pose,
            scene_t=_number(tick["scene_t"], 3),
            head=_head(tick),
            contacts=int(tick["contacts"]),
            in_contact=bool(tick["in_contact"]),
            gestures=gestures[:n],
            score=_numbers(tick["score"][:n], 4),
            rate=_numbers(tick["rate"][:n], 4),
            activation=_numbers(tick["activation"][:n], 4),
            values=self._values(),
            shirt=self._shirt(tick),
            stops=int(tick["stops"]),
            dial=round(float(tick["dial"]), 3),
            chair=self._chair(tick),
            run=self._run(tick),
            trial=self._trial(fault),
            drive=self._real_drive(),
            test=self._test(),
            session=self._session.session_id,
            practice=self._equipment.practice,
        )

    def _nothing(self) -> LiveMessage:
        """Return the picture without a control process, and so without anything that moves the chair."""
        return LiveMessage(
            t=round(monotonic(), 4),
            state="fault",
            fault=fault_message(Fault.CONTROL_LOST),
            control="lost" if self._control.state == "alive" else self._control.state,
            pose=self._pose,
            shirt=self._shirt(None),
            chair=self._chair(None),
            trial=self._trial(Fault.CONTROL_LOST),
            drive=self._real_drive(),
            test=self._test(),
            session=self._session.session_id,
            practice=self._equipment.practice,
        )

    def quality(self) -> Quality:
        """Return the condition and the noise of every channel over the last second, and the shirt's state in words."""
        layout = self._equipment.layout
        if layout is None:
            return Quality(quality=[], noise=[], shirt_words=self._equipment.failure or "", arrivals=self._arrivals())
        frames = self._control.newest_frames(len(layout.channels), self._equipment.sample_rate, LOOK_BACK)
        tick = self._control.newest()
        estimated = 0 if tick is None else int(tick["estimated"])
        return Quality(
            quality=lamps(layout, frames, self._equipment.sample_rate, self._equipment.unused, estimated),
            noise=_numbers(noise_of(frames, len(layout.channels)), 5),
            shirt_words=self._equipment.state,
            arrivals=self._arrivals(),
        )

    def _arrivals(self) -> ArrivalsMoment | None:
        """Return what arrives at the shirt, or why it cannot be opened; None when nothing is known."""
        equipment = self._equipment
        arrivals = equipment.arrivals
        if equipment.shirt is not None and equipment.failure is not None:
            arrivals = Arrivals("unopened", equipment.failure)
        return None if arrivals is None else ArrivalsMoment(**arrivals._asdict())

    def _newest(self) -> np.void | None:
        ticks = self._control.since(self._number)
        if ticks is not None and len(ticks):
            self._number = int(ticks["number"][-1])
            framed = np.flatnonzero(ticks["has_frame"])
            if len(framed):
                self._frame = ticks[framed[-1]].copy()
        tick = self._control.newest()
        if tick is None or monotonic() - float(tick["t"]) > STALE:
            # A new control process counts its ticks from 1.
            self._number, self._frame = 0, None
            return None
        if int(tick["number"]) < self._number:
            self._number = 0
        return tick

    def _values(self) -> list[Number] | None:
        if self._frame is None:
            return None
        return _numbers(self._frame["values"][: int(self._frame["n_channels"])], 5)

    def _shirt(self, tick: np.void | None) -> ShirtMoment:
        age = None if tick is None or self._frame is None else float(tick["t"] - self._frame["t"])
        return ShirtMoment(
            chosen=self._equipment.shirt is not None,
            alive=age is not None and age < ALIVE,
            sample_rate=self._equipment.sample_rate,
            lost=0 if tick is None else int(tick["lost"]),
            age=None if age is None else round(age, 3),
        )

    def _run(self, tick: np.void) -> RunMoment | None:
        run = self._runs.open
        if run is None or int(tick["run"]) != run.number:
            return None
        cue = int(tick["cue"])
        return RunMoment(kind=run.kind, t=_number(tick["run_t"], 3), cue=None if cue == NO_CUE else cue)

    def _trial(self, fault: Fault) -> TrialMoment | None:
        trial = self._trials.current
        if trial is None:
            return None
        place, part = trial.place, trial.watch.progress.part
        return TrialMoment(
            id=trial.id,
            waits=_waits(trial.watch.halt),
            paused=fault_message(fault) if trial.watch.paused else None,
            pauses=trial.watch.pauses,
            measuring=self._trials.measuring,
            t=_number(place.t, 3),
            done=_number(place.done, 3),
            length=_number(place.length, 3),
            cross_track=_number(place.cross_track, 3),
            e_diff=_number(place.e_diff, 3),
            leader_distance=_number(place.leader_distance, 3),
            movers=[_numbers(pose, 3) for pose in trial.watch.movers(self._scene_t)],
            leader=None if place.leader is None else _numbers(place.leader, 3),
            stage=place.stage,
            stages=trial.watch.progress.stages,
            kind=part.task.kind,
            title=place_text(trial.plan.name, part.title),
            instruction=place_text(trial.plan.name, part.instruction),
            target=[round(float(value), 3) for value in part.points[-1]],
        )

    def _chair(self, tick: np.void | None) -> ChairMoment | None:
        if self._chairs.chosen is None:
            return None
        if tick is None:
            return ChairMoment(message=Text("api-process-restarting"))
        return chair_report(tick) if tick["chair_kind"] else ChairMoment(message=self._chairs.not_open)

    def _real_drive(self) -> DriveMoment | None:
        drive = self._drives.current
        if drive is None:
            return None
        return DriveMoment(id=drive.id, t=_number(drive.watch.t, 3), waits=_waits(drive.watch.halt))

    def _test(self) -> TestMoment | None:
        shown = ((flow.current, flow.cursor_task) for flow in self._others)
        current, task = next((pair for pair in shown if None not in pair), (None, None))
        if current is None or task is None:
            return None
        target = task.target
        return TestMoment(
            id=current.id,
            phase=task.phase,
            remaining=_number(task.remaining, 2),
            cursor=_numbers((task.ahead, task.left), 4),
            target=None if target is None else _numbers((target.ahead, target.left), 4),
            radius=_number(task.plan.width / 2.0, 4),
            dwell=_number(min(1.0, task.inside / task.plan.dwell), 3),
            acquired=task.acquired,
            missed=len(task.attempts) - task.acquired,
        )


def _head(tick: np.void) -> HeadMoment | None:
    """Return the direction of the head, None without a head tracker."""
    if not math.isfinite(float(tick["head_age"])):
        return None
    return HeadMoment(
        yaw=_number(tick["head_yaw"], 4),
        pitch=_number(tick["head_pitch"], 4),
        roll=_number(tick["head_roll"], 4),
        age=_number(tick["head_age"], 4),
    )


def fault_message(fault: Fault) -> FaultMessage | None:
    """Return a fault in words, None when there is none."""
    if fault is Fault.NONE:
        return None
    message = EXPLANATIONS[fault]
    return FaultMessage(
        name=fault.name.lower(), happened=message.happened, next_step=message.next_step, remedy=message.remedy
    )


def lamps(
    layout: ShirtLayout, frames: NDArray[np.float64], sample_rate: float, unused: list[str], estimated: int = 0
) -> list[str]:
    """Return the condition of every channel, for its lamp, from the frames (n, n_channels) of the last second.

    `estimated` has bit i set when channel i is bad and its neighbours stand in for it.
    """
    names = layout.channel_names
    if len(frames) < 4:
        conditions = ["silent"] * len(names)
    else:
        groups = list(layout.channels_of_joint.values())
        noise = noise_of(frames, len(names))
        is_noisy = noise > NOISY * np.nanmedian(noise) if np.isfinite(noise).any() else noise > 0
        qualities = channel_quality(frames, groups, sample_rate)
        excused: dict[str, list[bool]] = {"noisy": (~is_noisy).tolist(), "flat": layout.may_stay_constant}
        conditions = [
            "good" if condition in excused and excused[condition][i] else condition
            for i, (condition, _) in enumerate(qualities)
        ]
        conditions = ["estimated" if estimated >> i & 1 else condition for i, condition in enumerate(conditions)]
    return ["unused" if name in unused else condition for name, condition in zip(names, conditions, strict=True)]


def noise_of(frames: NDArray[np.float64], channels: int) -> NDArray[np.float64]:
    """Return the noise (signal units) of every channel, (n_channels,)."""
    if len(frames) < 4:
        return np.full(channels, np.nan)
    # Second differences remove smooth movement; of white noise they have sqrt(6) times its standard deviation.
    return np.asarray(np.std(np.diff(frames, n=2, axis=0), axis=0) / math.sqrt(6.0))


def _waits(halt: Halt) -> Number:
    """Return how much longer (s) a halted trial or drive waits for Continue, None when it is not halted."""
    return None if halt.remaining is None else _number(halt.remaining, 1)


def _numbers(values: Iterable[Any], digits: int) -> list[Number]:
    return [_number(value, digits) for value in values]


def _number(value: Any, digits: int) -> Number:
    """Return a rounded number, None for None and for one that is not finite, which JSON cannot hold."""
    number = math.nan if value is None else float(value)
    return round(number, digits) if math.isfinite(number) else None


class ClinicLive(PictureSender[LiveMessage]):
    """Sends the live picture to the pages of the people who are signed in."""

"""The live picture: the newest tick in numbers and words, and the condition of the channels."""

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from app.calibration.channel_quality import channel_quality
from app.clock import monotonic
from app.faults import EXPLANATIONS, Fault, State, is_pause
from app.layout import ShirtLayout
from app.messages import ALIVE, NO_CUE
from app.session.control_link import ControlLink
from app.session.equipment.chairs import Chairs
from app.session.equipment.shirt import Equipment
from app.session.interface_test.interface_test_flow import InterfaceTestFlow
from app.session.open_session import SessionFlow
from app.session.real_drive import RealDriveFlow
from app.session.run_watch import Halt
from app.session.runs import SessionRuns
from app.session.trial import TrialFlow
from app.session.words.chair_words import chair_report, closed_chair_report

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
        tests: InterfaceTestFlow,
        session: SessionFlow,
    ) -> None:
        self._control = control
        self._equipment = equipment
        self._chairs = chairs
        self._runs = runs
        self._trials = trials
        self._drives = drives
        self._tests = tests
        self._session = session
        self._number = 0
        self._pose: list[float | None] = [0.0, 0.0, 0.0]
        self._scene_t = 0.0
        self._frame: np.void | None = None

    def picture(self) -> dict[str, Any]:
        """Return the current picture."""
        tick = self._newest()
        if tick is None:
            return self._nothing()
        self._pose = [_number(tick[name], 4) for name in ("x", "y", "theta")]
        self._scene_t = float(tick["scene_t"])
        gestures = [gesture.name for gesture in self._session.loaded.gestures] if self._session.loaded else []
        n = min(int(tick["n_gestures"]), len(gestures))
        age = float(tick["t"] - self._frame["t"]) if self._frame is not None else None
        return {
            "tick": int(tick["number"]),
            "t": _number(tick["t"], 4),
            "state": State(int(tick["state"])).name.lower(),
            "fault": None if is_pause(tick["state"], tick["fault"]) else fault_view(Fault(int(tick["fault"]))),
            "control": "alive",
            **{name: _number(tick[name], 4) for name in ("u1", "u2", "v", "omega")},
            "pose": self._pose,
            "scene_t": _number(tick["scene_t"], 3),
            "head": _head(tick),
            "contacts": int(tick["contacts"]),
            "in_contact": bool(tick["in_contact"]),
            "gestures": gestures[:n],
            **{name: [_number(value, 4) for value in tick[name][:n]] for name in ("score", "rate", "activation")},
            "values": self._values(),
            "shirt": {
                "chosen": self._equipment.shirt is not None,
                "alive": age is not None and age < ALIVE,
                "sample_rate": self._equipment.sample_rate,
                "lost": int(tick["lost"]),
                "age": None if age is None else round(age, 3),
            },
            "stops": int(tick["stops"]),
            "dial": _number(tick["dial"], 3),
            "chair": self._chair(tick),
            "run": self._run(tick),
            "trial": self._trial(Fault(int(tick["fault"]))),
            "drive": self._real_drive(),
            "test": self._test(),
            **self._session_and_practice(),
        }

    def quality(self) -> dict[str, Any]:
        """Return the condition and the noise of every channel over the last second, and the shirt's state in words."""
        layout = self._equipment.layout
        if layout is None:
            return {"quality": [], "noise": [], "shirt_words": self._equipment.words}
        frames = self._frames(len(layout.channels))
        tick = self._control.newest()
        estimated = 0 if tick is None else int(tick["estimated"])
        return {
            "quality": lamps(layout, frames, self._equipment.sample_rate, self._equipment.unused, estimated),
            "noise": [_number(noise, 5) for noise in noise_of(frames, len(layout.channels))],
            "shirt_words": self._equipment.state,
        }

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

    def _frames(self, channels: int) -> NDArray[np.float64]:
        newest = self._control.newest()
        if newest is None:
            return np.empty((0, channels))
        rate = max(self._equipment.sample_rate, 1.0)
        ticks = self._control.since(max(0, int(newest["number"]) - int(2 * LOOK_BACK * rate)))
        if ticks is None:
            return np.empty((0, channels))
        recent = ticks[(ticks["has_frame"] == 1) & (ticks["t"] > float(newest["t"]) - LOOK_BACK)]
        return np.asarray(recent["values"][:, :channels], dtype=np.float64)

    def _values(self) -> list[float | None] | None:
        if self._frame is None:
            return None
        return [_number(value, 5) for value in self._frame["values"][: int(self._frame["n_channels"])]]

    def _run(self, tick: np.void) -> dict[str, Any] | None:
        run = self._runs.open
        if run is None or int(tick["run"]) != run.number:
            return None
        cue = int(tick["cue"])
        return {"kind": run.kind, "t": _number(tick["run_t"], 3), "cue": None if cue == NO_CUE else cue}

    def _trial(self, fault: Fault) -> dict[str, Any] | None:
        trial = self._trials.current
        if trial is None:
            return None
        place, part, stages = trial.place, trial.watch.progress.part, trial.watch.progress.stages
        names = ("t", "done", "length", "cross_track", "e_diff", "leader_distance")
        return {
            "id": trial.id,
            "waits": _waits(trial.watch.halt),
            "paused": fault_view(fault) if trial.watch.paused else None,
            "pauses": trial.watch.pauses,
            "measuring": self._trials.measuring,
            **{name: None if (v := getattr(place, name)) is None else _number(v, 3) for name in names},
            "movers": [[_number(value, 3) for value in pose] for pose in trial.watch.movers(self._scene_t)],
            "leader": None if place.leader is None else [_number(value, 3) for value in place.leader],
            "stage": place.stage,
            "stages": stages,
            "kind": part.task.kind,
            "title": part.title,
            "instruction": part.instruction,
            "target": [_number(value, 3) for value in part.points[-1]],
        }

    def _chair(self, tick: np.void) -> dict[str, Any] | None:
        if self._chairs.chosen is None:
            return None
        return chair_report(tick) if tick["chair_kind"] else closed_chair_report(self._chairs.not_open)

    def _real_drive(self) -> dict[str, Any] | None:
        drive = self._drives.current
        if drive is None:
            return None
        return {"id": drive.id, "t": _number(drive.watch.t, 3), "waits": _waits(drive.watch.halt)}

    def _test(self) -> dict[str, Any] | None:
        """Return cursor and target of the interface test; lengths in arms of the cross, ahead and to the left."""
        test = self._tests.current
        if test is None:
            return None
        task = test.watch.task
        target = task.target
        return {
            "id": test.id,
            "phase": task.phase,
            "remaining": _number(task.remaining, 2),
            "cursor": [_number(task.ahead, 4), _number(task.left, 4)],
            "target": None if target is None else [_number(target.ahead, 4), _number(target.left, 4)],
            "radius": _number(task.plan.width / 2.0, 4),
            "dwell": _number(min(1.0, task.inside / task.plan.dwell), 3),
            "acquired": task.acquired,
            "missed": len(task.attempts) - task.acquired,
        }

    def _nothing(self) -> dict[str, Any]:
        """Return the picture while there is no control process, and so nothing that moves the chair."""
        control = "lost" if self._control.state == "alive" else self._control.state
        return {
            "tick": 0,
            "t": round(monotonic(), 4),
            "state": "fault",
            "fault": fault_view(Fault.CONTROL_LOST),
            "control": control,
            **dict.fromkeys(("u1", "u2", "v", "omega"), 0.0),
            "pose": self._pose,
            "scene_t": 0.0,
            "head": None,
            "contacts": 0,
            "in_contact": False,
            "gestures": [],
            **{name: [] for name in ("score", "rate", "activation")},
            "values": None,
            "shirt": {
                "chosen": self._equipment.shirt is not None,
                "alive": False,
                "sample_rate": self._equipment.sample_rate,
                "lost": 0,
                "age": None,
            },
            "stops": 0,
            "dial": 1.0,
            "chair": None
            if self._chairs.chosen is None
            else closed_chair_report("The control process is being restarted."),
            "run": None,
            "trial": self._trial(Fault.CONTROL_LOST),
            "drive": self._real_drive(),
            "test": self._test(),
            **self._session_and_practice(),
        }

    def _session_and_practice(self) -> dict[str, Any]:
        """Return the id of the open session, and the kind of the chosen shirt when nobody wears it."""
        return {
            "hidden": False,  # see app/api/live/without_patient.py
            "session": self._session.session_id,
            "practice": self._equipment.practice,
        }


def _head(tick: np.void) -> dict[str, float | None] | None:
    """Return the direction of the head (rad) and its age (s), None without a head tracker."""
    if not math.isfinite(float(tick["head_age"])):
        return None
    return {name: _number(tick[f"head_{name}"], 4) for name in ("yaw", "pitch", "roll", "age")}


def fault_view(fault: Fault) -> dict[str, str] | None:
    """Return a fault in words, None when there is none."""
    if fault is Fault.NONE:
        return None
    words = EXPLANATIONS[fault]
    return {
        "name": fault.name.lower(),
        "happened": words.happened,
        "next_step": words.next_step,
        "remedy": words.remedy,
    }


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
        conditions = [
            "good" if quality.condition == "noisy" and not is_noisy[i] else quality.condition
            for i, quality in enumerate(channel_quality(frames, groups, sample_rate))
        ]
        conditions = ["estimated" if estimated >> i & 1 else condition for i, condition in enumerate(conditions)]
    return ["unused" if name in unused else condition for name, condition in zip(names, conditions, strict=True)]


def noise_of(frames: NDArray[np.float64], channels: int) -> NDArray[np.float64]:
    """Return the noise (signal units) of every channel, (n_channels,)."""
    if len(frames) < 4:
        return np.full(channels, np.nan)
    # Second differences remove smooth movement; of white noise they have sqrt(6) times its standard deviation.
    return np.asarray(np.std(np.diff(frames, n=2, axis=0), axis=0) / math.sqrt(6.0))


def _waits(halt: Halt) -> float | None:
    """Return how much longer (s) a halted trial or drive waits for Continue, None when it is not halted."""
    return None if halt.remaining is None else _number(halt.remaining, 1)


def _number(value: Any, digits: int) -> float | None:
    """Return a rounded number, None for one that is not finite, which JSON cannot hold."""
    number = float(value)
    return round(number, digits) if math.isfinite(number) else None

"""The web application for a test, with a stand-in for the control process.

Building the application's routes takes longer than most tests. So an application is built once, and started with other
settings for each test: whatever it keeps, it makes at its start and gives up at its end.
"""

import asyncio
from collections.abc import Callable, Iterator
from dataclasses import fields
from pathlib import Path
from typing import Any

import numpy as np
from api.fake_clinic import BASE, Clinic
from api.fake_process import FakeProcess, profile_for
from api.one_hop import OneHop
from session.same_process import SameProcess
from starlette.testclient import TestClient

from app.api.app import create_app
from app.api.replay.trajectories import Trajectory, shown_trajectories
from app.calibration.prior.documents import PersonEntry
from app.calibration.prior.map_prior import MapPrior
from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step
from app.calibration.vocabulary import DriveParameters
from app.layout import ShirtLayout
from app.recording.recorded_trajectory import RecordedTrajectory, read_trajectory
from app.scoring.control_quality import ControlQuality
from app.session.adaptation_reading import adapt_from_recordings
from app.session.recordings import (
    check_recording,
    entry_of_recordings,
    fit_recordings,
    fit_recordings_to_donning,
    judge_step,
    measure_recording,
    quality_of_recording,
)
from app.settings import Settings


class RunningApp:
    """An application that can be started again and again, one start at a time."""

    def __init__(self) -> None:
        self._settings = Settings(state=Path("given-at-the-start"))
        self._processes: list[FakeProcess] = []
        self._answers: dict[str, Any] = {}
        line = Trajectory([0.0, 1.0], [0.0, 1.0], [0.0, 0.0])
        stand_ins: dict[Callable[..., Any], Callable[..., Any]] = {
            check_recording: lambda _folder, _duration: self._answers["judge"],
            fit_recordings: self._fit,
            entry_of_recordings: self._entry,
            judge_step: lambda _layout, _recorded, _unused, step: self._answers.get("advice", {}).get(step.id, ""),
            fit_recordings_to_donning: self._fit_to_donning,
            measure_recording: lambda _folder, _plan, _path: self._answers["measures"],
            read_trajectory: lambda _folder: RecordedTrajectory(*(np.array(column) for column in line)),
            shown_trajectories: lambda folders: [line for _ in folders],
            quality_of_recording: lambda _folder: self._quality(),
            adapt_from_recordings: lambda *given: self._answers["adapt"](*given) if "adapt" in self._answers else None,
        }
        self._app = create_app(self._settings, self._start_process, SameProcess(stand_ins))

    def start(self, settings: Settings) -> Iterator[Clinic]:
        """Start it with these settings, and yield it until it is to end."""
        for field in fields(Settings):  # frozen for the program, where nothing changes them after the start
            object.__setattr__(self._settings, field.name, getattr(settings, field.name))
        self._processes = []
        self._answers = {"judge": None, "measures": {"dist": 12.0, "e_diff": 1.5, "reached": True}}
        browser = ("127.0.0.1", 50_000)
        with TestClient(self._app, base_url=BASE, raise_server_exceptions=False, client=browser) as client:
            assert client.portal is not None
            loop = client.portal.call(asyncio.get_running_loop)
            client._transport = OneHop(self._app, loop, browser, client._transport)
            yield Clinic(client, self._processes, self._answers)

    async def _start_process(self) -> FakeProcess:
        self._processes.append(FakeProcess())
        return self._processes[-1]

    def _fit(
        self,
        layout: ShirtLayout,
        recorded: list[tuple[Step, Path]],
        _unused: list[str],
        prior: MapPrior | None,
        as_worn: tuple[str, ...],
    ) -> CalibrationProfile:
        if "fit" in self._answers:
            raise ValueError(self._answers["fit"])
        self._answers["fitted"] = [step.id for step, _ in recorded], prior
        self._answers["as_worn"] = as_worn
        make: Callable[[ShirtLayout], CalibrationProfile] = self._answers.get("profile", profile_for)
        return make(layout)

    def _fit_to_donning(
        self,
        parameters: DriveParameters,
        _calibrated: CalibrationProfile,
        recorded: list[tuple[Step, Path]],
        _prior: MapPrior | None,
    ) -> DriveParameters:
        if "fit" in self._answers:
            raise ValueError(self._answers["fit"])
        self._answers["fitted"] = [step.id for step, _ in recorded]
        high = tuple(value + 0.5 for value in parameters.profile.high)
        return parameters.model_copy(update={"profile": parameters.profile.model_copy(update={"high": high})})

    def _entry(self, _layout: ShirtLayout, _recorded: list[tuple[Step, Path]]) -> PersonEntry:
        if "entry" not in self._answers:
            raise ValueError("No joint was prompted.")
        return PersonEntry.model_validate(self._answers["entry"])

    def _quality(self) -> ControlQuality:
        if "quality" not in self._answers:
            raise ValueError("The recording does not say with what parameters it was driven.")
        return ControlQuality.model_validate(self._answers["quality"])


_idle: list[RunningApp] = []  # several only where a test starts one while another runs


def running(settings: Settings) -> Iterator[Clinic]:
    """Yield a clinic that runs with these settings, and end it."""
    app = _idle.pop() if _idle else RunningApp()
    yield from app.start(settings)
    _idle.append(app)  # one whose test failed is not used again

"""The open session: load its patient's parameters, and refuse what must not be done during a step, trial or drive."""

import asyncio
from collections.abc import AsyncIterator, Sequence
from contextlib import asynccontextmanager, suppress
from typing import Any, Literal, NamedTuple

from app.calibration.vocabulary import DriveParameters
from app.news import News, Notify
from app.pipeline.person_brakes import missing_brake
from app.refusals import Conflict, Refusal
from app.session.calibration.calibration_flow import CalibrationFlow
from app.session.control_link import ControlLink
from app.session.equipment.shirt import NO_SHIRT, Equipment
from app.session.page_session import require_page_session
from app.session.real_drive import RealDriveFlow
from app.session.run_flow import RunFlow
from app.session.trial import TrialFlow
from app.source import SourceGroup
from app.store.database import Database
from app.store.map_versions import source_of_map
from app.store.parameters import as_document, current_parameters, newest_profile
from app.store.patients import open_session
from app.store.tables import PatientSession
from app.texts import Text

SILENT = Text("visit-shirt-silent")
NOBODY = (None, None)  # ids of session and patient while no session is open


class DriveObstacle(NamedTuple):
    """Why a parameter set cannot drive in the shirt in use, in one sentence, and the page on which that is mended."""

    sentence: Text | str
    page: Literal["shirt", "calibrate", "controls"]


def _may_drive(calibrated: SourceGroup, in_use: SourceGroup) -> bool:
    """Return whether a shirt of one group may drive by a calibration of another: only for practice."""
    return in_use == "simulated" or calibrated in {in_use, "unknown"}


class SessionFlow:
    """Loads the parameters of the patient who is here into the control process, where they fit the shirt in use."""

    def __init__(
        self,
        database: Database,
        control: ControlLink,
        equipment: Equipment,
        calibration: CalibrationFlow,
        trials: TrialFlow,
        drives: RealDriveFlow,
        others: Sequence[RunFlow[Any]],
        notify: Notify,
    ) -> None:
        self._database = database
        self._control = control
        self._equipment = equipment
        self._calibration = calibration
        self._trials = trials
        self._drives = drives
        self._others = others  # what else is recorded in a session
        self._notify = notify
        self._one_at_a_time = asyncio.Lock()
        self.loaded: DriveParameters | None = None  # what the control process drives with
        # Of the open session; may be read from any thread.
        self.session_id: int | None = None
        self.patient_id: int | None = None

    @asynccontextmanager
    async def undisturbed(self) -> AsyncIterator[None]:
        """Refuse during a step, a trial or a drive, and let none of them begin inside the `async with` block.

        Two screens may ask at the same moment: without the lock, the session could change while a trial is being
        started.
        """
        async with self._one_at_a_time:
            await asyncio.to_thread(self._require_page_session)  # the session may have changed while the request waited
            self.refuse_while_busy()
            yield

    def _require_page_session(self) -> None:
        with self._database.reading() as db:
            require_page_session(db)

    @property
    def driving(self) -> bool:
        """Whether a trial or a drive is going on; may be read from any thread."""
        return self._trials.running or self._drives.running

    @property
    def recording(self) -> bool:
        """Whether a step, a trial, a drive or another run is going on; may be read from any thread."""
        return self.driving or self._calibration.running or any(flow.running for flow in self._others)

    @property
    def group(self) -> SourceGroup:
        """The group of sources that the shirt in use belongs to; may be read from any thread."""
        return self._equipment.group

    def refuse_while_busy(self) -> None:
        """Raise Conflict during a step, a trial or a drive."""
        flows: tuple[RunFlow[Any], ...] = (self._trials, self._drives, *self._others)
        for flow in flows:
            if flow.running:
                raise Conflict(Text("visit-busy", running=flow.messages.event))
        if self._calibration.running:
            raise Conflict(Text("visit-busy", running="step"))

    async def needed_session(self) -> PatientSession:
        """Return the open session; Conflict when there is none."""

        def _read() -> PatientSession | None:
            with self._database.reading() as db:
                require_page_session(db)
                return open_session(db)

        session = await asyncio.to_thread(_read)
        if session is None:
            raise Conflict(Text("visit-nobody"))
        return session

    async def session_changed(self) -> None:
        """Load the parameters of the patient who is here now; load none when nobody is here."""
        before = (self.session_id, self.patient_id)
        now = await asyncio.to_thread(self._open_ids)
        self.session_id, self.patient_id = now
        await self.try_load_parameters()
        shown = [ids for ids in dict.fromkeys((before, now)) if ids != NOBODY]  # the session before has ended
        for session, patient in shown or [NOBODY]:
            self._notify(News(what="session", patient=patient, session=session))

    async def load_parameters(self) -> Text | str | None:
        """Load the current parameters into the control process; return in one sentence why they cannot drive."""
        # Otherwise a restarted control process would be given the parameters of the patient before.
        self._control.forget("parameters")
        self.loaded = None
        current = await asyncio.to_thread(self._current)
        if current is None:
            await self._control.load("parameters", parameters=None)
            return None
        document, group = current
        fitting = document if self._misfit(document, group) is None else None
        await self._control.load("parameters", parameters=fitting and fitting.model_dump(mode="json"))
        self.loaded = fitting
        obstacle = self.obstacle(document, group)
        return None if obstacle is None else obstacle.sentence

    def current_obstacle(self) -> DriveObstacle | None:
        """Return why the current parameters of the open session's patient cannot drive, None when they can.

        None also for a patient without a calibration. Reads the database: call it in a thread.
        """
        current = self._current()
        return None if current is None else self.obstacle(*current)

    def obstacle(self, parameters: DriveParameters, group: SourceGroup) -> DriveObstacle | None:
        """Return why parameters cannot drive: a silent shirt, another shirt, or no way to stop; None when they can.

        `group` is that of the recordings which they were calibrated with.
        """
        if self._equipment.silent:
            return DriveObstacle(SILENT, "shirt")
        misfit = self._misfit(parameters, group)
        brake = missing_brake(parameters) if misfit is None else None
        return DriveObstacle(brake, "controls") if brake else misfit

    def _misfit(self, parameters: DriveParameters, group: SourceGroup) -> DriveObstacle | None:
        layout = self._equipment.layout
        if layout is None:
            return DriveObstacle(self._equipment.failure or NO_SHIRT, "shirt")
        in_use = self._equipment.group
        if group == "simulated" != in_use:
            reason = Text("visit-calibrated-unworn")
        elif not layout.fits(parameters.profile.layout) or not _may_drive(group, in_use):
            reason = Text("visit-calibrated-in-another")
        elif abs(self._equipment.sample_rate - parameters.profile.sample_rate) > 0.01 * parameters.profile.sample_rate:
            reason = Text("visit-calibrated-at-another-rate")
        else:
            return None
        return DriveObstacle(reason, "calibrate")

    async def try_load_parameters(self) -> None:
        """Load the current parameters, ignoring a refusal: a trial loads them again before it arms."""
        with suppress(Refusal):
            await self.load_parameters()

    def _open_ids(self) -> tuple[int | None, int | None]:
        with self._database.reading() as db:
            session = open_session(db)
            return (None, None) if session is None else (session.id, session.patient_id)

    def _current(self) -> tuple[DriveParameters, SourceGroup] | None:
        with self._database.reading() as db:
            session = open_session(db)
            if session is None or newest_profile(db, session.patient_id) is None:
                return None
            row, profile = current_parameters(db, session.patient_id)
            return as_document(row, profile), source_of_map(db, profile)

"""Adaptation of the map: propose a change from the last trials, and apply it at a standstill."""

import asyncio
import logging
import threading
import uuid
from dataclasses import dataclass, replace
from functools import partial
from typing import Literal

from app.computing_process import ComputingProcess
from app.faults import State
from app.news import News, Notify
from app.refusals import Conflict, NotFound, Refusal, Unavailable
from app.scoring.map_losses.losses import NOTHING_READ
from app.session.adaptation_reading import AdaptationResult, PastRun, adapt_from_recordings
from app.session.control_link import ControlLink
from app.session.equipment.chairs import Chairs
from app.session.open_session import SessionFlow
from app.session.runs import SessionRuns
from app.session.trial import TrialFlow
from app.store.adaptation_material import is_current, material_for, mode_of
from app.store.database import Database
from app.store.log import write_log
from app.store.map_versions import go_back, save_adapted
from app.store.practice import PracticeHistory
from app.store.tables import Patient, PatientSession, Trial
from app.texts import Text, text_of

logger = logging.getLogger("bodydrive")

Mode = Literal["off", "suggest", "auto"]

STANDSTILL = 0.01  # m/s and rad/s

NOT_ASKED: dict[str, Text] = {
    "off": Text("visit-adapt-off"),
    "suggest": Text("visit-adapt-suggest"),
    "auto": Text("visit-adapt-auto"),
}
NOT_NOW = Text("visit-adapt-not-now")
NO_TRIALS = Text("visit-adapt-no-trials")
LEFT_OFF = Text("visit-adapt-left-off")
SWITCHED = Text("visit-adapt-switched")
STALE = Text("visit-adapt-stale")
GONE = Text("visit-adapt-gone")
REAL_CHAIR = Text("visit-adapt-real-chair")
NOT_STILL = Text("visit-adapt-not-still")
LARGE = Text("visit-adapt-large")


@dataclass(frozen=True, slots=True)
class AdaptationProposal:
    """A proposal to adapt a patient's map: one that waits, or the one that was applied last."""

    id: str
    patient_id: int
    trials: tuple[int, ...]  # ids of those that it was made from, the newest last
    base_hash: str  # of the parameter set that it would change
    result: AdaptationResult
    applied: int | None = None  # the version that it became
    reason: Text | str | None = None  # why it was not applied by itself


class AdaptationFlow:
    """Makes a proposal after each trial on the virtual chair; applies it between trials only, never on a real chair."""

    def __init__(
        self,
        database: Database,
        control: ControlLink,
        runs: SessionRuns,
        trials: TrialFlow,
        session: SessionFlow,
        chairs: Chairs,
        notify: Notify,
        computing: ComputingProcess,
    ) -> None:
        self._database = database
        self._control = control
        self._runs = runs
        self._session = session
        self._chairs = chairs
        self._notify = notify
        self._computing = computing
        self._one_at_a_time = asyncio.Lock()
        self._ending = threading.Event()
        self._tasks: set[asyncio.Task[None]] = set()
        self._newest: AdaptationProposal | None = None
        self._read = NOTHING_READ
        self._reasons: dict[int, Text | str] = {}  # patient id -> why there is no proposal
        self.practice = PracticeHistory()
        trials.when_finished(self.trial_over)

    @property
    def is_proposing(self) -> bool:
        """Whether a proposal is being made."""
        return self._one_at_a_time.locked()

    def proposal_for(self, patient_id: int) -> AdaptationProposal | None:
        """Return the patient's proposal, None when there is none."""
        newest = self._newest
        return newest if newest is not None and newest.patient_id == patient_id else None

    def reason_for_none(self, patient_id: int) -> Text | str | None:
        """Return in a sentence why the patient has no proposal; None when none was tried."""
        return self._reasons.get(patient_id)

    def refusal(self) -> Text | None:
        """Return in a sentence why nothing may be applied at this moment, None when it may."""
        if self._chairs.chosen is not None:
            return REAL_CHAIR
        tick = self._control.newest()
        if tick is None:
            return Text("visit-adapt-restarting")
        if tick["chair_kind"]:
            return REAL_CHAIR
        if tick["state"] == State.FAULT:
            return Text("visit-adapt-stopped")
        moves = max(abs(float(tick[name])) for name in ("v", "omega", "driven_v", "driven_omega")) > STANDSTILL
        return NOT_STILL if moves or tick["state"] != State.DISARMED else None

    def trial_over(self, trial_id: int) -> None:
        """Make a proposal after a trial has ended, in a task of its own that nobody waits for."""
        if not self._ending.is_set():
            task = asyncio.create_task(self._after(trial_id))
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)

    async def propose(self, session: PatientSession) -> None:
        """Make a proposal from the last trials, whatever the mode is."""
        if self._chairs.chosen is not None:
            raise Conflict(REAL_CHAIR)
        async with self._one_at_a_time:
            self._session.refuse_while_busy()
            await asyncio.to_thread(self._propose, session.patient_id, session.id)
        self._notify(News(what="adaptation", patient=session.patient_id))

    async def apply(self, proposal: str, person: str | None) -> int:
        """Make a proposal the patient's next map, and return the version; `person` None: it applies by itself."""
        async with self._session.undisturbed():
            self._require_standstill()
            session = await self._session.needed_session()
            version = await asyncio.to_thread(self._save, session, proposal, person)
            await self._session.try_load_parameters()
        self._notify(News(what="controls", patient=session.patient_id))
        self._notify(News(what="adaptation", patient=session.patient_id))
        return version

    async def back(self, person: str) -> int:
        """Go back to the map before the current one, and return the version that it becomes."""
        async with self._session.undisturbed():
            session = await self._session.needed_session()
            version = await asyncio.to_thread(self._back, session, person)
            await self._session.try_load_parameters()
        self._notify(News(what="controls", patient=session.patient_id))
        self._notify(News(what="adaptation", patient=session.patient_id))
        return version

    async def dismiss(self, session: PatientSession, proposal: str) -> None:
        """Forget a proposal; the next trial may bring another."""
        waiting = self.proposal_for(session.patient_id)
        if waiting is not None and waiting.id == proposal and waiting.applied is None:
            self._newest = None
            self._reasons[session.patient_id] = NOT_NOW
        self._notify(News(what="adaptation", patient=session.patient_id))

    async def set_mode(self, session: PatientSession, mode: Mode, person: str) -> None:
        """Choose whether this patient's map is adapted, and by whom."""

        def _write() -> None:
            with self._database.transaction() as db:
                db.get_one(Patient, session.patient_id).adaptation = mode
                write_log(db, person, "adaptation chosen", patient=session.patient_id, mode=mode)

        await asyncio.to_thread(_write)
        self._notify(News(what="adaptation", patient=session.patient_id))

    async def stop(self) -> None:
        """Abandon the proposal that is being made, because the application ends."""
        self._ending.set()
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)

    async def _after(self, trial_id: int) -> None:
        patient: int | None = None
        try:
            trial, mode = await asyncio.to_thread(self._trial, trial_id)
            patient = trial.patient_id
            if mode == "off" or self._chairs.chosen is not None:
                return
            async with self._one_at_a_time:
                await asyncio.to_thread(self._propose, patient, trial.session_id)
            if mode == "auto":
                await self._apply_by_itself(patient)
        except (Refusal, ValueError, OSError):  # the next trial makes another
            logger.exception("No proposal was made after trial %d", trial_id)
        self._notify(News(what="adaptation", patient=patient))

    async def _apply_by_itself(self, patient_id: int) -> None:
        waiting = self.proposal_for(patient_id)
        if waiting is None or waiting.result.proposal.parameters is None:
            return
        try:
            if waiting.result.proposal.warns:
                raise Conflict(LARGE)
            await self.apply(waiting.id, None)
        except Refusal as refusal:
            if self._newest is waiting:
                self._newest = replace(waiting, reason=text_of(refusal))

    def _require_standstill(self) -> None:
        refusal = self.refusal()
        if refusal is not None:
            raise Unavailable(refusal) if self._control.newest() is None else Conflict(refusal)

    def _is_disturbed(self) -> bool:
        """Return whether to abandon a proposal that is being made: the application ends, or somebody drives."""
        return self._ending.is_set() or self._session.driving

    def _propose(self, patient_id: int, session_id: int) -> None:
        with self._database.reading() as db:
            material = material_for(db, patient_id, session_id, self._session.group)
        folders = [self._runs.folder_of(run_id) for run_id in material.run_ids]
        self._newest, result = None, None
        if material.fresh:
            past = [PastRun(self._runs.folder_of(trial.run_id), trial.fulls) for trial in material.past]
            question = partial(
                adapt_from_recordings,
                material.parameters,
                material.calibrated,
                folders,
                material.fresh,
                past,
                self._read,
            )
            result = self._computing.ask_unless(self._is_disturbed, question)
        if result is None:
            self._reasons[patient_id] = LEFT_OFF if material.fresh else NO_TRIALS
            return
        self._read = result.read
        self._reasons.pop(patient_id, None)
        self._newest = AdaptationProposal(
            uuid.uuid4().hex, patient_id, material.trials, material.parameters.hash, result
        )

    def _save(self, session: PatientSession, proposal: str, person: str | None) -> int:
        waiting = self.proposal_for(session.patient_id)
        if waiting is None or waiting.id != proposal or waiting.applied is not None:
            raise NotFound(GONE)
        change = waiting.result.proposal
        if change.parameters is None:
            raise Conflict(change.reason)
        with self._database.transaction() as db:
            if person is None and mode_of(db, session.patient_id) != "auto":
                raise Conflict(SWITCHED)
            if not is_current(db, session.patient_id, waiting.base_hash, waiting.trials):
                raise Conflict(STALE)
            difference = {
                **change.difference,
                "trials": list(waiting.trials),
                "by_itself": person is None,
            }
            row = save_adapted(db, session.patient_id, session.id, change.parameters, difference)
            write_log(
                db,
                person,
                "map adapted",
                patient=session.patient_id,
                version=row.version,
                parent=row.parent,
                felt_change=change.felt_change,
                hash=change.parameters.hash,
            )
        self._newest = replace(waiting, applied=row.version, reason=None)
        return row.version

    def _back(self, session: PatientSession, person: str) -> int:
        with self._database.transaction() as db:
            row = go_back(db, session.patient_id, session.id)
            patient = db.get_one(Patient, session.patient_id)
            if patient.adaptation == "auto":  # otherwise the next trial could apply the same change again
                patient.adaptation = "suggest"
            write_log(
                db,
                person,
                "map taken back",
                patient=patient.id,
                version=row.version,
                parent=row.parent,
                **(row.difference or {}),
            )
        self._newest = None
        self._reasons.pop(session.patient_id, None)
        return row.version

    def _trial(self, trial_id: int) -> tuple[Trial, str]:
        with self._database.reading() as db:
            trial = db.get_one(Trial, trial_id)
            return trial, mode_of(db, trial.patient_id)

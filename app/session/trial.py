"""A trial: the chair on the start, a run, armed, watched to its end, and measured from the recording."""

import asyncio
from dataclasses import dataclass
from functools import partial
from typing import Any

from app.session.recordings import measure_recording, quality_of_recording
from app.session.run_flow import CurrentRun, FlowWords, RunFlow
from app.session.run_watch import Starter
from app.session.runs import SessionRun
from app.session.trial_watch import TrialPlace, TrialWatch
from app.store.control_quality import save_quality
from app.store.log import write_log
from app.store.parameters import as_document, current_parameters
from app.store.runs import add_trial, finish_trial
from app.store.tables import PatientSession, Run, Trial
from app.world.floorplan import FloorPlan, PrescribedPath


@dataclass(frozen=True, slots=True)
class RunningTrial(CurrentRun):
    """The trial that is being driven."""

    watch: TrialWatch
    plan: FloorPlan
    path: PrescribedPath

    @property
    def place(self) -> TrialPlace:
        """Return where the chair is along the path."""
        return self.watch.place


class TrialFlow(RunFlow[RunningTrial]):
    """Starts one trial on the virtual chair at a time and follows it to its measures."""

    words = FlowWords(
        event="trial",
        running="A trial is running: end it first",
        to_start="start a trial",
        not_running="No trial is running: start one first.",
        still_closing="The trial is still being measured: look at it again in a moment.",
    )

    async def start(self, session: PatientSession, who: Starter, plan: FloorPlan, path: PrescribedPath) -> int:
        """Begin a trial and return its id: chair on the start, recording, armed."""
        async with self._alone():
            parameters_id, parameters_hash = await asyncio.to_thread(self._parameters, session.patient_id)
            await self._control.call("world", floorplan=plan.model_dump(mode="json"), path=path.name)
            meta = {"floorplan": plan.name, "path": path.name, "picture": who.picture}
            return await self._arm(
                session.id, meta, parameters_hash, partial(self._add, session, parameters_id, who, plan, path)
            )

    def _parameters(self, patient_id: int) -> tuple[int, str]:
        with self._database.transaction() as db:
            row, profile = current_parameters(db, patient_id)
            # Compute the hash as the control process does: an older program may have stored it with fewer fields.
            return row.id, as_document(row, profile).hash

    def _add(
        self,
        session: PatientSession,
        parameters_id: int,
        who: Starter,
        plan: FloorPlan,
        path: PrescribedPath,
        run: SessionRun,
    ) -> RunningTrial:
        with self._database.transaction() as db:
            trial = add_trial(
                db,
                run=db.get_one(Run, run.id),
                clinic_id=session.clinic_id,
                patient_id=session.patient_id,
                parameters_id=parameters_id,
                floorplan=plan.name,
                floorplan_title=plan.title,
                path=path.name,
                path_points=[[x, y] for x, y in path.points],
            )
            write_log(db, who.name, "armed", trial=trial.id, parameters=parameters_id, picture=who.picture)
            return RunningTrial(trial.id, who.person_id, who.screen, run, TrialWatch(plan, path), plan, path)

    async def _measure(self, current: RunningTrial, figures: dict[str, Any]) -> None:
        folder = current.run.folder
        ask = self._computing.ask
        figures["measures"] = await asyncio.to_thread(ask, measure_recording, folder, current.plan, current.path)
        figures["quality"] = await asyncio.to_thread(ask, quality_of_recording, folder)

    def _delete(self, current_id: int) -> None:
        with self._database.transaction(closing=True) as db:
            db.delete(db.get_one(Trial, current_id))

    def _save(self, current_id: int, end: str, **figures: Any) -> None:
        with self._database.transaction(closing=True) as db:
            finish_trial(db, current_id, end, figures.get("measures"))
            if "quality" in figures:
                save_quality(db, current_id, figures["quality"])
            write_log(db, None, "trial ended", trial=current_id, end=end)

"""The interface test of the open session: a recorded run in which a cursor is moved, and no chair."""

import asyncio
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from app.faults import State
from app.features.interface_tests.service import (
    add_interface_test,
    finish_interface_test,
    measure_interface_test,
    next_number,
)
from app.refusals import Conflict
from app.session.run_flow import CurrentRun, FlowMessages, RunFigures, RunFlow
from app.session.run_watch import Starter
from app.session.runs import SessionRun
from app.store.log import write_log
from app.store.parameters import current_parameters
from app.store.tables import InterfaceTest, InterfaceTestEnding, PatientSession, Run
from app.texts import Text
from app.world.cursor_task import CursorPlan, CursorTask

SILENT = 2.0  # s without a frame of the shirt, after which a test ends: the cursor stands, and nobody made it stand


class InterfaceTestWatch:
    """Follows the ticks of one interface test, in order, and moves the cursor that the screens show."""

    def __init__(self, plan: CursorPlan) -> None:
        self.task = CursorTask(plan)
        self._frame_t: float | None = None

    def update(self, ticks: NDArray[np.void]) -> InterfaceTestEnding | None:
        """Follow the newest ticks (`app.messages.TICK`) of the run; return how it ended, None while it goes on."""
        for tick in ticks:
            t = float(tick["t"])
            if tick["has_frame"] or self._frame_t is None:
                self._frame_t = t
            self.task.step(float(tick["run_t"]), float(tick["u1"]), float(tick["u2"]))
            if self.task.phase == "over":
                return "complete"
            if int(tick["state"]) == State.FAULT:
                return "stopped"
            if t - self._frame_t > SILENT:
                return "fault"
        return None


@dataclass(frozen=True, slots=True)
class RunningInterfaceTest(CurrentRun):
    """The interface test that is going on."""

    watch: InterfaceTestWatch


class InterfaceTestFlow(RunFlow[RunningInterfaceTest]):
    """Starts one interface test at a time and follows it to its measures. The gate stays disarmed."""

    messages = FlowMessages(
        event="test",
        not_running=Text("visit-no-test"),
        still_closing=Text("visit-test-still-measured"),
    )
    plan_of: Callable[[int], CursorPlan] = staticmethod(lambda number: CursorPlan(seed=number))

    async def start(self, session: PatientSession, starter: Starter) -> int:
        """Begin an interface test and return its id; its number decides the order of the targets."""
        tick = self._control.newest()
        if tick is not None and int(tick["state"]) == State.FAULT:
            raise Conflict(Text("tests-stop-in-force"))
        async with self._alone():
            parameters_id, number = await asyncio.to_thread(self._prepared, session.patient_id)
            plan = self.plan_of(number)
            run = await self._runs.begin(session.id, "interface_test", (), {"test": number}, plan)
            return self._go_on(await self._begin(run, partial(self._add, session, parameters_id, starter, plan)))

    def _prepared(self, patient_id: int) -> tuple[int, int]:
        with self._database.reading() as db:
            return current_parameters(db, patient_id)[0].id, next_number(db, patient_id)

    def _add(
        self, session: PatientSession, parameters_id: int, starter: Starter, plan: CursorPlan, run: SessionRun
    ) -> RunningInterfaceTest:
        with self._database.transaction() as db:
            test = add_interface_test(
                db,
                run=db.get_one(Run, run.id),
                session=session,
                parameters_id=parameters_id,
                plan=plan.model_dump(mode="json"),
            )
            write_log(db, starter.name, "test started", test=test.id, parameters=parameters_id)
            watch = InterfaceTestWatch(plan)
            return RunningInterfaceTest(
                test.id, session.patient_id, session.id, starter.person_id, starter.screen, run, watch
            )

    async def _measure(self, current: RunningInterfaceTest, figures: RunFigures) -> None:
        plan, folder = current.watch.task.plan, current.run.folder
        figures["measures"] = await asyncio.to_thread(self._computing.ask, measure_interface_test, folder, plan)

    def _delete(self, current_id: int) -> None:
        with self._database.transaction(closing=True) as db:
            db.delete(db.get_one(InterfaceTest, current_id))

    def _save(self, current_id: int, end: str, figures: RunFigures) -> None:
        with self._database.transaction(closing=True) as db:
            finish_interface_test(db, current_id, end, figures.get("measures"))
            write_log(db, None, "test ended", test=current_id, end=end)

    @property
    def cursor_task(self) -> CursorTask | None:
        """What the screens show of the test that is going on, None when none is."""
        return None if (current := self.current) is None else current.watch.task

"""The state of the flows after a failure."""

import asyncio
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from clinic_rows import rows_in

from app.messages import TICK
from app.news import News
from app.refusals import Conflict, Unavailable
from app.session.calibration.calibration_flow import CalibrationFlow
from app.session.real_drive import RealDriveFlow
from app.session.run_watch import follow_run
from app.session.runs import SessionRuns
from app.session.trial import TrialFlow
from app.source import UNKNOWN_SOURCE
from app.store.database import Database
from app.store.tables import Run
from event_loop import in_event_loop


class FakeControl:
    """A control process that accepts and keeps every command."""

    def __init__(self) -> None:
        self.commands: list[str] = []

    async def call(self, do: str, **_fields: Any) -> dict[str, Any]:
        self.commands.append(do)
        return {"run": 1, "source": UNKNOWN_SOURCE.model_dump(), "rows": 0, "dropped": 0}

    def newest(self) -> Any:
        return None


class LostDatabase:
    """A database that cannot be opened."""

    def transaction(self, **_how: bool) -> Any:
        raise OSError("the database is gone")


def runs_with(control: Any, tmp_path: Any) -> SessionRuns:
    return SessionRuns(LostDatabase(), control, tmp_path, lambda: True)  # type: ignore[arg-type]


def test_a_run_that_cannot_be_noted_is_not_left_running(tmp_path: Any) -> None:
    control = FakeControl()
    with pytest.raises(OSError, match="gone"):
        asyncio.run(runs_with(control, tmp_path).begin(1, "rest", (), {}))
    assert control.commands == ["run", "end_run"]


@pytest.mark.parametrize("refusal", [Unavailable("It did not answer."), Conflict("Nothing is being recorded.")])
@in_event_loop
async def test_a_run_whose_end_nobody_answers_is_open_no_more(database: Database, tmp_path: Any, refusal: Any) -> None:
    """A control process that does not answer is ended (test_control_link.py), and so records no more."""
    with rows_in(database) as rows:
        session = rows.open_session()

    class SilentControl(FakeControl):
        async def call(self, do: str, **fields: Any) -> dict[str, Any]:
            if do == "end_run":
                raise refusal
            return await super().call(do, **fields)

    runs = SessionRuns(database, SilentControl(), tmp_path, lambda: True)  # type: ignore[arg-type]
    first = await runs.begin(session.id, "rest", (), {})
    assert await runs.end() == first
    assert runs.open is None
    assert (await runs.begin(session.id, "rest", (), {})).id != first.id
    with database.transaction() as db:
        assert [run.ended is not None for run in db.query(Run).order_by(Run.started)] == [True, False]


@pytest.mark.parametrize(
    ("numbers", "first"),
    [((20_000, 20_003), 20_000), ((20_000, 3), 3), ((None, 4), 0)],
    ids=["goes on", "new", "first"],
)
def test_a_run_is_followed_from_its_beginning_and_no_tick_before_it_is_read(
    database: Database, tmp_path: Any, numbers: tuple[int | None, int], first: int
) -> None:
    """A control process that was replaced meanwhile numbers its ticks anew."""
    with rows_in(database) as rows:
        session = rows.open_session()
    asked: list[int] = []

    class Ticking(FakeControl):
        def newest(self) -> Any:
            number = numbers["run" in self.commands]
            return None if number is None else {"number": number}

        def since(self, number: int) -> Any:
            asked.append(number)
            ticks = np.zeros(1, TICK)
            ticks["run"] = 1
            return ticks

    async def story() -> str | None:
        control: Any = Ticking()
        run = await SessionRuns(database, control, tmp_path, lambda: True).begin(session.id, "drive", (), {})
        return await follow_run(control, run, asyncio.Event(), lambda ticks: "seen" if len(ticks) else None)

    assert asyncio.run(story()) == "seen"
    assert asked == [first]


@pytest.mark.parametrize(
    ("kind", "news"),
    [
        (RealDriveFlow, News(what="drive", patient=2, session=3)),
        (TrialFlow, News(what="trial", patient=2, session=3, trial=1)),
    ],
)
@in_event_loop
async def test_a_run_is_over_though_the_database_is_gone(tmp_path: Any, kind: Any, news: News) -> None:
    told: list[News] = []
    flow = kind(LostDatabase(), FakeControl(), runs_with(FakeControl(), tmp_path), told.append, None)
    flow.current = SimpleNamespace(id=1, patient_id=2, session_id=3, run=None, path=None)
    with pytest.raises(OSError, match="gone"):
        await flow._finish(flow.current, "fault")
    assert not flow.running
    assert told == [news]


@in_event_loop
async def test_a_trial_is_being_measured_from_when_its_end_is_asked_for_until_it_is_over(tmp_path: Any) -> None:
    flow = TrialFlow(LostDatabase(), FakeControl(), runs_with(FakeControl(), tmp_path), [].append, None)  # type: ignore[arg-type]
    seen: list[bool] = []

    class Closing(SessionRuns):
        async def end(self) -> Any:
            seen.append(flow.measuring)
            return await super().end()

    flow._runs = Closing(LostDatabase(), FakeControl(), tmp_path, lambda: True)  # type: ignore[arg-type]
    for asked in (False, True):
        flow._end_asked.clear()
        current: Any = SimpleNamespace(id=1, patient_id=2, session_id=3, run=None, path=None)
        flow.current = current
        flow._task = asyncio.create_task(asyncio.sleep(0))
        seen.append(flow.measuring)
        if asked:
            await flow.end()
            seen.append(flow.measuring)
        with pytest.raises(OSError, match="gone"):
            await flow._finish(current, "by hand")
        seen.append(flow.measuring)
    assert seen == [False, True, False, False, True, True, False]


def test_a_calibration_step_that_cannot_begin_leaves_another_run_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    ended: list[bool] = []

    class Busy:
        async def begin(self, *_given: Any) -> None:
            raise Conflict("Something is being recorded already.")

        async def end(self) -> None:
            ended.append(True)

    shirt = SimpleNamespace(needed_layout=lambda: None)
    flow = CalibrationFlow(None, None, shirt, Busy(), print, None, None, demonstration=False)  # type: ignore[arg-type]
    step = SimpleNamespace(id="rest", kind="rest", cues=())

    async def progress(_session: int) -> Any:
        return SimpleNamespace(layout=None, step=lambda _id: step)

    monkeypatch.setattr(flow, "progress", progress)
    with pytest.raises(Conflict):
        asyncio.run(flow.start(1, "rest"))
    assert not ended
    assert not flow.running

"""What the flows leave behind when something fails on the way."""

import asyncio
from types import SimpleNamespace
from typing import Any

import pytest

from app.refusals import Conflict, Unavailable
from app.session.calibration import CalibrationFlow
from app.session.real_drive import RealDriveFlow
from app.session.runs import Runs
from app.session.trial import TrialFlow
from app.source import UNKNOWN_SOURCE
from app.store.database import Database
from app.store.patients import add_patient, start_session
from app.store.people import add_clinic
from app.store.tables import Run


class Asked:
    """A control process that does what it is told, and remembers it."""

    def __init__(self) -> None:
        self.asked: list[str] = []

    async def call(self, do: str, **_fields: Any) -> dict[str, Any]:
        self.asked.append(do)
        return {"run": 1, "source": UNKNOWN_SOURCE.model_dump(), "rows": 0, "dropped": 0}


class Gone:
    """A database that is gone."""

    def transaction(self, **_how: bool) -> Any:
        raise OSError("the database is gone")


def runs_with(control: Any, tmp_path: Any) -> Runs:
    return Runs(Gone(), control, tmp_path)  # type: ignore[arg-type]


def test_a_run_that_cannot_be_noted_is_not_left_running(tmp_path: Any) -> None:
    control = Asked()
    with pytest.raises(OSError, match="gone"):
        asyncio.run(runs_with(control, tmp_path).begin(1, "rest", (), {}))
    assert control.asked == ["run", "end_run"]


@pytest.mark.parametrize("refusal", [Unavailable("It did not answer."), Conflict("Nothing is being recorded.")])
def test_a_run_whose_end_nobody_answers_is_open_no_more(database: Database, tmp_path: Any, refusal: Exception) -> None:
    """The control process that owes the answer is ended by then (test_control_link.py) and records no more."""
    with database.transaction() as db:
        clinic = add_clinic(db, "Clinic")
        patient = add_patient(db, clinic.id, "P-1", "Heron", "")
        session = start_session(db, clinic.id, patient.id)

    class Owing(Asked):
        async def call(self, do: str, **fields: Any) -> dict[str, Any]:
            if do == "end_run":
                raise refusal
            return await super().call(do, **fields)

    async def story() -> None:
        runs = Runs(database, Owing(), tmp_path)  # type: ignore[arg-type]
        first = await runs.begin(session.id, "rest", (), {})
        assert await runs.end() == first
        assert runs.open is None
        assert (await runs.begin(session.id, "rest", (), {})).id != first.id

    asyncio.run(story())
    with database.transaction() as db:
        ended = [run.ended is not None for run in db.query(Run).order_by(Run.started)]
    assert ended == [True, False]


def test_a_drive_is_over_though_the_database_is_gone(tmp_path: Any) -> None:
    told: list[str] = []
    flow = RealDriveFlow(Gone(), Asked(), runs_with(Asked(), tmp_path), told.append, None)  # type: ignore[arg-type]
    flow.current = SimpleNamespace(id=1, run=None)  # type: ignore[assignment]

    async def story() -> None:
        with pytest.raises(OSError, match="gone"):
            await flow._finish(flow.current, "fault")  # type: ignore[arg-type]

    asyncio.run(story())
    assert not flow.running
    assert told == ["drive"]


def test_a_trial_is_over_though_the_database_is_gone(tmp_path: Any) -> None:
    control, told = Asked(), []
    flow = TrialFlow(Gone(), control, runs_with(control, tmp_path), told.append, None)  # type: ignore[arg-type]
    flow.current = SimpleNamespace(id=1, run=None, path=None)  # type: ignore[assignment]

    async def story() -> None:
        with pytest.raises(OSError, match="gone"):
            await flow._finish(flow.current, "fault")  # type: ignore[arg-type]

    asyncio.run(story())
    assert not flow.running
    assert told == ["trial"]


def test_a_calibration_step_that_cannot_begin_leaves_another_run_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    ended: list[bool] = []

    class Busy:
        async def begin(self, *_given: Any) -> None:
            raise Conflict("Something is being recorded already.")

        async def end(self) -> None:
            ended.append(True)

    shirt = SimpleNamespace(needed_layout=lambda: None)
    flow = CalibrationFlow(None, None, shirt, Busy(), print, None)  # type: ignore[arg-type]
    step = SimpleNamespace(id="rest", kind="rest", cues=())

    async def progress(_session: int) -> Any:
        return SimpleNamespace(layout=None, steps=(step,))

    monkeypatch.setattr(flow, "progress", progress)
    with pytest.raises(Conflict):
        asyncio.run(flow.start(1, "rest"))
    assert not ended
    assert not flow.running

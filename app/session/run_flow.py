"""The course of a trial, a drive or an interface test: recorded, watched to its end, closed and measured."""

import asyncio
from abc import ABC, abstractmethod
from collections.abc import AsyncIterator, Callable, Mapping
from contextlib import asynccontextmanager, suppress
from dataclasses import dataclass
from typing import ClassVar, Generic, Literal, NamedTuple, Protocol, TypedDict, TypeVar

import numpy as np
from numpy.typing import NDArray

from app.computing_process import ComputingProcess
from app.json_values import JsonDocument
from app.news import News, Notify
from app.refusals import Conflict, Unavailable
from app.scoring.control_quality import ControlQuality
from app.session.control_link import ControlLink
from app.session.run_watch import RunLost, follow_run
from app.session.runs import SessionRun, SessionRuns
from app.store.database import Database
from app.texts import Text
from app.world.cursor_task import CursorTask

STOP_LIMIT = 1.5  # s for closing a run when the application ends; then it stays without figures
END_LIMIT = 30.0  # s for closing and measuring a run, before a caller is told to look later


class Watch(Protocol):
    """Watches the ticks of a run."""

    def update(self, ticks: NDArray[np.void]) -> str | None:
        """Follow the newest ticks of the run; return how it ended, None while it goes on."""
        ...


@dataclass(frozen=True, slots=True)
class CurrentRun:
    """A trial, a drive or an interface test that is going on."""

    id: int
    patient_id: int
    session_id: int
    person_id: int  # of the person who started it
    screen: str  # the random word of the screen that started it, which must stay in view of a trial or drive
    run: SessionRun
    watch: Watch


Current = TypeVar("Current", bound=CurrentRun)


class RunEnd(NamedTuple):
    """What ended last, and how."""

    id: int
    end: str


class RunFigures(TypedDict, total=False):
    """What was read from the closed recording of a run; a figure that could not be read is missing."""

    measures: JsonDocument  # of a trial or an interface test
    quality: ControlQuality  # of a trial
    distance: float  # m, of a drive


class FlowMessages(NamedTuple):
    """The messages of a flow, and the news that pages get of it."""

    event: Literal["trial", "drive", "test"]  # also chooses the sentences "visit-busy" and "visit-already-recorded"
    not_running: Text
    still_closing: Text


class RunFlow(ABC, Generic[Current]):
    """Starts one trial, drive or other run at a time and follows it to its end."""

    messages: ClassVar[FlowMessages]

    def __init__(
        self,
        database: Database,
        control: ControlLink,
        runs: SessionRuns,
        notify: Notify,
        computing: ComputingProcess,
    ) -> None:
        self._database = database
        self._control = control
        self._runs = runs
        self._notify = notify
        self._computing = computing
        self._task: asyncio.Task[None] | None = None
        self._end_asked = asyncio.Event()
        self._starting = self._finishing = False
        self.current: Current | None = None
        self.last_end: RunEnd | None = None  # since the program was started
        self._listeners: list[Callable[[int], None]] = []

    @property
    def running(self) -> bool:
        """Whether one is being started, driven or measured."""
        return self._starting or self.current is not None

    @property
    def measuring(self) -> bool:
        """Whether what ran is over, by itself or because its end was asked for, and is being closed and measured."""
        return self.current is not None and (self._finishing or self._end_asked.is_set())

    @property
    def cursor_task(self) -> CursorTask | None:
        """What the screens show of a run in which a cursor is moved and not the chair, None otherwise."""
        return None

    def when_finished(self, notify: Callable[[int], None]) -> None:
        """Call `notify` with the id of each run that has ended, after it is closed and measured."""
        self._listeners.append(notify)

    async def end(self) -> int:
        """End what runs by hand, and return its id when it is closed and measured."""
        current, task = self.current, self._task
        if current is None or task is None:
            raise Conflict(self.messages.not_running)
        self._end_asked.set()
        try:
            await asyncio.wait_for(asyncio.shield(task), END_LIMIT)
        except TimeoutError as late:
            raise Conflict(self.messages.still_closing) from late
        return current.id

    async def stop(self) -> None:
        """End what runs because the application ends."""
        if self._task is not None:
            self._end_asked.set()
            await asyncio.wait([self._task], timeout=STOP_LIMIT)
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)

    @asynccontextmanager
    async def _alone(self) -> AsyncIterator[None]:
        """Refuse to start beside another recording, and let no other start meanwhile."""
        if self.running or self._runs.open is not None:
            raise Conflict(Text("visit-already-recorded", start=self.messages.event))
        self._starting = True
        try:
            await asyncio.to_thread(self._computing.begin)
            yield
        finally:
            self._starting = False

    async def _arm(
        self, session_id: int, meta: Mapping[str, object], parameters_hash: str, add: Callable[[SessionRun], Current]
    ) -> int:
        """Begin the recording, store the trial or drive by `add`, and arm the chair; return the id."""
        current = await self._begin(await self._runs.begin(session_id, "drive", (), meta), add)
        try:
            await self._control.call("arm", hash=parameters_hash)
        except BaseException:
            # It never began: the recording stays, the trial or drive is deleted.
            self.current = None
            await self._runs.end()
            await asyncio.to_thread(self._delete, current.id)
            raise
        return self._go_on(current)

    async def _begin(self, run: SessionRun, add: Callable[[SessionRun], Current]) -> Current:
        """Store what is recorded in `run` by `add`; end the recording when it cannot be stored."""
        try:
            current = await asyncio.to_thread(add, run)
        except BaseException:
            await self._runs.end()
            raise
        self._end_asked.clear()
        self.current = current
        return current

    def _go_on(self, current: Current) -> int:
        """Follow what has begun to its end, in a task of its own; return its id."""
        self._task = asyncio.create_task(self._follow(current))
        self._notify(self._news_of(current))
        return current.id

    async def _follow(self, current: Current) -> None:
        end = "fault"  # also when watching fails: nothing is left open
        try:
            with suppress(RunLost):
                end = await follow_run(self._control, current.run, self._end_asked, current.watch.update) or "by hand"
            self.last_end = RunEnd(current.id, end)
        finally:
            await self._finish(current, end)

    async def _finish(self, current: Current, end: str) -> None:
        figures = RunFigures()
        self._finishing = True
        try:
            await self._runs.end()
            await self._measure(current, figures)
        except (ValueError, OSError, Unavailable):
            pass  # too short to measure, or a recording that was cut: it stays without those figures
        finally:
            try:
                await asyncio.to_thread(self._save, current.id, end, figures)
            finally:  # also when the database is gone: it is over
                self.current, self._finishing = None, False
                self._notify(self._news_of(current))
        for notify in self._listeners:
            notify(current.id)

    def _news_of(self, current: Current) -> News:
        what = self.messages.event
        trial = current.id if what == "trial" else None
        return News(what=what, patient=current.patient_id, session=current.session_id, trial=trial)

    @abstractmethod
    async def _measure(self, current: Current, figures: RunFigures) -> None:
        """Read the figures for `_save` from the closed recording, one by one: those before an error are kept."""

    @abstractmethod
    def _delete(self, current_id: int) -> None:
        """Delete the trial or drive that was not armed."""

    @abstractmethod
    def _save(self, current_id: int, end: str, figures: RunFigures) -> None:
        """Store how the trial or drive ended, with its figures."""

"""The control link: commands to the control process, its ticks, the heartbeat, and a new process when it dies."""

import asyncio
import logging
import threading
from collections.abc import Awaitable, Callable, Coroutine
from contextlib import suppress
from typing import Literal, NamedTuple, Protocol, TypeVar, get_args

import numpy as np
from numpy.typing import NDArray

from app.clock import monotonic
from app.messages import IDLE_RATE
from app.process.command_channel import LinkLost, LinkRefused, Message
from app.refusals import Conflict, Unavailable
from app.texts import Text, text_of

Answer = TypeVar("Answer")


class LoopThread:
    """Runs coroutines in the event loop of a thread of its own, so that no request delays them."""

    def __init__(self, name: str) -> None:
        self._loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self._run, name=name, daemon=True)
        self._thread.start()

    async def run(self, coroutine: Coroutine[object, None, Answer]) -> Answer:
        """Run a coroutine in the thread's loop, and return its result to the caller's loop."""
        return await asyncio.wrap_future(asyncio.run_coroutine_threadsafe(coroutine, self._loop))

    def begin(self, coroutine: Coroutine[object, None, None]) -> None:
        """Run a coroutine in the thread's loop until `close`."""
        asyncio.run_coroutine_threadsafe(coroutine, self._loop)

    def soon(self, function: Callable[[], None]) -> None:
        """Call a function in the thread's loop as soon as possible."""
        self._loop.call_soon_threadsafe(function)

    async def close(self) -> None:
        """Cancel all tasks of the thread's loop, and end the thread."""
        await self.run(_cancel_others())
        self._loop.call_soon_threadsafe(self._loop.stop)
        await asyncio.to_thread(self._thread.join)
        self._loop.close()

    def _run(self) -> None:
        asyncio.set_event_loop(self._loop)
        self._loop.run_forever()


logger = logging.getLogger("bodydrive")

HEARTBEAT_EVERY = 0.1  # s; the control process stops the chair after 0.3 s of silence
STOP_LIMIT = 0.4  # s until a stop is answered, also when the control process does not answer
WATCH_EVERY = 0.25  # s
HANG_LIMIT = 2.0  # s without a tick, after which the process is replaced: its chair has stopped long before
OPENING_LIMIT = 12.0  # s without a tick during an opening command; longer than its answer is waited for
OPENING = frozenset({"chair", "shirt", "body", "head", "parameters", "world", "run"})  # refused while it may move
START_AGAIN_AFTER = 0.5  # s; doubled with each start that fails, up to ...
LONGEST_PAUSE = 8.0  # s

ControlState = Literal["alive", "starting", "lost"]
StopReason = Literal["tablet", "key", "picture"]
LoadCommand = Literal["limits", "dial", "chair", "shirt", "body", "head", "parameters"]


class ScreenSign(NamedTuple):
    """The last report of the screen that drives."""

    age: float | None = None  # s since the report; None: no screen drives, or its socket has ended
    view: Literal["in view", "hidden", "slow"] = "in view"


class LinkedProcess(Protocol):
    """One running control process, as the control link uses it."""

    async def call(self, do: str, **fields: object) -> Message:
        """Send a command and return its answer; raise LinkRefused or LinkLost."""
        ...

    def send(self, do: str, **fields: object) -> None:
        """Send a command that gets no answer."""
        ...

    def newest(self) -> np.void | None:
        """Return the newest tick, None before the first."""
        ...

    def since(self, number: int) -> NDArray[np.void]:
        """Return the ticks after `number`, as many as the ring still holds."""
        ...

    async def died(self) -> None:
        """Return when the process has ended."""
        ...

    def kill(self) -> None:
        """Kill the process at once."""
        ...

    async def close(self) -> None:
        """End the process and release its resources."""
        ...


class ControlLink:
    """Keeps one control process running: starts it, replaces it when it dies or hangs, repeats its load commands."""

    def __init__(self, start_process: Callable[[], Awaitable[LinkedProcess]]) -> None:
        self.state: ControlState = "starting"
        self._screen_sign: Callable[[], ScreenSign] = ScreenSign  # without a screen, nothing moves
        self.on_change: list[Callable[[ControlState], Awaitable[None]]] = []
        self._start_process = start_process
        self._process: LinkedProcess | None = None
        self._loaded: dict[str, dict[str, object]] = {}  # commands that a new control process is given again
        self._opening = 0  # opening commands under way: they may delay the loop
        self._pending_stops: set[asyncio.Task[Message]] = (
            set()
        )  # referred to here: asyncio itself refers to tasks weakly
        self._supervision: asyncio.Task[None] | None = None
        # The link has a thread of its own, so that a long request does not delay the heartbeat. When the event loop of
        # the requests hangs, the screens' reports are no longer read, and their age stops the chair.
        self._thread: LoopThread | None = None
        self._reading = threading.Lock()  # the 3D view reads ticks in a thread of its own; not while they are unmapped

    async def start(self) -> None:
        """Start the control process."""
        self._thread = LoopThread("control link")
        try:
            await self._open(self._thread)
        except BaseException:
            await self._thread.close()
            raise
        self._thread.begin(self._heartbeat())
        self._thread.begin(self._watch())
        self._supervision = asyncio.create_task(self._supervise(self._thread))

    async def close(self) -> None:
        """End the control process and start no other."""
        if self._supervision is None or self._thread is None:
            return
        self._supervision.cancel()
        await asyncio.gather(self._supervision, return_exceptions=True)
        await self._release(self._thread)
        await self._thread.close()
        self._supervision = self._thread = None
        self.state = "lost"

    async def call(self, do: str, **fields: object) -> Message:
        """Send a command and return its answer.

        Raises
        ------
        Conflict
            With the control process's own sentence, when it refuses.
        Unavailable
            When there is no control process at the moment.
        """
        process = self._process
        opening = do in OPENING
        if process is None or self._thread is None or self.state != "alive":
            raise Unavailable(Text("drives-process-restarting"))
        self._opening += opening
        try:
            return await self._thread.run(process.call(do, **fields))
        except LinkRefused as refusal:
            raise Conflict(text_of(refusal)) from refusal
        except LinkLost as lost:
            # It might still execute the command later, and begin a run without a row in the database.
            process.kill()
            raise Unavailable(Text("drives-process-no-answer")) from lost
        finally:
            self._opening -= opening

    async def stop(self, by: StopReason = "tablet") -> bool:
        """Stop the chair; return within STOP_LIMIT whether the control process confirmed it; if not, it is replaced."""
        stopping = self.begin_stop(by)
        await asyncio.wait({stopping}, timeout=STOP_LIMIT)
        return stopping.done() and not stopping.cancelled() and stopping.exception() is None

    def begin_stop(self, by: StopReason) -> "asyncio.Task[Message]":
        """Send a stop without waiting for its answer; the returned task need not be awaited."""
        stopping = asyncio.create_task(self.call("stop", by=by))
        self._pending_stops.add(stopping)
        stopping.add_done_callback(self._stopped)
        return stopping

    def _stopped(self, stopping: "asyncio.Task[Message]") -> None:
        self._pending_stops.discard(stopping)
        if not stopping.cancelled():
            stopping.exception()  # mark as retrieved: perhaps nobody awaits the task

    async def load(self, do: LoadCommand, **fields: object) -> Message:
        """Send a command that a new control process is given again, and return its answer."""
        answer = await self.call(do, **fields)
        self._loaded[do] = fields
        return answer

    def forget(self, do: LoadCommand) -> None:
        """Do not give a new control process this command again."""
        self._loaded.pop(do, None)

    def move(self, joints: dict[str, float]) -> None:
        """Set the target of each joint of the simulated body (0 to 1) that a person moves on the screen."""
        if self._thread is not None:
            self._thread.soon(lambda: self._send("move", joints=joints))

    def look(self, yaw: float, pitch: float, roll: float) -> None:
        """Report the direction (rad) of the tablet that is used as the head tracker."""
        if self._thread is not None:
            self._thread.soon(lambda: self._send("look", yaw=yaw, pitch=pitch, roll=roll))

    def add_sample(self, page: int, message: bytes, received: float) -> None:
        """Pass on what the page that is the shirt's sensor sent; it came at `received` (monotonic s)."""
        if self._thread is not None:
            self._thread.soon(lambda: self._send("sample", page=page, message=message.hex(), received=received))

    def follow_screen(self, sign: Callable[[], ScreenSign]) -> None:
        """Take the last report of the screen that drives from `sign`, which is called from any thread."""
        self._screen_sign = sign

    def beat(self) -> None:
        """Send a heartbeat at once, because the screen that drives is out of view: the chair must stop now."""
        if self._thread is not None:
            self._thread.soon(self._beat)

    def _beat(self) -> None:
        sign = self._screen_sign()
        self._send("heartbeat", screen_age=sign.age, screen=sign.view)

    def _send(self, do: str, **fields: object) -> None:
        process = self._process
        if process is not None:
            with suppress(LinkLost):
                process.send(do, **fields)

    def newest(self) -> np.void | None:
        """Return the newest tick, None when there is none; may be called from any thread."""
        with self._reading:
            return self._process.newest() if self._process is not None and self.state == "alive" else None

    def since(self, number: int) -> NDArray[np.void] | None:
        """Return the ticks after `number`, None when there is no control process."""
        with self._reading:
            return self._process.since(number) if self._process is not None and self.state == "alive" else None

    def newest_frames(self, channels: int, sample_rate: float, seconds: float) -> NDArray[np.float64]:
        """Return the shirt's frames (n, channels) of the last `seconds`, as many as the ring of ticks still holds.

        `sample_rate` (Hz) is the shirt's. Without a control process n is 0. May be called from any thread.
        """
        newest = self.newest()
        ticks = None
        if newest is not None:
            ticks = self.since(max(0, int(newest["number"]) - int(2 * seconds * max(sample_rate, IDLE_RATE))))
        if newest is None or ticks is None:
            return np.empty((0, channels))
        recent = ticks[(ticks["has_frame"] == 1) & (ticks["t"] > float(newest["t"]) - seconds)]
        return np.asarray(recent["values"][:, :channels], dtype=np.float64)

    async def _release(self, thread: LoopThread) -> None:
        with self._reading:
            process, self._process = self._process, None
        if process is not None:
            await thread.run(process.close())

    async def _open(self, thread: LoopThread) -> None:
        self._process = await thread.run(_opened(self._start_process))
        for do in get_args(LoadCommand):
            if do in self._loaded:
                # A device that cannot be opened again is reported by `status`; the others are opened.
                with suppress(LinkRefused):
                    await thread.run(self._process.call(do, **self._loaded[do]))
        self.state = "alive"

    async def _heartbeat(self) -> None:
        deadline = monotonic()
        while True:
            deadline = max(deadline + HEARTBEAT_EVERY, monotonic())
            self._beat()
            await asyncio.sleep(max(deadline - monotonic(), 0.0))

    async def _watch(self) -> None:
        """Kill a control process whose loop hangs: it might go on driving the chair later."""
        watched, since = self._process, monotonic()
        while True:
            await asyncio.sleep(WATCH_EVERY)
            process, now = self._process, monotonic()
            if process is not watched or process is None or self.state != "alive":
                watched, since = process, now
                continue
            tick = process.newest()
            last = since if tick is None else max(since, float(tick["t"]))
            if monotonic() - last > (OPENING_LIMIT if self._opening else HANG_LIMIT):
                logger.error("The control process stood still for %g s and is replaced", monotonic() - last)
                process.kill()
                watched = None

    async def _supervise(self, thread: LoopThread) -> None:
        while True:
            if self._process is not None:
                await thread.run(self._process.died())
                self.state = "lost"
                await self._notify_change()
                await self._release(thread)
            self.state = "starting"
            await self._start_again(thread)
            await self._notify_change()

    async def _start_again(self, thread: LoopThread) -> None:
        pause = START_AGAIN_AFTER
        while True:
            await asyncio.sleep(pause)
            try:
                await self._open(thread)
            except (LinkLost, OSError):
                await self._release(thread)
                pause = min(2 * pause, LONGEST_PAUSE)
            else:
                return

    async def _notify_change(self) -> None:
        for callback in self.on_change:
            await callback(self.state)


async def _opened(start_process: Callable[[], Awaitable[LinkedProcess]]) -> LinkedProcess:
    return await start_process()


async def _cancel_others() -> None:
    others = [task for task in asyncio.all_tasks() if task is not asyncio.current_task()]
    for task in others:
        task.cancel()
    await asyncio.gather(*others, return_exceptions=True)

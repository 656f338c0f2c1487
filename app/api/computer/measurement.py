"""Measures what this computer grants, by `bodydrive check` in a process of its own: page and command say the same."""

import asyncio
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Final

from pydantic import ValidationError

from app.api.answers import Answer
from app.child_process import ChildEndedError, JsonChild
from app.host.machine_check import Verdict
from app.refusals import Conflict, Unavailable
from app.texts import Text, current_language

CHECK_EVERY: Final = 0.05  # s between two checks whether a chair is armed
START_LIMIT: Final = 30.0  # s for the process to start, beside the time that it measures

BUSY = Text("api-measuring-while-busy")
INTERRUPTED = Text("api-measuring-interrupted")
UNDER_WAY = Text("api-measuring-already")
FAILED = Text("api-measuring-failed")


class FindingView(Answer):
    """What one measurement found, in words."""

    verdict: Verdict
    message: Text


class MachineView(FindingView):
    """Whether this computer will do, and why."""

    findings: list[FindingView]


class Measurement:
    """Measures once at a time, and never while `is_busy`: then a chair may be armed."""

    def __init__(self, folder: Path, is_busy: Callable[[], bool]) -> None:
        self._folder = folder
        self._is_busy = is_busy
        self._alone = asyncio.Lock()

    def refuse_while_busy(self) -> None:
        """Raise Conflict while a chair is armed, something is recorded, or another measurement is under way."""
        if self._is_busy():
            raise Conflict(BUSY)
        if self._alone.locked():
            raise Conflict(UNDER_WAY)

    async def measure(self, seconds: int, own_ports: Sequence[int]) -> MachineView:
        """Measure for `seconds`; `own_ports` are those of the clinic that runs.

        Raises
        ------
        Conflict
            In one sentence, as `refuse_while_busy` does; also when a chair is armed or a recording begins meanwhile.
        Unavailable
            In one sentence, when the process could not measure.
        """
        self.refuse_while_busy()
        async with self._alone:
            ports = [word for port in own_ports for word in ("--own-port", str(port))]
            arguments = ["check", "--json", "--seconds", str(seconds), "--state", str(self._folder), *ports]
            try:
                child = await JsonChild.start("app.cli.main", *arguments, language=current_language())
            except OSError as error:
                raise Unavailable(FAILED) from error
            return await self._answer(child, seconds + START_LIMIT)

    async def _answer(self, child: JsonChild, limit: float) -> MachineView:
        """Return the child's findings; end it when a chair is armed meanwhile, or when nobody waits any more."""
        reading = asyncio.create_task(child.receive())
        try:
            async with asyncio.timeout(limit):
                while not reading.done():
                    if self._is_busy():
                        raise Conflict(INTERRUPTED)
                    await asyncio.wait([reading], timeout=CHECK_EVERY)
            return MachineView.model_validate(await reading)
        except (TimeoutError, ChildEndedError, ValidationError) as error:
            raise Unavailable(FAILED) from error
        finally:
            await child.end()
            await asyncio.gather(reading, return_exceptions=True)

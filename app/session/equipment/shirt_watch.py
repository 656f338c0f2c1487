"""Watches the shirt in use, so that open pages follow it."""

import asyncio

from app.session.equipment.shirt import Equipment

WATCH_EVERY = 0.5  # s: a page shows within 2 s that the shirt has fallen silent, or sends again


class ShirtWatch:
    """Reads the state of the shirt twice a second."""

    def __init__(self, equipment: Equipment) -> None:
        self._equipment = equipment
        self._task: asyncio.Task[None] | None = None

    def start(self) -> None:
        """Begin to watch."""
        self._task = asyncio.create_task(self._watch())

    async def close(self) -> None:
        """Stop watching."""
        if self._task is not None:
            self._task.cancel()
            await asyncio.gather(self._task, return_exceptions=True)

    async def _watch(self) -> None:
        while True:
            await asyncio.sleep(WATCH_EVERY)
            await self._equipment.refresh()

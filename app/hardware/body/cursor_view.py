"""What the simulated body sees of an interface test."""

from typing import NamedTuple, Self

from app.world.cursor_task import CursorTask


class CursorView(NamedTuple):
    """The cursor and the target of an interface test; lengths in arms of the cross."""

    place: tuple[float, float]  # ahead, left
    target: tuple[float, float] | None  # None: none is shown yet, or no longer
    radius: float  # of the target
    missed: int  # targets so far, after each of which the cursor was put into the middle

    @classmethod
    def of(cls, task: CursorTask) -> Self:
        """Return what is seen of a task."""
        target = task.target
        place = None if target is None else (target.ahead, target.left)
        return cls((task.ahead, task.left), place, task.plan.width / 2.0, len(task.attempts) - task.acquired)

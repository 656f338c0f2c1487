"""The state of the calibration of one session, for the page that shows it."""

from dataclasses import dataclass
from datetime import datetime
from typing import NamedTuple

from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step
from app.layout import ShirtLayout
from app.refusals import NotFound
from app.texts import Text

OVER = ("done", "skipped")  # statuses of a finished step


class EarlierCalibration(NamedTuple):
    """The version of the patient's map that drives until this session's calibration is accepted."""

    version: int
    created: datetime


@dataclass(frozen=True, slots=True)
class Progress:
    """The state of the calibration of one session."""

    layout: ShirtLayout | None
    steps: tuple[Step, ...]
    current: str
    status: dict[str, tuple[str, Text | str]]  # step -> (status, message)
    running: str | None
    started_run: int | None
    profile: CalibrationProfile | None
    accepted: bool
    others: int  # other people who are known in this shirt; 0: too few to drive by
    earlier: EarlierCalibration | None  # one in the same kind of shirt; None once this session has a result
    short: bool | None  # whether it is the short calibration; None: this shirt has none

    def step(self, step_id: str) -> Step:
        """Return a step; NotFound when there is none."""
        for step in self.steps:
            if step.id == step_id:
                return step
        raise NotFound(Text("visit-no-step", step=step_id))

    @property
    def missing(self) -> tuple[str, ...]:
        """The steps that are not finished, in their order."""
        return tuple(step.id for step in self.steps if self.status[step.id][0] not in OVER)

    @property
    def may_drive_now(self) -> bool:
        """Whether rest and free movement are done, and other people can stand in for the prompted movements."""
        return self.others > 0 and self._moved_freely

    @property
    def may_fit_earlier(self) -> bool:
        """Whether rest and free movement are done, and an earlier calibration can be fitted to them."""
        return self.earlier is not None and self._moved_freely

    @property
    def _moved_freely(self) -> bool:
        return all(self.status[step.id][0] == "done" for step in self.steps if step.kind != "prompt")

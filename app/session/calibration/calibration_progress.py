"""The state of the calibration of one session, for the page that shows it."""

from dataclasses import dataclass

from app.calibration.profile import CalibrationProfile
from app.calibration.script import Step
from app.layout import ShirtLayout


@dataclass(frozen=True, slots=True)
class Progress:
    """The state of the calibration of one session."""

    layout: ShirtLayout | None
    steps: tuple[Step, ...]
    current: str
    status: dict[str, tuple[str, str]]  # step -> (status, words)
    running: str | None
    started_run: int | None
    profile: CalibrationProfile | None
    accepted: bool
    others: int  # other people who are known in this shirt; 0: too few to drive by

    @property
    def may_drive_now(self) -> bool:
        """Whether rest and free movement are done, and other people can stand in for the prompted movements."""
        needed = [step.id for step in self.steps if step.kind != "prompt"]
        return self.others > 0 and all(self.status[step][0] == "done" for step in needed)

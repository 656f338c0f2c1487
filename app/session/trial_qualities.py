"""The control quality of trials: from the database, or read once from the recording and stored."""

from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from app.computing_process import ComputingProcess
from app.refusals import DiskFull
from app.scoring.control_quality import ControlQuality
from app.scoring.trial_assessment import TrialAssessment
from app.session.recordings import quality_of_recording
from app.store.control_quality import save_quality, sessions_and_versions, stored_qualities
from app.store.database import Database
from app.store.tables import Trial


class TrialQualities:
    """Returns the control quality of ended trials, and stores what it had to read from a recording."""

    def __init__(self, database: Database, folder_of: Callable[[str], Path], computing: ComputingProcess) -> None:
        self._database = database
        self._folder_of = folder_of
        self._computing = computing
        self._unreadable: set[int] = set()  # trials whose recording cannot be read; tried once per start of the program

    def of(self, trial: Trial) -> ControlQuality | None:
        """Return how well a trial was controlled; None while it runs or when its recording cannot be read."""
        with self._database.reading() as db:
            stored = stored_qualities(db, [trial.id])
        return stored.get(trial.id) or self._measure(trial)

    def assessments(self, trials: list[Trial]) -> list[TrialAssessment]:
        """Return the assessments of the kept trials whose recording can be read, in the order driven."""
        kept_trials = {trial.id: trial for trial in trials if trial.kept}
        with self._database.reading() as db:
            stored = stored_qualities(db, kept_trials)
            places = sessions_and_versions(db, kept_trials)
        assessments = []
        for trial_id, trial in kept_trials.items():
            quality = stored.get(trial_id) or self._measure(trial)
            if quality is not None:
                task = f"{trial.floorplan}/{trial.path}"
                assessments.append(TrialAssessment(trial_id, trial.number, *places[trial_id], task, quality))
        return assessments

    def _measure(self, trial: Trial) -> ControlQuality | None:
        """Return the quality as measured from the recording, and store it; None where it cannot be read."""
        if trial.status != "done" or trial.id in self._unreadable:
            return None
        try:
            quality = self._computing.ask(quality_of_recording, self._folder_of(trial.run_id))
        except (ValueError, OSError):
            self._unreadable.add(trial.id)
            return None
        with suppress(DiskFull), self._database.transaction() as db:
            save_quality(db, trial.id, quality)
        return quality

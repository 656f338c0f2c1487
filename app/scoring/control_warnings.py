"""Warnings for the clinician from the control quality of a patient's trials, each with advice."""

from collections.abc import Sequence
from typing import NamedTuple

from app.scoring.map_warnings import fit_warnings, sensor_warnings
from app.scoring.movement_warnings import LEAST_SESSIONS, LEAST_TRIALS, noise_warnings, span_warnings
from app.scoring.trial_assessment import ControlWarning, Kind, TrialAssessment, comparable_trials, trials_of_joint

ORDER: tuple[Kind, ...] = ("sensor", "map", "noise", "span")


class ControlWarnings(NamedTuple):
    """All warnings; the note says what needs more trials, and is empty when there are enough."""

    warnings: list[ControlWarning]
    note: str


def control_warnings(trials: Sequence[TrialAssessment], map_version: int | None = None) -> ControlWarnings:
    """Return the warnings from the trials of one patient.

    Parameters
    ----------
    trials
        In the order driven, without discarded ones.
    map_version
        The patient's newest map, that of the last trial when not given. Warnings of sensors and of the map's fit are
        made from trials with this map only.
    """
    if not trials:
        return ControlWarnings([], "")
    newest = trials[-1].map_version if map_version is None else map_version
    of_map = [trial for trial in trials if trial.map_version == newest]
    warnings = sensor_warnings(of_map[-1]) if of_map else []
    for name in dict.fromkeys(joint.name for joint in trials[-1].quality.joints):
        warnings += fit_warnings(trials_of_joint(of_map, name))
        every = comparable_trials(trials_of_joint(trials, name))
        warnings += noise_warnings(trials_of_joint(of_map, name), every)
        warnings += span_warnings([row for row in every if row.trial.task == trials[-1].task])
    return ControlWarnings(sorted(warnings, key=lambda one: ORDER.index(one.kind)), _note(trials))


def _note(trials: Sequence[TrialAssessment]) -> str:
    """Say how many more trials the trends need; empty when there are enough."""
    same_task = [trial for trial in trials if trial.task == trials[-1].task]
    sessions = len({trial.session for trial in same_task})
    here = sum(trial.session == trials[-1].session for trial in same_task)
    if sessions >= LEAST_SESSIONS or here >= LEAST_TRIALS:
        return ""
    return (
        f"Few trials: whether movements get smaller is told from {LEAST_TRIALS} trials of one task in one session, or "
        f"from {LEAST_SESSIONS} sessions on; so far there {'is' if here == 1 else 'are'} {here} in the last session, "
        f"and {sessions} {'session' if sessions == 1 else 'sessions'}."
    )

"""What the command line says of maps from other people, and the movements that they are learnt from."""

import math
from pathlib import Path

from app.calibration.fit.repetitions import Stretch, stretches_of_prompts
from app.calibration.profile import Arrangement, Forecast, JointMap
from app.calibration.prompts_file import read_prompts
from app.layout import ShirtLayout
from app.signals.signals import Signals


def prompted_stretches(recorded: Signals, table: Path, shirt: ShirtLayout, until: float | None = None) -> list[Stretch]:
    """Return one stretch per joint of a table of prompts, for the maps from other people.

    Between the first and the last prompt of a joint, what is not prompted counts as rest, however long it is.
    """
    rows = read_prompts(table, shirt, float(recorded.t[0]), float(recorded.t[-1]))
    return stretches_of_prompts(recorded.t, recorded.values, rows, recorded.sample_rate, until, longest_pause=math.inf)


def prior_facts(joint: JointMap, reasons: dict[str, str]) -> dict[str, object]:
    """Return what `--json` says of a joint's map from other people, or why there is none."""
    prior = joint.prior
    if prior is None:
        return {"offered": False, "reason": reasons[joint.name]}
    return {
        "offered": prior.is_better,
        "source": prior.source,
        "people": prior.people,
        "repetitions": prior.repetitions,
        "dropped": list(prior.dropped),
        "dead_zone": prior.dead_zone,
        "full": prior.full,
        "hits_of_100": _forecast(prior.hits),
        "false_per_minute": _forecast(prior.false_per_minute),
        "prior_check": None if prior.prior_check is None else prior.prior_check.model_dump(mode="json"),
        "pca_check": None if prior.pca_check is None else prior.pca_check.model_dump(mode="json"),
    }


def _forecast(forecast: Forecast | None) -> object:
    return "not known" if forecast is None else forecast.model_dump(mode="json")


def prior_words(joint: JointMap, reasons: dict[str, str]) -> str:
    """Return the line of a joint's map from other people for people to read."""
    prior = joint.prior
    if prior is None:
        return f"{joint.name}: {reasons[joint.name]}"
    hits, false = (
        "not known" if one is None else f"{one.value:g} ± {one.uncertainty:g}"
        for one in (prior.hits, prior.false_per_minute)
    )
    dropped = f"; channels that hardly move: {', '.join(prior.dropped)}" if prior.dropped else ""
    return (
        f"{joint.name}: {prior.source} ({prior.people} people, {prior.repetitions} own repetitions); expected hits of "
        f"100 movements: {hits}; expected false activations a minute: {false}{dropped}"
    )


def arrangement_words(ring: str, arrangement: Arrangement) -> str:
    """Return how a ring of sensors sits, in words."""
    if arrangement == Arrangement():
        return f"Ring {ring}: it sits as on other people."
    places = f"turned by {arrangement.shift} {'place' if arrangement.shift == 1 else 'places'}"
    mirrored = "mirrored and " if arrangement.mirrored else ""
    return f"Ring {ring}: it is {mirrored}{places} against other people; the calibration allows for that."

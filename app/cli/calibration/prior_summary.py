"""What the command line says of maps from other people."""

from app.calibration.linear_map import Arrangement, Forecast
from app.calibration.prior.prior_map import PriorFit
from app.calibration.profile import JointMap
from app.cli.calibration.map_choice import check_facts


def prior_summary(known: PriorFit) -> dict[str, object]:
    """Return what `--json` says of the maps from other people and of how the shirt sits."""
    return {
        "prior": {joint.name: _facts(joint, known.reasons) for joint in known.profile.joints},
        "arrangement": {ring: found.model_dump(mode="json") for ring, found in known.arrangement.items()},
    }


def prior_report(known: PriorFit) -> list[str]:
    """Return the lines about maps from other people, one per joint, and about how the shirt sits, one per ring."""
    joints = [_joint_words(joint, known.reasons) for joint in known.profile.joints]
    return joints + [_arrangement_words(ring, found) for ring, found in known.arrangement.items()]


def _facts(joint: JointMap, reasons: dict[str, str]) -> dict[str, object]:
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
        "prior_check": check_facts(prior.check),
        "pca_check": check_facts(prior.pca_check),
    }


def _forecast(forecast: Forecast | None) -> object:
    return "not known" if forecast is None else forecast.model_dump(mode="json")


def _joint_words(joint: JointMap, reasons: dict[str, str]) -> str:
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


def _arrangement_words(ring: str, arrangement: Arrangement) -> str:
    if arrangement == Arrangement():
        return f"Ring {ring}: it sits as on other people."
    places = f"turned by {arrangement.shift} {'place' if arrangement.shift == 1 else 'places'}"
    mirrored = "mirrored and " if arrangement.mirrored else ""
    return f"Ring {ring}: it is {mirrored}{places} against other people; the calibration allows for that."

"""The choice of the map in `bodydrive calibrate`, and the check of both maps on held-out repetitions."""

from typing import TYPE_CHECKING, Literal

from app.cli.errors import InputError
from app.number_format import percent

if TYPE_CHECKING:
    from app.calibration.linear_map import MapCheck, MapKind
    from app.calibration.profile import CalibrationProfile, JointMap

MapChoice = Literal["pca", "guided", "prior", "best"]
FALLBACK = "It keeps the standard calibration."


def choose(
    profile: "CalibrationProfile",
    chosen: MapChoice,
    reasons: dict[str, str],
    prior_reasons: dict[str, str] | None = None,
) -> "tuple[CalibrationProfile, list[str]]":
    """Return the profile with the chosen map of each joint, and a sentence for each joint without it.

    `reasons` say why a joint has no guided map, `prior_reasons` why none from other people (None without a prior).
    """
    if chosen == "guided" and not any(joint.guided for joint in profile.joints):
        name, reason = next(iter(reasons.items()))
        raise InputError(f"--map guided, {name}: {reason}")
    if chosen == "prior" and prior_reasons is None:
        raise InputError("--map prior: other people's movements are in a prior, give it with --prior")
    if chosen == "prior" and prior_reasons and not any(joint.prior for joint in profile.joints):
        name, reason = next(iter(prior_reasons.items()))
        raise InputError(f"--map prior, {name}: {reason}")
    sentences = []
    for joint in profile.joints:
        if chosen == "guided" and joint.guided is None:
            sentences.append(f"{joint.name}: {reasons[joint.name]} {FALLBACK}")
        elif chosen == "guided" and joint.guided is not None and not joint.guided.is_better:
            sentences.append(
                f"{joint.name}: what was learnt from the cues is not better on the held-out repetitions. Use --map "
                f"best to keep the standard calibration there."
            )
        elif chosen == "prior" and joint.prior is None and prior_reasons is not None:
            sentences.append(f"{joint.name}: {prior_reasons[joint.name]} {FALLBACK}")
        elif chosen == "prior" and joint.prior is not None and not joint.prior.is_better:
            sentences.append(
                f"{joint.name}: what was learnt from other people is worse on the held-out repetitions. Use --map "
                f"best to leave it out there."
            )
    joints = tuple(joint.model_copy(update={"map": _map_of(joint, chosen)}) for joint in profile.joints)
    return profile.model_copy(update={"joints": joints}), sentences


def _map_of(joint: "JointMap", chosen: MapChoice) -> "MapKind":
    """Return the map that decodes a joint: the chosen one where there is one, the best one that is offered, or PCA."""
    if chosen == "prior":
        return "pca" if joint.prior is None else "prior"
    if chosen == "guided":
        return "pca" if joint.guided is None else "guided"
    return joint.best_map if chosen == "best" else "pca"


def checks(joint: "JointMap", reasons: dict[str, str]) -> dict[str, object]:
    """Return the map in use and the checks of both maps, or the reason why there is no guided map."""
    if joint.guided is None:
        return {"map": joint.map, "offered": False, "reason": reasons[joint.name]}
    guided = joint.guided
    return {
        "map": joint.map,
        "offered": guided.is_better,
        "lag": guided.lag,
        "repetitions": guided.repetitions,
        "dead_zone": guided.dead_zone,
        "full": guided.full,
        "pca_check": check_facts(guided.pca_check),
        "guided_check": check_facts(guided.check),
    }


def check_facts(check: "MapCheck | None") -> object:
    """Return a check as `--json` has it."""
    return None if check is None else check.model_dump(mode="json")


def comparison(profile: "CalibrationProfile", reasons: dict[str, str], width: int) -> list[str]:
    """Return the table of both maps on the held-out repetitions, then the reasons for missing guided maps."""
    both = [(joint.name, joint.guided) for joint in profile.joints if joint.guided]
    lines = []
    if both:
        lines += [
            "On prompted repetitions that were kept apart, the standard calibration and the one learnt from the cues:",
            f"{'':{width}}  {'in phase':>16}  {'time driven':>16}  {'false per min':>16}",
            f"{'joint':{width}}" + f"  {'standard':>8}  {'cues':>6}" * 3 + "  offered",
        ]
        lines += [
            f"{name:{width}}  "
            + "  ".join(
                f"{standard:>8}  {cues:>6}"
                for standard, cues in zip(_figures(guided.pca_check), _figures(guided.check), strict=True)
            )
            + f"  {'yes' if guided.is_better else 'no'}"
            for name, guided in both
        ]
    return lines + [f"{name}: {reason}" for name, reason in reasons.items()]


def _figures(check: "MapCheck | None") -> tuple[str, ...]:
    if check is None:
        return "-", "-", "-"
    return percent(check.in_phase, 1), percent(check.hit_rate, 1), f"{check.false_per_minute:.1f}"

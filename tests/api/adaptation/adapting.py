"""The steps of a clinician who adapts a map, and a proposal that is always made."""

import time
from typing import Any

from app.calibration.adaptation.proposal_document import JointChange, Proposal
from app.calibration.vocabulary import DriveParameters
from app.scoring.trial_forecast import Effect
from app.session.adaptation import AdaptationFlow
from app.session.adaptation_reading import AdaptationResult

UP = 0.01
BEFORE_AND_AFTER = {"activations_before": 40, "activations_after": 42, "false_before": 3, "false_after": 1}
EFFECT = Effect(seconds=60.0, alike=0.98, felt_change=0.02, **BEFORE_AND_AFTER)


def change(parameters: DriveParameters, felt: float = 0.03) -> AdaptationResult:
    """Return a proposal that raises every dead-zone a little, and moves the mean of the first joint."""
    gestures = tuple(each.model_copy(update={"dead_zone": each.dead_zone + UP}) for each in parameters.gestures)
    first, *others = parameters.profile.joints
    moved = first.model_copy(update={"mean": tuple(value + UP for value in first.mean)})
    profile = parameters.profile.model_copy(update={"joints": (moved, *others)})
    joint = JointChange(
        name=first.name,
        angle_proposed_deg=3.0,
        angle_applied_deg=2.0,
        evr_before=0.81,
        evr_after=0.86,
        felt_change=felt,
        cross_talk_before=0.10,
        cross_talk_after=0.09,
        dead_zone_before=0.2,
        dead_zone_after=0.2 + UP,
        full_before=1.0,
        full_after=1.0,
        status="applied",
        reason="The movement has turned.",
    )
    adapted = parameters.model_copy(update={"gestures": gestures, "profile": profile})
    proposal = Proposal(
        trials=1,
        joints=(joint,),
        felt_change=felt,
        warns=felt >= 0.05,
        parameters=adapted,
        difference={"felt_change": felt, "turned": {first.name: 2.0}},
        reason="The right elbow would change.",
    )
    return AdaptationResult(proposal, EFFECT)


def choose(clinic: Any, mode: str) -> Any:
    return clinic.good("PUT", "/adaptation", json={"mode": mode})


def settled(clinic: Any) -> Any:
    """Wait until no proposal is being made, and return the state of the adaptation."""
    while clinic.parts[AdaptationFlow]._tasks:
        time.sleep(0.005)
    return clinic.good("GET", "/adaptation")


def proposed(clinic: Any) -> Any:
    return clinic.good("POST", "/adaptation/propose")


def apply(clinic: Any, view: Any) -> Any:
    return clinic("POST", "/adaptation/apply", json={"proposal": view["proposal"]["id"]})


def versions(clinic: Any) -> Any:
    maps = clinic.good("GET", f"/patients/{clinic.patient['id']}/maps")
    return [(one["version"], one["origin"], one["parent"]) for one in maps]

"""The state of a calibration as its page shows it: the steps, and the result with where each map comes from."""

from typing import Any

from app.api.answers import Answer, MomentText
from app.calibration.fit.profile_fit import joints_without_map
from app.calibration.linear_map import LinearMap
from app.calibration.prior.hit_uncertainty import hits_with_prompts
from app.calibration.prior.landmarks import landmarks
from app.calibration.profile import CalibrationProfile
from app.layout import ShirtLayout
from app.quantities import Document
from app.session.calibration.calibration_flow import RESULT
from app.session.calibration.calibration_progress import Progress
from app.texts import Text


class RunningStep(Document):
    """The step that is being recorded, and the number of its run in the ticks."""

    step: str
    started_run: int | None


class EarlierView(Answer):
    """The patient's calibration of an earlier time, in the same kind of shirt."""

    version: int
    created: MomentText


class CalibrationView(Document):
    """The state of the calibration."""

    current: str
    steps: list[dict[str, Any]]
    running: RunningStep | None
    result: dict[str, Any] | None
    others: int  # other people who are known in this shirt; 0: too few to drive by
    may_drive_now: bool
    earlier: EarlierView | None  # can be fitted to how the shirt sits today, in place of a new calibration
    may_fit_earlier: bool
    short: bool | None  # whether it is the short calibration; null: this shirt has none


def view_of(progress: Progress) -> CalibrationView:
    """Return what the page of the calibration shows."""
    running = progress.running
    return CalibrationView(
        current=progress.current,
        steps=_steps(progress),
        running=None if running is None else RunningStep(step=running, started_run=progress.started_run),
        result=None if progress.profile is None else _result(progress, progress.profile),
        others=progress.others,
        may_drive_now=progress.may_drive_now,
        earlier=None if progress.earlier is None else EarlierView.of(progress.earlier),
        may_fit_earlier=progress.may_fit_earlier,
        short=progress.short,
    )


def _steps(progress: Progress) -> list[dict[str, Any]]:
    waiting = ("waiting", "")
    labels = {} if progress.layout is None else progress.layout.joint_labels
    steps: list[dict[str, Any]] = [
        {
            "id": step.id,
            "kind": step.kind,
            "joint": step.joint,
            "title": step.title,
            "label": step.title if step.joint is None else labels[step.joint].capitalize(),
            "instruction": step.instruction,
            "duration": step.duration,
            "cues": [cue.model_dump(mode="json") for cue in step.cues],
        }
        for step in progress.steps
    ]
    steps.append(
        {
            "id": RESULT,
            "kind": "result",
            "joint": None,
            "title": str(Text("api-result")),
            "label": str(Text("api-result")),
            "instruction": str(Text("api-result-instruction")),
            "duration": 0.0,
            "cues": [],
        }
    )
    for step in steps:
        status, message = progress.status.get(step["id"], waiting)
        step["status"], step["message"] = status, str(message)
    return steps


def _map(linear: LinearMap | None, layout: ShirtLayout) -> dict[str, Any] | None:
    """Return what a map that is not the standard one is learnt from, its checks, and what is expected of it."""
    if linear is None:
        return None
    fields = ("people", "repetitions", "dropped", "hits", "false_per_minute", "check", "pca_check")
    values = {name: getattr(linear, name) for name in fields}
    sits = {
        name: {
            ring: {**sits.model_dump(), "sensors": len(layout.rings[ring]), **landmarks(layout, ring)._asdict()}
            for ring, sits in rings.items()
        }
        for name, rings in (("arrangement", linear.arrangement), ("as_worn", linear.as_worn))
    }
    with_prompts = None if linear.hits is None or linear.repetitions else hits_with_prompts(linear.hits)
    return {
        "offered": linear.is_better,
        **sits,
        **{
            name: value.model_dump(mode="json") if isinstance(value, Document) else value
            for name, value in {**values, "hits_with_prompts": with_prompts}.items()
        },
    }


def _result(progress: Progress, profile: CalibrationProfile) -> dict[str, Any]:
    labels = profile.layout.joint_labels
    steps = {step.joint: step.id for step in progress.steps if step.joint is not None}
    fields = {"name", "evr", "signal_to_noise", "repeatability", "angle_deg"}
    joints = [
        {
            **joint.model_dump(mode="json", include=fields),
            "span": joint.span,
            # The short calibration has no step for some joints: nobody is asked to repeat one.
            "has_to_be_repeated": joint.has_to_be_repeated and joint.name in steps,
            "advice": joint.advice if joint.name in steps else None,
            "dead_zone": joint.thresholds[0],
            "full": joint.thresholds[1],
            "map": joint.map,
            "guided": _map(joint.guided, profile.layout),
            "prior": _map(joint.prior, profile.layout),
            "label": labels[joint.name],
            "step": steps.get(joint.name),
        }
        for joint in profile.joints
    ]
    missing = [
        {
            **dict.fromkeys(fields | {"span", "dead_zone", "full", "map", "guided", "prior"}),
            "name": name,
            "label": labels[name],
            "step": steps.get(name),
            "has_to_be_repeated": name in steps,
            "advice": reason,
        }
        for name, reason in joints_without_map(profile).items()
    ]
    return {
        "joints": joints + missing,
        "cross_talk": profile.cross_talk,
        "left_out": profile.left_out,
        "accepted": progress.accepted,
    }

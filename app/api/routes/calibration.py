"""The calibration of the open session: its steps and its result."""

import asyncio
from typing import Annotated, Any

from fastapi import APIRouter, Path
from pydantic import Field

from app.api.answers import Answer, MomentText
from app.api.deps import Clinician, People, PeopleParts
from app.api.parts import Web, WebParts
from app.api.sign_in.identity import SignedInPerson
from app.calibration.fit.profile_fit import joints_without_map
from app.calibration.gestures.discovery import Discovery
from app.calibration.profile import CalibrationProfile, GuidedMap, MapKind, PriorMap
from app.calibration.vocabulary import standard_parameters
from app.layout import ShirtLayout
from app.quantities import Document, Line, Name
from app.refusals import Conflict
from app.session.calibration.calibration_flow import RESULT
from app.session.calibration.calibration_progress import Progress
from app.session.calibration.gesture_discovery import session_gestures
from app.session.calibration.map_choice import choose_map
from app.store.calibrations import is_calibration_simulated
from app.store.log import write_log
from app.store.parameters import save_parameters, save_profile
from app.store.tables import PatientSession

router = APIRouter(prefix="/calibration", tags=["calibration"])


StepName = Annotated[str, Path(min_length=1, max_length=80)]


class StepChoice(Document):
    """The step to show."""

    step: Annotated[Line, Field(min_length=1, max_length=80)]


class MapChoice(Document):
    """The map that decodes a joint."""

    joint: Name
    map: MapKind


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


def _steps(progress: Progress) -> list[dict[str, Any]]:
    waiting = ("waiting", "")
    steps: list[dict[str, Any]] = [
        {
            "id": step.id,
            "kind": step.kind,
            "joint": step.joint,
            "title": step.title,
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
            "title": "Result",
            "instruction": "Look at each joint. Repeat what is not good enough, then tap “Use this calibration”.",
            "duration": 0.0,
            "cues": [],
        }
    )
    for step in steps:
        step["status"], step["words"] = progress.status.get(step["id"], waiting)
    return steps


def _guided(guided: GuidedMap | None) -> dict[str, Any] | None:
    """Return the checks of the study's map and the guided map on the held-out repetitions."""
    if guided is None:
        return None
    checks = {"pca_check": guided.pca_check, "guided_check": guided.guided_check}
    return {
        "offered": guided.is_better,
        "repetitions": guided.repetitions,
        **{name: check.model_dump(mode="json") for name, check in checks.items()},
    }


def _prior(prior: PriorMap | None, layout: ShirtLayout) -> dict[str, Any] | None:
    """Return what the map learnt from other people comes from, its checks, and what is expected of it."""
    if prior is None:
        return None
    fields = {"people", "repetitions", "dropped", "hits", "false_per_minute", "prior_check", "pca_check"}
    sits = {
        ring: {**found.model_dump(), "sensors": len(layout.rings[ring])} for ring, found in prior.arrangement.items()
    }
    return {"offered": prior.is_better, "arrangement": sits, **prior.model_dump(mode="json", include=fields)}


def _result(progress: Progress, profile: CalibrationProfile) -> dict[str, Any]:
    labels = {joint.name: joint.label for joint in profile.layout.joints}
    steps = {step.joint: step.id for step in progress.steps if step.joint is not None}
    fields = {"name", "evr", "span", "sign", "signal_to_noise", "repeatability", "angle_deg", "grade", "reason"}
    joints = [
        {
            **joint.model_dump(mode="json", include=fields),
            "dead_zone": joint.thresholds[0],
            "full": joint.thresholds[1],
            "map": joint.map,
            "guided": _guided(joint.guided),
            "prior": _prior(joint.prior, profile.layout),
            "label": labels[joint.name],
            "step": steps.get(joint.name),
        }
        for joint in profile.joints
    ]
    missing = [
        {
            **dict.fromkeys(fields | {"dead_zone", "full", "map", "guided", "prior"}),
            "name": name,
            "label": labels[name],
            "step": steps.get(name),
            "grade": "repeat",
            "reason": reason,
        }
        for name, reason in joints_without_map(profile).items()
    ]
    return {
        "joints": joints + missing,
        "cross_talk": profile.cross_talk,
        "left_out": profile.left_out,
        "accepted": progress.accepted,
    }


async def _view(web: WebParts, session: PatientSession) -> CalibrationView:
    progress = await web.calibration.progress(session.id)
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
    )


@router.get("")
async def look(who: Clinician, web: Web) -> CalibrationView:
    """Return the state of the calibration."""
    return await _view(web, await web.session.needed_session(who.clinic_id))


@router.get("/gestures")
async def gestures(who: Clinician, parts: PeopleParts, web: Web) -> Discovery:
    """Return all gestures of the calibration under way, or else of the newest accepted one."""
    session = await web.session.needed_session(who.clinic_id)
    return await asyncio.to_thread(session_gestures, parts.database, web.runs.folder_of, web.computing, session.id)


@router.post("/steps/{step}/start")
async def start_step(step: StepName, who: Clinician, web: Web) -> CalibrationView:
    """Record a step, for the first time or again."""
    async with web.session.undisturbed("start a step"):
        session = await web.session.needed_session(who.clinic_id)
        await web.calibration.start(session.id, step)
    return await _view(web, session)


@router.post("/steps/{step}/cancel")
async def cancel_step(step: StepName, who: Clinician, web: Web) -> CalibrationView:
    """Stop recording a step."""
    session = await web.session.needed_session(who.clinic_id)
    await web.calibration.cancel(session.id, step)
    return await _view(web, session)


@router.post("/steps/{step}/skip")
async def skip_step(step: StepName, who: Clinician, web: Web) -> CalibrationView:
    """Skip a prompted movement that this patient cannot make."""
    async with web.session.undisturbed("skip a step"):
        session = await web.session.needed_session(who.clinic_id)
        await web.calibration.skip(session.id, step)
    return await _view(web, session)


@router.post("/go")
async def go_to_step(body: StepChoice, who: Clinician, web: Web) -> CalibrationView:
    """Show another step."""
    session = await web.session.needed_session(who.clinic_id)
    await web.calibration.go(session.id, body.step)
    return await _view(web, session)


@router.post("/restart")
async def begin_anew(who: Clinician, web: Web) -> CalibrationView:
    """Begin the calibration anew; earlier recordings no longer count."""
    async with web.session.undisturbed("begin anew"):
        session = await web.session.needed_session(who.clinic_id)
        await web.calibration.restart(session.id)
    return await _view(web, session)


@router.post("/map")
async def choose(body: MapChoice, who: Clinician, parts: PeopleParts, web: Web) -> CalibrationView:
    """Choose the study's map or the guided map of a joint; the result must then be accepted again."""
    async with web.session.undisturbed("choose a calibration"):
        session = await web.session.needed_session(who.clinic_id)
        if web.calibration.running:
            raise Conflict("A step is being recorded, or the calibration is being worked out: wait for its end.")
        await asyncio.to_thread(choose_map, parts.database, session.id, body.joint, body.map)
    web.live.tell("calibration")
    return await _view(web, session)


@router.post("/drive-now")
async def drive_now(who: Clinician, parts: PeopleParts, web: Web) -> CalibrationView:
    """Fit the map from other people where nothing was prompted yet, and use it at once."""
    async with web.session.undisturbed("drive now"):
        session = await web.session.needed_session(who.clinic_id)
        await web.calibration.fit_from_others(session.id)
        await _accept(who, parts, web, session)
    for event in ("calibration", "controls", "session"):
        web.live.tell(event)
    return await _view(web, session)


@router.post("/fit-earlier")
async def fit_earlier(who: Clinician, web: Web) -> CalibrationView:
    """Fit the patient's earlier calibration to the shirt as it sits today, and use it at once."""
    async with web.session.undisturbed("fit the calibration"):
        session = await web.session.needed_session(who.clinic_id)
        await web.calibration.fit_earlier(session.id, who.name)
        await web.session.try_load_parameters()
    for event in ("calibration", "controls", "adaptation"):
        web.live.tell(event)
    return await _view(web, session)


@router.post("/accept")
async def accept(who: Clinician, parts: PeopleParts, web: Web) -> CalibrationView:
    """Save the profile as the patient's newest, and load standard parameters on it."""
    async with web.session.undisturbed("accept the result"):
        session = await web.session.needed_session(who.clinic_id)
        await _accept(who, parts, web, session)
        await web.calibration.learn(session.id)
    for event in ("calibration", "controls", "session"):
        web.live.tell(event)
    return await _view(web, session)


async def _accept(who: SignedInPerson, parts: People, web: WebParts, session: PatientSession) -> None:
    progress = await web.calibration.progress(session.id)
    profile = progress.profile
    if profile is None:
        raise Conflict("There is no result yet: do every step first.")
    if progress.accepted:
        raise Conflict("This calibration is in use already: go on to the controls, or repeat a step.")

    def _save() -> None:
        with parts.database.transaction() as db:
            simulated = is_calibration_simulated(db, session.id)
            row = save_profile(db, session.patient_id, session.id, profile, simulated=simulated)
            save_parameters(db, row, standard_parameters(profile))
            db.get_one(PatientSession, session.id).accepted = True
            write_log(db, who.name, "calibration accepted", patient=session.patient_id, version=row.version)

    await asyncio.to_thread(_save)
    await web.session.try_load_parameters()

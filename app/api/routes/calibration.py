"""The calibration of the open session: its steps and its result."""

import asyncio
from typing import Annotated

from fastapi import APIRouter, Path
from pydantic import Field

from app.api.calibration_view import CalibrationView, view_of
from app.api.deps import CalibrationFlowPart, Clinician, Db, DiscoveriesPart, LivePart, SessionFlowPart
from app.api.page_session import ClinicianInSession
from app.api.sign_in.identity import SignedInPerson
from app.calibration.gestures.discovery import Discovery
from app.calibration.linear_map import MapKind
from app.calibration.vocabulary import standard_parameters
from app.news import News, Notify, What
from app.quantities import Document, Line, Name
from app.refusals import Conflict
from app.session.calibration.calibration_flow import CalibrationFlow
from app.session.calibration.map_choice import choose_map
from app.session.calibration.ring_override import override_rotation
from app.session.open_session import SessionFlow
from app.store.calibrations import is_calibration_simulated
from app.store.database import Database
from app.store.log import write_log
from app.store.parameters import save_parameters, save_profile
from app.store.tables import PatientSession
from app.texts import Text

router = APIRouter(prefix="/calibration", tags=["calibration"])


StepName = Annotated[str, Path(min_length=1, max_length=80)]


class StepChoice(Document):
    """The step to show."""

    step: Annotated[Line, Field(min_length=1, max_length=80)]


class CalibrationBeginning(Document):
    """Which calibration to begin: the short one or the whole one."""

    short: bool


class MapChoice(Document):
    """The map that decodes a joint."""

    joint: Name
    map: MapKind


class SittingChoice(Document):
    """Whether the shirt sits right at a joint, whatever the movement of its sensors says."""

    joint: Name
    is_right: bool


async def _view(calibration_flow: CalibrationFlow, session: PatientSession) -> CalibrationView:
    return view_of(await calibration_flow.progress(session.id))


def _notify(notify: Notify, session: PatientSession, *changed: What) -> None:
    for what in changed:
        notify(News(what=what, patient=session.patient_id, session=session.id))


@router.get("")
async def read_calibration(
    _person: Clinician, calibration_flow: CalibrationFlowPart, session_flow: SessionFlowPart
) -> CalibrationView:
    """Return the state of the calibration.

    All routes of the calibration give this answer. `others`: people known in this shirt, 0 when too few; `earlier`: the
    patient's calibration in this kind of shirt, null once this session's has a result; `short`: whether it is the short
    calibration, null where there is none.
    """
    return await _view(calibration_flow, await session_flow.needed_session())


@router.get("/gestures")
async def gestures(_person: Clinician, discoveries: DiscoveriesPart, session_flow: SessionFlowPart) -> Discovery:
    """Return all gestures of the calibration under way, or else of the newest accepted one.

    The best first (docs/learning/gestures.md). `weakest`: the number furthest beyond its limit; `effort` in FS; null:
    not measured. `source` `profile`: the recordings are gone. 409 when nothing is calibrated.
    """
    session = await session_flow.needed_session()
    return await asyncio.to_thread(discoveries.of_session, session.id)


@router.post("/steps/{step}/start")
async def start_step(
    step: StepName, _person: ClinicianInSession, calibration_flow: CalibrationFlowPart, session_flow: SessionFlowPart
) -> CalibrationView:
    """Record a step, for the first time or again."""
    async with session_flow.undisturbed():
        session = await session_flow.needed_session()
        await calibration_flow.start(session.id, step)
    return await _view(calibration_flow, session)


@router.post("/steps/{step}/cancel")
async def cancel_step(
    step: StepName, _person: ClinicianInSession, calibration_flow: CalibrationFlowPart, session_flow: SessionFlowPart
) -> CalibrationView:
    """Stop recording a step."""
    session = await session_flow.needed_session()
    await calibration_flow.cancel(session.id, step)
    return await _view(calibration_flow, session)


@router.post("/steps/{step}/skip")
async def skip_step(
    step: StepName, _person: ClinicianInSession, calibration_flow: CalibrationFlowPart, session_flow: SessionFlowPart
) -> CalibrationView:
    """Skip a prompted movement that this patient cannot make."""
    async with session_flow.undisturbed():
        session = await session_flow.needed_session()
        await calibration_flow.skip(session.id, step)
    return await _view(calibration_flow, session)


@router.post("/go")
async def go_to_step(
    body: StepChoice, _person: ClinicianInSession, calibration_flow: CalibrationFlowPart, session_flow: SessionFlowPart
) -> CalibrationView:
    """Show another step."""
    session = await session_flow.needed_session()
    await calibration_flow.go(session.id, body.step)
    return await _view(calibration_flow, session)


@router.post("/restart")
async def begin_anew(
    _person: ClinicianInSession,
    calibration_flow: CalibrationFlowPart,
    session_flow: SessionFlowPart,
    body: CalibrationBeginning | None = None,
) -> CalibrationView:
    """Begin the calibration anew; earlier recordings no longer count.

    Without a body it is as long as before. 409 for a short one in a shirt that has none.
    """
    async with session_flow.undisturbed():
        session = await session_flow.needed_session()
        await calibration_flow.restart(session.id, is_short=None if body is None else body.short)
    return await _view(calibration_flow, session)


@router.post("/map")
async def choose(
    body: MapChoice,
    _person: ClinicianInSession,
    database: Db,
    calibration_flow: CalibrationFlowPart,
    session_flow: SessionFlowPart,
    live: LivePart,
) -> CalibrationView:
    """Choose the study's map or the guided map of a joint; the result must then be accepted again.

    409 where the map is not offered.
    """
    async with session_flow.undisturbed():
        session = await session_flow.needed_session()
        if calibration_flow.running:
            raise Conflict(Text("api-calibration-busy"))
        await asyncio.to_thread(choose_map, database, session.id, body.joint, body.map)
    _notify(live.notify, session, "calibration")
    return await _view(calibration_flow, session)


@router.post("/sitting")
async def say_how_it_sits(
    body: SittingChoice,
    person: ClinicianInSession,
    database: Db,
    calibration_flow: CalibrationFlowPart,
    session_flow: SessionFlowPart,
    live: LivePart,
) -> CalibrationView:
    """Leave a ring of sensors as worn, or take it as it looks; the result must then be accepted again.

    `is_right` true: the shirt sits right although a ring looks turned or mirrored; the map is fitted anew. 409 where it
    sits as on other people. A new free movement forgets it.
    """
    async with session_flow.undisturbed():
        session = await session_flow.needed_session()
        if calibration_flow.running:
            raise Conflict(Text("api-calibration-busy"))
        await asyncio.to_thread(
            override_rotation, database, session.id, body.joint, person.name, is_right=body.is_right
        )
        await calibration_flow.fit_again(session.id)
    _notify(live.notify, session, "calibration")
    return await _view(calibration_flow, session)


@router.post("/drive-now")
async def drive_now(
    person: ClinicianInSession,
    database: Db,
    calibration_flow: CalibrationFlowPart,
    session_flow: SessionFlowPart,
    live: LivePart,
) -> CalibrationView:
    """Fit the map from other people where nothing was prompted yet, and use it at once; what was prompted is learnt.

    409 before rest and free movement, or with fewer than four other people.
    """
    async with session_flow.undisturbed():
        session = await session_flow.needed_session()
        await calibration_flow.fit_from_others(session.id)
        await _accept(person, database, calibration_flow, session_flow, session)
        await calibration_flow.learn(session.id)
    _notify(live.notify, session, "calibration", "controls", "session")
    return await _view(calibration_flow, session)


@router.post("/fit-earlier")
async def fit_earlier(
    person: ClinicianInSession, calibration_flow: CalibrationFlowPart, session_flow: SessionFlowPart, live: LivePart
) -> CalibrationView:
    """Fit the patient's earlier calibration to the shirt as it sits today, and use it at once.

    409 before rest and free movement, without an earlier calibration in this shirt, or with a ring turned since.
    """
    async with session_flow.undisturbed():
        session = await session_flow.needed_session()
        await calibration_flow.fit_earlier(session.id, person.name)
        await session_flow.try_load_parameters()
    _notify(live.notify, session, "calibration", "controls", "adaptation")
    return await _view(calibration_flow, session)


@router.post("/accept")
async def accept(
    person: ClinicianInSession,
    database: Db,
    calibration_flow: CalibrationFlowPart,
    session_flow: SessionFlowPart,
    live: LivePart,
) -> CalibrationView:
    """Save the profile as the patient's newest, and load standard parameters on it."""
    async with session_flow.undisturbed():
        session = await session_flow.needed_session()
        await _accept(person, database, calibration_flow, session_flow, session)
        await calibration_flow.learn(session.id)
    _notify(live.notify, session, "calibration", "controls", "session")
    return await _view(calibration_flow, session)


async def _accept(
    person: SignedInPerson,
    database: Database,
    calibration_flow: CalibrationFlow,
    session_flow: SessionFlow,
    session: PatientSession,
) -> None:
    progress = await calibration_flow.progress(session.id)
    profile = progress.profile
    if profile is None:
        raise Conflict(Text("visit-no-result"))
    if progress.accepted:
        raise Conflict(Text("api-calibration-in-use"))

    def _save() -> None:
        with database.transaction() as db:
            simulated = is_calibration_simulated(db, session.id)
            row = save_profile(db, session.patient_id, session.id, profile, simulated=simulated)
            save_parameters(db, row, standard_parameters(profile))
            db.get_one(PatientSession, session.id).accepted = True
            write_log(db, person.name, "calibration accepted", patient=session.patient_id, version=row.version)

    await asyncio.to_thread(_save)
    await session_flow.try_load_parameters()

"""The controls: the current parameter set, with undo, redo and named sets."""

import asyncio
from collections.abc import Callable
from dataclasses import dataclass
from typing import Annotated, Any

from fastapi import APIRouter, Depends, HTTPException
from pydantic import Field, ValidationError

from app.api.deps import Clinician, SessionFlowPart
from app.api.live.live_picture import ClinicLive
from app.api.page_session import ClinicianInSession
from app.api.parts import parts_for
from app.api.routes.obstacle_view import ObstacleView
from app.api.sign_in.identity import SignedInPerson
from app.calibration.gestures.suggestion import SuggestedVocabulary
from app.calibration.vocabulary import Binding, ControlMode, CruiseTime, DriveParameters, Gesture, TurnCruiseTime
from app.messages import MAX_GESTURES
from app.news import News
from app.quantities import Cutoff, Document, Title
from app.sentences import one_sentence
from app.session.calibration.gesture_discovery import GestureDiscoveries
from app.session.open_session import SessionFlow
from app.session.real_arming import RealArming
from app.speed_limits import Speeds
from app.store.database import Database, Transaction
from app.store.log import write_log
from app.store.map_versions import source_of_map
from app.store.parameters import (
    as_document,
    current_parameters,
    load_titled,
    save_parameters,
    saved_titles,
    step_parameters,
    undo_and_redo,
)
from app.store.tables import ParameterSet, PatientSession, Profile
from app.texts import Text

router = APIRouter(prefix="/controls", tags=["controls"])


class ControlSettings(Document):
    """A parameter set without its profile."""

    gestures: Annotated[tuple[Gesture, ...], Field(min_length=1, max_length=MAX_GESTURES)]
    bindings: Annotated[tuple[Binding, ...], Field(max_length=16)]
    mode_u1: ControlMode
    mode_u2: ControlMode
    cutoff: Cutoff
    speeds: Speeds
    cruise_time: CruiseTime = 10.0
    turn_cruise_time: TurnCruiseTime = 3.0
    title: Title = "Standard"


class TitleChoice(Document):
    """The name of a saved set."""

    title: Title


class ControlsSuggestion(Document):
    """The vocabulary that the calibration suggests, and the reason."""

    bindings: tuple[Binding, ...]
    reason: Text


class ControlsView(Document):
    """The current parameter set, and the choices."""

    parameters: DriveParameters
    hash: str
    can_undo: bool
    can_redo: bool
    saved: list[str]
    suggested: ControlsSuggestion
    held: dict[str, float]  # the limits of the clinic or the chosen chair that are lower than the set's speeds
    obstacle: ObstacleView | None  # why this set cannot drive


Change = Callable[[Transaction, PatientSession, SuggestedVocabulary], ParameterSet]


@dataclass(frozen=True, slots=True)
class PatientControls:
    """The controls of the patient who is here: read, and changed."""

    database: Database
    discoveries: GestureDiscoveries
    arming: RealArming
    session_flow: SessionFlow
    live: ClinicLive

    async def view(self) -> ControlsView:
        """Return the current parameter set."""
        session = await self.session_flow.needed_session()

        def read() -> ControlsView:
            suggestion = self._suggestion(session.patient_id)
            with self.database.reading() as db:
                return self._view(db, session.patient_id, suggestion)

        return await asyncio.to_thread(read)

    async def change(self, person: SignedInPerson, what: str, change: Change) -> ControlsView:
        """Change the current set, and load it into the control process."""

        def write(session: PatientSession) -> ControlsView:
            suggestion = self._suggestion(session.patient_id)
            with self.database.transaction() as db:
                row = change(db, session, suggestion)
                view = self._view(db, session.patient_id, suggestion)
                write_log(db, person.name, what, patient=session.patient_id, parameters=row.id, hash=view.hash)
                return view

        async with self.session_flow.undisturbed():
            session = await self.session_flow.needed_session()
            view = await asyncio.to_thread(write, session)
            await self.session_flow.try_load_parameters()
        self.live.notify(News(what="controls", patient=session.patient_id))
        return view

    def _view(self, db: Transaction, patient_id: int, suggestion: SuggestedVocabulary) -> ControlsView:
        row, profile = current_parameters(db, patient_id)
        parameters = as_document(row, profile)
        before, after = undo_and_redo(db, patient_id)
        return ControlsView(
            parameters=parameters,
            hash=parameters.hash,
            can_undo=before is not None,
            can_redo=after is not None,
            saved=saved_titles(db, patient_id),
            suggested=ControlsSuggestion(bindings=suggestion.bindings, reason=suggestion.reason),
            held=self.arming.lowered_speeds(parameters.speeds),
            obstacle=ObstacleView.of(self.session_flow.obstacle(parameters, source_of_map(db, profile))),
        )

    def _suggestion(self, patient_id: int) -> SuggestedVocabulary:
        """Return the vocabulary that the newest map suggests; call outside of a transaction: it reads recordings."""
        return self.discoveries.of_patient(patient_id).suggestion


Controls = Annotated[PatientControls, Depends(parts_for(PatientControls))]


@router.get("")
async def read_controls(_person: Clinician, controls: Controls) -> ControlsView:
    """Return the current parameter set.

    `held`: speeds that clinic or chair do not allow, with what holds instead. `obstacle`: why the set cannot drive, and
    the page that mends it (`shirt`, `calibrate`, `controls`). 409 when nothing is calibrated.
    """
    return await controls.view()


@router.get("/obstacle")
async def read_obstacle(_person: Clinician, session_flow: SessionFlowPart) -> ObstacleView | None:
    """Return why the current parameter set cannot drive; null when it can, and without a calibration."""
    return ObstacleView.of(await asyncio.to_thread(session_flow.current_obstacle))


@router.put("")
async def set_controls(body: ControlSettings, person: ClinicianInSession, controls: Controls) -> ControlsView:
    """Set the controls; an invalid set changes nothing."""

    def _set(db: Transaction, session: PatientSession, _suggestion: SuggestedVocabulary) -> ParameterSet:
        _row, profile = current_parameters(db, session.patient_id)
        return save_parameters(db, profile, _whole(body.model_dump(mode="json"), profile))

    return await controls.change(person, "controls set", _set)


def _whole(settings: dict[str, Any], profile: Profile) -> DriveParameters:
    try:
        return DriveParameters.model_validate({**settings, "profile": profile.document})
    except ValidationError as error:
        raise HTTPException(422, one_sentence(error, Text("api-the-controls"))) from error


@router.post("/undo")
async def undo(person: ClinicianInSession, controls: Controls) -> ControlsView:
    """Undo: make the set before current."""
    return await controls.change(
        person, "controls undone", lambda db, session, _: step_parameters(db, session.patient_id, back=True)
    )


@router.post("/redo")
async def redo(person: ClinicianInSession, controls: Controls) -> ControlsView:
    """Redo: make the set that was undone current."""
    return await controls.change(
        person, "controls redone", lambda db, session, _: step_parameters(db, session.patient_id, back=False)
    )


@router.post("/suggest")
async def suggest(person: ClinicianInSession, controls: Controls) -> ControlsView:
    """Bind the gestures that the calibration suggests, with its dead-zones and fulls."""

    def _suggest(db: Transaction, session: PatientSession, suggestion: SuggestedVocabulary) -> ParameterSet:
        row, profile_row = current_parameters(db, session.patient_id)
        settings = {**row.settings, **suggestion.model_dump(mode="json", include={"gestures", "bindings"})}
        return save_parameters(db, profile_row, _whole(settings, profile_row))

    return await controls.change(person, "controls suggested", _suggest)


@router.post("/load")
async def load(body: TitleChoice, person: ClinicianInSession, controls: Controls) -> ControlsView:
    """Make a saved set the current one."""
    return await controls.change(
        person, "controls loaded", lambda db, session, _: load_titled(db, session.patient_id, body.title)
    )

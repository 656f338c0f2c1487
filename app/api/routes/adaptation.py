"""The adaptation of the map: show a proposal, apply it at a standstill, go back."""

import asyncio
from dataclasses import dataclass
from typing import Annotated, Any

from fastapi import APIRouter, Depends
from pydantic import AfterValidator, Field

from app.api.answers import Answer, MomentText
from app.api.deps import Anyone, Db, RowId
from app.api.page_session import ClinicianInSession
from app.api.parts import parts_for
from app.calibration.adaptation.proposal_document import JointChange
from app.json_values import JsonDocument
from app.quantities import Document
from app.scoring.trial_forecast import Effect
from app.session.adaptation import NOT_ASKED, STALE, AdaptationFlow, AdaptationProposal, Mode
from app.session.open_session import SessionFlow
from app.source import SourceGroup
from app.store.adaptation_material import is_current, mode_of
from app.store.database import Database, Transaction
from app.store.log import log_viewing
from app.store.map_versions import version_before, versions_of
from app.store.parameters import as_document, current_parameters, newest_profile
from app.store.patients import find_patient
from app.texts import Text, from_document

router = APIRouter(tags=["adaptation"])

NOT_CALIBRATED = Text("visit-not-calibrated")


class AdaptationModeChoice(Document):
    """Whether this patient's map is adapted, and by whom."""

    mode: Mode


class ProposalChoice(Document):
    """The proposal that a person has seen."""

    proposal: Annotated[str, Field(pattern=r"^[0-9a-f]{32}$")]


class JointView(JointChange):
    """The proposed change of a joint, with its label."""

    reason: Text
    label: str


class ProposalView(Document):
    """A proposal; `applied` is the version of the map that it became."""

    id: str
    trials: list[int]
    felt_change: float
    warns: bool  # the change is so large that the patient will feel it
    reason: Text
    changes: bool  # whether there is anything to apply
    joints: list[JointView]
    effect: Effect | None  # predicted by replaying the last trial; None when that was not possible
    applied: int | None
    message: Text | str  # why it was not applied by itself


class AdaptationView(Document):
    """The state of the adaptation of the map of the patient who is here."""

    mode: Mode
    version: int | None  # of the map in use
    origin: str | None
    practised: int  # kept trials on the virtual chair with exactly this set: a real one arms no other
    back_to: int | None  # the version that going back restores
    proposal: ProposalView | None
    why: Text | str  # why there is no proposal, or nothing to apply
    refusal: Text | None  # why nothing may be applied at this moment
    looking: bool  # a proposal is being made


def _with_sentences(difference: JsonDocument | None) -> JsonDocument | None:
    """Return what a version changed, with the reason of each joint as a text."""
    if difference is None or "joints" not in difference:
        return difference
    joints = {
        name: {field: from_document(value) if field == "reason" else value for field, value in joint.items()}
        for name, joint in difference["joints"].items()
    }
    return {**difference, "joints": joints}


class MapView(Answer):
    """One version of a map."""

    version: int
    origin: str
    parent: int | None
    difference: Annotated[dict[str, Any] | None, AfterValidator(_with_sentences)]
    created: MomentText
    trials: list[int]


def _proposal_view(waiting: AdaptationProposal, labels: dict[str, str]) -> ProposalView:
    proposal = waiting.result.proposal
    return ProposalView(
        id=waiting.id,
        trials=list(waiting.trials),
        felt_change=proposal.felt_change,
        warns=proposal.warns,
        reason=proposal.reason,
        changes=proposal.parameters is not None,
        joints=[JointView(**dict(joint), label=labels.get(joint.name, joint.name)) for joint in proposal.joints],
        effect=waiting.result.effect,
        applied=waiting.applied,
        message=waiting.reason or "",
    )


def _view(db: Transaction, flow: AdaptationFlow, patient_id: int, group: SourceGroup) -> AdaptationView:
    mode: Any = mode_of(db, patient_id)
    view = AdaptationView(
        mode=mode,
        version=None,
        origin=None,
        practised=0,
        back_to=None,
        proposal=None,
        why=NOT_CALIBRATED,
        refusal=flow.refusal(),
        looking=flow.is_proposing,
    )
    if newest_profile(db, patient_id) is None:
        return view
    row, profile = current_parameters(db, patient_id)
    parameters = as_document(row, profile)
    waiting = flow.proposal_for(patient_id)
    why: Text | str = ""
    if waiting is None:
        why = flow.reason_for_none(patient_id) or NOT_ASKED[mode]
    elif waiting.applied is not None:
        if waiting.applied != profile.version:
            waiting, why = None, NOT_ASKED[mode]
    elif not is_current(db, patient_id, waiting.base_hash, waiting.trials):
        waiting, why = None, STALE
    elif waiting.result.proposal.parameters is None:
        why = waiting.result.proposal.reason
    practice = flow.practice.practice(db, patient_id, parameters.hash, group)
    labels = parameters.profile.layout.joint_labels
    changed = {
        "version": profile.version,
        "origin": profile.origin,
        "practised": practice.trials,
        "back_to": version_before(db, patient_id),
        "proposal": None if waiting is None else _proposal_view(waiting, labels),
        "why": why,
    }
    return view.model_copy(update=changed)


@dataclass(frozen=True, slots=True)
class AdaptationState:
    """The adaptation of the map of the patient who is here."""

    database: Database
    session_flow: SessionFlow
    flow: AdaptationFlow

    async def view(self) -> AdaptationView:
        """Return the proposal to adapt the map, or why there is none."""
        session = await self.session_flow.needed_session()

        def read() -> AdaptationView:
            with self.database.reading() as db:
                return _view(db, self.flow, session.patient_id, self.session_flow.group)

        return await asyncio.to_thread(read)


State = Annotated[AdaptationState, Depends(parts_for(AdaptationState))]


@router.get("/adaptation")
async def read_adaptation(_person: Anyone, state: State) -> AdaptationView:
    """Return the proposal to adapt the map, or why there is none.

    `why`: there is no proposal or nothing to apply; `refusal`: nothing may be applied now; `practised`: kept trials
    with exactly this set. In a proposal, null where the movements said nothing; `applied` of a joint means: in what
    would be armed; `message`: why it was not applied by itself.
    """
    return await state.view()


@router.put("/adaptation")
async def choose_mode(body: AdaptationModeChoice, person: ClinicianInSession, state: State) -> AdaptationView:
    """Choose whether this patient's map is adapted: off, suggest, or auto (by itself, between trials)."""
    session = await state.session_flow.needed_session()
    await state.flow.set_mode(session, body.mode, person.name)
    return await state.view()


@router.post("/adaptation/propose")
async def propose(_person: ClinicianInSession, state: State) -> AdaptationView:
    """Make a proposal from the last trials now, whatever the mode is."""
    await state.flow.propose(await state.session_flow.needed_session())
    return await state.view()


@router.post("/adaptation/apply")
async def apply(body: ProposalChoice, person: ClinicianInSession, state: State) -> AdaptationView:
    """Make a proposal the next version of the map; only between trials, and never with a real chair.

    409 while anything is driven, armed or moves, with a real chair chosen, or when controls or trials changed since.
    """
    await state.flow.apply(body.proposal, person.name)
    return await state.view()


@router.post("/adaptation/dismiss")
async def dismiss(body: ProposalChoice, _person: ClinicianInSession, state: State) -> AdaptationView:
    """Dismiss a proposal; 409 as for `apply`."""
    await state.flow.dismiss(await state.session_flow.needed_session(), body.proposal)
    return await state.view()


@router.post("/adaptation/back")
async def back(person: ClinicianInSession, state: State) -> AdaptationView:
    """Restore the map before, as a new version.

    409 as for `apply`. The mode `auto` becomes `suggest`.
    """
    await state.flow.back(person.name)
    return await state.view()


@router.get("/patients/{patient_id}/maps")
def list_maps(patient_id: RowId, person: Anyone, database: Db) -> list[MapView]:
    """List the versions of a patient's map, the newest first."""
    with database.transaction(closing=True) as db:
        find_patient(db, patient_id)
        log_viewing(db, person.name, patient_id)
        return [MapView.of(version) for version in versions_of(db, patient_id)]

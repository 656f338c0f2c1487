"""The floor plan of the running trial, for the plan that a page draws."""

from typing import Annotated

from fastapi import APIRouter, Depends

from app.api.deps import SessionFlowPart, TrialFlowPart, viewer
from app.api.sign_in.identity import PairedScreen, SignedInPerson
from app.quantities import Document, Name
from app.world.floorplan import FloorPlan
from app.world.place_texts import plan_for_reader

router = APIRouter(tags=["view"])


class TrialPlan(Document):
    """The floor plan and path of the running trial."""

    trial: int
    floorplan: FloorPlan
    path: Name


@router.get("/view/{role}/plan")
def shown_plan(
    requester: Annotated[SignedInPerson | PairedScreen, Depends(viewer)],
    trial_flow: TrialFlowPart,
    session_flow: SessionFlowPart,
) -> TrialPlan | None:
    """Return the floor plan and the path of the running trial; null while there is none.

    The patient's is for the patient's screens, too.
    """
    trial = trial_flow.current
    if trial is None or not requester.sees(session_flow.patient_id):
        return None
    return TrialPlan(trial=trial.id, floorplan=plan_for_reader(trial.plan), path=trial.path.name)

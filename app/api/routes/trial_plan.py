"""The floor plan of the trial that is driven, for the page that draws it from above."""

from fastapi import APIRouter, Depends

from app.api.deps import viewer
from app.api.parts import Web
from app.quantities import Document, Name
from app.world.floorplan import FloorPlan

router = APIRouter(tags=["view"])


class TrialPlan(Document):
    """Where the trial is driven."""

    trial: int
    floorplan: FloorPlan
    path: Name


@router.get("/view/{role}/plan", dependencies=[Depends(viewer)])
def shown_plan(web: Web) -> TrialPlan | None:
    """Return the floor plan and the path of the trial that is driven; null while there is none."""
    trial = web.trials.current
    return None if trial is None else TrialPlan(trial=trial.id, floorplan=trial.plan, path=trial.path.name)

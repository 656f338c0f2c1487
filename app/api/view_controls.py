"""What a clinician may do with the 3D views: look from somewhere else, open and close the plots."""

from collections.abc import Callable
from typing import Annotated, Any

from fastapi import APIRouter, Depends, HTTPException
from pydantic import StrictBool

from app.quantities import Document
from app.scene.scene import Scene
from app.scene.servers import Role
from app.scene.views import View

SceneNow = Callable[[], Scene | None]
"""Returns the scene of the visit, None while nobody is visiting."""


class CameraChoice(Document):
    """Where to look from."""

    view: View


class PlotsChoice(Document):
    """Whether the plots are shown."""

    open: StrictBool


class ViewState(Document):
    """What a view shows."""

    view: View
    plots: bool


def view_controls(scene_now: SceneNow, clinician: Callable[..., Any]) -> APIRouter:
    """Return the routes `/view/ROLE/camera` and `/view/clinician/plots`, to be put under `/api/v1`.

    Parameters
    ----------
    scene_now
        The scene of the visit.
    clinician
        Dependency that refuses those who may not drive.
    """
    router = APIRouter(prefix="/view", tags=["view"], dependencies=[Depends(clinician)])

    def scene() -> Scene:
        found = scene_now()
        if found is None:
            raise HTTPException(409, "There is no 3D view while nobody is visiting: open a visit first.")
        return found

    SceneOfVisit = Annotated[Scene, Depends(scene)]  # noqa: N806

    @router.post("/{role}/camera")
    def look(role: Role, choice: CameraChoice, shown: SceneOfVisit) -> ViewState:
        """Look from the patient's eye, from behind the chair, or from above."""
        shown.set_view(role, choice.view)
        return _state(shown, role)

    @router.post("/clinician/plots")
    def show_plots(choice: PlotsChoice, shown: SceneOfVisit) -> ViewState:
        """Show or hide the plots inside the clinician's view."""
        shown.open_plots(choice.open)
        return _state(shown, "clinician")

    return router


def _state(scene: Scene, role: Role) -> ViewState:
    return ViewState(view=scene.view(role), plots=scene.plots_open if role == "clinician" else False)

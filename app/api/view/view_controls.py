"""The clinician's controls of the 3D views: camera, view settings, plots."""

from collections.abc import Callable
from typing import Annotated, Any

from fastapi import APIRouter, Depends, HTTPException
from pydantic import Field, StrictBool

from app.quantities import Document, Fraction, Metres, Radians
from app.scene.cameras import Orbit, View
from app.scene.role_servers import Role
from app.scene.session_scene import LiveScene
from app.texts import Text

SceneNow = Callable[[], LiveScene | None]
"""Returns the scene of the session, None while no session is open."""

FieldOfView = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=30, le=110)]  # degrees, vertical
EyeHeight = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.8, le=1.6)]  # m
Elevation = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0.05, le=1.5708)]  # rad above the floor
Distance = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=1, le=100)]  # m


class CameraChoice(Document):
    """The view and its settings; fields that are left out stay unchanged."""

    view: View | None = None
    fov_deg: FieldOfView | None = None
    eye_height: EyeHeight | None = None
    roll_share: Fraction | None = None
    head: StrictBool | None = None


class FreeCamera(Document):
    """The free camera: the direction and distance from which it looks at a point on the floor."""

    azimuth: Radians
    elevation: Elevation
    distance: Distance
    x: Metres
    y: Metres


class PlotsChoice(Document):
    """Whether the plots are drawn."""

    open: StrictBool


class ViewState(Document):
    """The state of a view."""

    view: View
    plots: bool
    fov_deg: float
    eye_height: float
    roll_share: float
    head: bool
    free: FreeCamera


def view_controls(scene_now: SceneNow, clinician: Callable[..., Any]) -> APIRouter:
    """Return the routes `/view/ROLE/camera`, `/view/ROLE/free` and `/view/clinician/plots`, to be put under `/api/v1`.

    Parameters
    ----------
    scene_now
        Returns the scene of the open session.
    clinician
        Dependency that refuses people who may not drive, and pages that show another session.
    """
    router = APIRouter(prefix="/view", tags=["view"], dependencies=[Depends(clinician)])

    def scene() -> LiveScene:
        drawn_scene = scene_now()
        if drawn_scene is None:
            raise HTTPException(409, Text("api-no-view"))
        return drawn_scene

    SceneOfSession = Annotated[LiveScene, Depends(scene)]  # noqa: N806

    @router.post("/{role}/camera")
    def choose_camera(role: Role, choice: CameraChoice, drawn: SceneOfSession) -> ViewState:
        """Look from the patient's eye, from behind the chair, from above, or from anywhere.

        `fov_deg`, `eye_height`, `roll_share` and `head` are the patient's eye's.
        """
        changes = choice.model_dump(exclude={"view"}, exclude_none=True)
        drawn.set_view(role, choice.view or drawn.view(role), drawn.settings(role)._replace(**changes))
        return _state(drawn, role)

    @router.post("/{role}/free")
    def turn(role: Role, place: FreeCamera, drawn: SceneOfSession) -> ViewState:
        """Put the free camera somewhere else; it is seen while the view is `free`."""
        drawn.set_orbit(role, Orbit(**place.model_dump()))
        return _state(drawn, role)

    @router.post("/clinician/plots")
    def show_plots(choice: PlotsChoice, drawn: SceneOfSession) -> ViewState:
        """Show or hide the plots inside the clinician's view."""
        drawn.open_plots(choice.open)
        return _state(drawn, "clinician")

    return router


def _state(scene: LiveScene, role: Role) -> ViewState:
    return ViewState(
        view=scene.view(role),
        plots=scene.plots_open if role == "clinician" else False,
        free=FreeCamera(**scene.orbit(role)._asdict()),
        **scene.settings(role)._asdict(),
    )

"""Where to drive: the floor plans with their tasks, and the task that is proposed to a patient."""

from fastapi import APIRouter, HTTPException

from app.api.answers import Answer
from app.api.deps import Anyone, ComputingPart, Db, PlacesPart, RowId, SpreadPart
from app.api.driving.clinic_places import ClinicPlaces
from app.api.routes.source_view import RequestedGroup
from app.quantities import Document, Name
from app.refusals import NotFound
from app.scoring.next_task import DrivenTask, Reason, is_worse_than_noise, next_task, went_well
from app.session.clinic_spread import Task
from app.store.learning_trials import counted_trials
from app.store.log import log_viewing
from app.store.patients import find_patient
from app.store.runs import trials_of
from app.store.tables import Trial
from app.texts import Text
from app.world.floorplan import FloorPlan
from app.world.place_texts import place_text, plan_for_reader
from app.world.scene import DrivingPlace
from app.world.task_groups import TaskGroup, group_of

router = APIRouter(tags=["floor plans"])


class PathView(Document):
    """A path to choose, and its task."""

    name: str
    title: Text
    length: float  # m
    task: str  # path, follow, turn, back or course


class SceneView(Document):
    """The scene that a floor plan is a level of."""

    name: str
    title: Text
    about: Text


class LevelView(Document):
    """A level of difficulty."""

    name: str
    title: Text


class FloorPlanView(Document):
    """A floor plan to choose."""

    name: str
    title: Text
    width: float  # m
    height: float  # m
    paths: list[PathView]
    scene: SceneView | None  # None: a building by itself
    level: LevelView | None
    group: TaskGroup


class NextTaskView(Answer):
    """A proposed task, and why it is proposed: the first one, the last one again, or its next level."""

    floorplan: str
    path: str
    reason: Reason


@router.get("/floorplans")
def list_floorplans(_person: Anyone, places: PlacesPart) -> list[FloorPlanView]:
    """List the floor plans to drive in: scenes by level, then buildings; unreadable ones are left out.

    With the `task` of each path: `path`, `follow`, `turn`, `back` or `course`.
    """
    return [_floorplan_view(offer) for offer in places.all().values()]


def _floorplan_view(offer: DrivingPlace) -> FloorPlanView:
    plan, scene, level = offer

    def shown(text: str) -> Text | str:
        return place_text(plan.name, text)

    x_min, y_min, x_max, y_max = plan.bounds
    return FloorPlanView(
        name=plan.name,
        title=shown(plan.title),
        width=round(x_max - x_min, 3),
        height=round(y_max - y_min, 3),
        paths=[
            PathView(name=path.name, title=shown(path.title), length=round(path.line.length, 3), task=path.task.kind)
            for path in plan.paths
        ],
        scene=None if scene is None else SceneView(name=scene.name, title=shown(scene.title), about=shown(scene.about)),
        level=None if level is None else LevelView(name=level.name, title=shown(level.title)),
        group=group_of(offer),
    )


def needed_plan(places: ClinicPlaces, name: str) -> FloorPlan:
    """Return a floor plan; 404 when there is none of this name, 409 when it cannot be read."""
    try:
        plan = places.plan(name)
    except ValueError as error:
        reason = str(error).removeprefix(f"{places.folder / name}.json").lstrip(":, ")
        raise HTTPException(409, Text("api-plan-unusable", name=name, problem=reason)) from error
    if plan is None:
        raise NotFound(Text("api-no-plan", name=name))
    return plan


@router.get("/floorplans/{name}")
def one_floorplan(name: Name, _person: Anyone, places: PlacesPart) -> FloorPlan:
    """Return a floor plan; the titles and instructions of a bundled one are in the reader's language."""
    return plan_for_reader(needed_plan(places, name))


@router.get("/patients/{patient_id}/next-task")
def propose_task(
    patient_id: RowId,
    person: Anyone,
    database: Db,
    computing: ComputingPart,
    spread: SpreadPart,
    places: PlacesPart,
    source: RequestedGroup,
) -> NextTaskView:
    """Return the task that is proposed to a patient; only trials of one source lead to the next level.

    The study's corridors for a new patient; else the last task, or the next level of its scene when the last three
    counting trials reached the goal without contact and none is worse than noise.
    """
    with database.transaction() as db:
        find_patient(db, patient_id)
        log_viewing(db, person.name, patient_id)
        trials = [_past(trial) for trial in trials_of(db, patient_id) if trial.status == "done"]

    def _is_worse(floorplan: str, path: str) -> bool:
        with database.reading() as db:
            counted = counted_trials(db, patient_id, floorplan, path)
        clinic = spread.of_others(Task(floorplan, path, source), patient_id)
        rows = [counted_trial.row() for counted_trial in counted if counted_trial.group == source]
        return computing.ask(is_worse_than_noise, rows, clinic)

    return NextTaskView.of(next_task(trials, source, places.all(), _is_worse))


def _past(trial: Trial) -> DrivenTask:
    return DrivenTask(trial.floorplan, trial.path, trial.source.group, trial.kept, went_well(trial.end, trial.measures))

"""What pages look up: the catalogue of measures, the limits of requests, and numbers of the program."""

from fastapi import APIRouter, FastAPI, Request

from app.api.deps import ForEveryone
from app.api.field_limits import Limits, field_limits
from app.api.live.camera_socket import IN_USE, UNWANTED
from app.api.live.phone_socket import ELSEWHERE
from app.api.live.screen_socket import TAKEN
from app.api.sign_in.passwords import SHORTEST
from app.api.sockets import SIGNED_OUT
from app.calibration.map_grades import SIGNAL_TO_NOISE_LIMITS, SPREAD_LIMITS
from app.faults import State
from app.layout import MAX_CHANNELS, USUAL_JOINTS
from app.quantities import Document
from app.scene.cameras import EyeSettings
from app.scoring.measures import (
    REACHED_NAME,
    TEST_MEASURES,
    TRIAL_MEASURES,
    VERDICT_WORDS,
    VERDICT_WORDS_OF_TESTS,
    WORKLOAD_NAME,
    Measure,
    Word,
)
from app.scoring.task_measures import LEADER_NEAR
from app.scoring.verdict.leading_measures import LEADING, LEADING_OF_TESTS
from app.scoring.verdict.measure_verdict import FEWEST
from app.speed_limits import FIRST_CHAIR_SPEEDS, Speeds
from app.store.access.sign_ins import IDLE_FOR
from app.store.files.replacements import KEPT_FOR
from app.store.keeping.erasure import UNDO_FOR
from app.texts import Text
from app.world.cursor_task import CursorPlan
from app.world.floorplan import Door, FloorPlan, PrescribedPath
from app.world.footprint import CHAIR_RADIUS
from app.world.imports.draft import SHORTEST_TIME, SLOWEST
from app.world.imports.file_limits import MOST_PLAN_BYTES
from app.world.obstacles import Box
from app.world.scenery import Cone
from app.world.tasks import GOAL_RADIUS

router = APIRouter(tags=["start"])


class LeadingMeasures(Document):
    """The measures that lead in a task whose trials have all measures of `has`."""

    has: list[str]
    names: list[str]


class MeasureCatalogue(Document):
    """The measures of trials and of two-minute tests by their keys, in the order in which pages show them."""

    trial: dict[str, Measure]
    test: dict[str, Measure]
    leading: list[LeadingMeasures]  # the first row that fits holds
    leading_of_tests: list[str]
    reached: Text  # what people call the share of trials that reached the goal
    workload: Text  # what people call the mean of the answers after a two-minute test
    verdicts: dict[Word, Text]  # on trials
    verdicts_of_tests: dict[Word, Text]


class Numbers(Document):
    """Numbers of the program that pages draw, compare with, or name in a sentence."""

    chair_radius: float = CHAIR_RADIUS  # m, of what touches things
    leader_near: float = LEADER_NEAR  # m, a smaller error of the distance to a leader counts as near
    trials_for_verdict: int = FEWEST
    signal_to_noise: tuple[float, float] = SIGNAL_TO_NOISE_LIMITS  # from the first on strong, from the second on fair
    spread: tuple[float, float] = SPREAD_LIMITS  # of repetitions: up to the first well, up to the second fairly
    first_speeds: Speeds = FIRST_CHAIR_SPEEDS  # that the form of a new chair proposes
    wall_height: float = FloorPlan.model_fields["wall_height"].default  # m, of a floor plan that does not give it
    wall_thickness: float = FloorPlan.model_fields["wall_thickness"].default  # m, likewise
    door_width: float = Door.model_fields["width"].default  # m, of a new door
    obstacle_height: float = Box.model_fields["height"].default  # m, of a new box
    cone_radius: float = Cone.model_fields["radius"].default  # m, of a new cone
    cone_height: float = Cone.model_fields["height"].default  # m
    goal_radius: float = GOAL_RADIUS  # m, of a new path
    time_limit: float = PrescribedPath.model_fields["time_limit"].default  # s, of a path that does not give it
    slowest_mean_speed: float = SLOWEST  # m/s, for which the time limit of a new path suffices
    shortest_time_limit: float = SHORTEST_TIME  # s, of a new path
    signed_out: int = SIGNED_OUT  # close code of a socket whose sign-in has ended
    screen_in_use: int = TAKEN  # close code of a screen's socket: another one reports for that screen
    camera_in_use: int = IN_USE  # close code of a camera's socket: another page is the camera
    camera_unwanted: int = UNWANTED  # likewise: the shirt in use is no camera
    phone_elsewhere: int = ELSEWHERE  # close code of a phone's socket: its page was opened once more
    lock_minutes: int = round(IDLE_FOR.total_seconds() / 60)  # without an action, after which a sign-in is locked
    armed: int = State.ARMED  # in the column `state` of a time line
    field_of_view: float = EyeSettings().fov_deg  # degrees, of a screen on which nobody has chosen one
    eye_height: float = EyeSettings().eye_height  # m, likewise
    target_missed_after: float = CursorPlan.model_fields["time_limit"].default  # s, in the two-minute test
    password_length: int = SHORTEST  # characters at least
    deleted_days: int = UNDO_FOR.days  # for which a deleted patient can be brought back
    replaced_days: int = KEPT_FOR.days  # for which what an upload replaced can be put back
    layout_channels: int = MAX_CHANNELS  # of a layout of a shirt, at most
    upload_megabytes: int = MOST_PLAN_BYTES // 1_000_000  # of a file for a floor plan


class Reference(Document):
    """Facts of the program that stay as they are while it runs."""

    measures: MeasureCatalogue
    limits: Limits
    numbers: Numbers
    usual_joints: list[str]  # which have a name in each language


@router.get("/reference", dependencies=[ForEveryone])
def reference(request: Request) -> Reference:
    """Return the facts that pages need beside data: they have no tables of their own.

    Without sign-in. `needs_goal`: a trial that missed the goal does not count in this measure; `of`: the measure that
    says out of how many. The measures that lead in a task are those of the first row of `leading` whose `has` its
    trials have.
    """
    state = request.app.state
    if not hasattr(state, "reference"):
        state.reference = reference_of(request.app)
    reference_document: Reference = state.reference
    return reference_document


def reference_of(app: FastAPI) -> Reference:
    """Return the facts of an application."""
    return Reference(
        measures=MeasureCatalogue(
            trial=TRIAL_MEASURES,
            test=TEST_MEASURES,
            leading=[LeadingMeasures(has=list(has), names=list(names)) for has, names in LEADING],
            leading_of_tests=list(LEADING_OF_TESTS),
            reached=REACHED_NAME,
            workload=WORKLOAD_NAME,
            verdicts=VERDICT_WORDS,
            verdicts_of_tests=VERDICT_WORDS_OF_TESTS,
        ),
        limits=field_limits(app),
        numbers=Numbers(),
        usual_joints=list(USUAL_JOINTS),
    )

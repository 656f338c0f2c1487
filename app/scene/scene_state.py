"""The state of a scene during a trial: the present stage of the task, standing and fallen cones, places of movers."""

import math
from typing import Final

from app.geometry import Pose
from app.scene.meshes import palette
from app.scene.meshes.bodies import Mesh, Part, merged, standing_box, tube
from app.scene.task_marks import later_parts, task_parts
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.footprint import CHAIR_RADIUS
from app.world.movers import Track
from app.world.progress import TaskProgress, progress_of
from app.world.scenery import Cone

# Of a cone.
TIP: Final = 0.14  # radius at the tip over the cone's radius
BODY: Final = 0.78  # radius of the body at the floor over the cone's radius
PLATE: Final = 0.68  # half side of the plate over the cone's radius; the plate's corners stay inside the circle
PLATE_HEIGHT: Final = 0.03  # m
BAND: Final = (0.45, 0.7)  # lower and upper end of the band over the cone's height
BAND_RADIUS: Final = 1.04  # over the body's radius at the band


class SceneState:
    """The state of a plan during a trial of one task.

    Attributes
    ----------
    task : dict of Part
        Meshes of the task's present stage; another object when the stage changes.
    cones : Cones
        The plan's cones.
    """

    def __init__(self, plan: FloorPlan | None = None, path: PrescribedPath | None = None) -> None:
        self._plan = plan
        self._path = path
        self._tracks = [] if plan is None else [Track(mover) for mover in plan.movers]
        self._scene_t = 0.0
        self._progress: TaskProgress | None = None
        self._part: PrescribedPath | None = None
        self.task: dict[str, Part] = {}
        self.cones = Cones(() if plan is None else plan.cones)
        self.begin_again()

    def begin_again(self) -> None:
        """Restart the task, and stand all cones up."""
        self._scene_t = 0.0
        if self._plan is not None and self._path is not None:
            self._progress = progress_of(self._plan, self._path)
        self._show_part()
        self.cones.stand_up()

    def update(self, pose: Pose, v: float, scene_t: float) -> None:
        """Update task and cones with the chair's pose and speed (m/s) at the scene's time (s)."""
        if scene_t < self._scene_t:  # the scene was reset: the chair is at the start again
            self.begin_again()
        self._scene_t = scene_t
        if self._progress is not None:
            self._progress.update(pose, v, scene_t)
            self._show_part()
        self.cones.touch(pose)

    def movers(self) -> list[Pose]:
        """Return the poses of the movers at the scene's time."""
        return [track.at(self._scene_t).pose for track in self._tracks]

    def _show_part(self) -> None:
        if self._progress is None or self._path is None or self._progress.part is self._part:
            return
        self._part = self._progress.part
        self.task = task_parts(self._part) | later_parts(self._path)


class Cones:
    """The soft cones of a plan, which stand until the chair touches them and then lie until the next trial."""

    def __init__(self, cones: tuple[Cone, ...]) -> None:
        self._cones = cones
        self._fall_directions: dict[int, float] = {}  # rad, by the number of each lying cone
        self._parts: dict[str, Part] | None = None

    @property
    def lying(self) -> int:
        """Return the number of lying cones."""
        return len(self._fall_directions)

    def touch(self, pose: Pose) -> None:
        """Lay down the cones that a chair at `pose` touches."""
        for number, cone in enumerate(self._cones):
            x, y = cone.position[0] - pose.x, cone.position[1] - pose.y
            if number not in self._fall_directions and math.hypot(x, y) < CHAIR_RADIUS + cone.radius:
                self._fall_directions[number] = math.atan2(y, x)
                self._parts = None

    def stand_up(self) -> None:
        """Stand all cones up again."""
        if self._fall_directions:
            self._fall_directions.clear()
            self._parts = None

    def parts(self) -> dict[str, Part]:
        """Return the meshes of all cones; the returned object stays the same until a cone falls or stands up."""
        if self._parts is None:
            self._parts = self._build() if self._cones else {}
        return self._parts

    def _build(self) -> dict[str, Part]:
        bodies, bands = [], []
        for number, cone in enumerate(self._cones):
            fall_direction = self._fall_directions.get(number)
            bodies.append(_placed(_body(cone), cone, fall_direction))
            bands.append(_placed(_band(cone), cone, fall_direction))
        return {"cones": Part(merged(bodies), palette.CONE), "cone_bands": Part(merged(bands), palette.CERAMIC)}


def _body(cone: Cone) -> Mesh:
    side = 2 * PLATE * cone.radius
    plate = min(PLATE_HEIGHT, cone.height / 4)
    return merged(
        [
            standing_box(side, side, 0.0, plate),
            tube((0.0, 0.0, plate), (0.0, 0.0, cone.height), _radius(cone, plate), _radius(cone, cone.height)),
        ]
    )


def _band(cone: Cone) -> Mesh:
    low, high = (share * cone.height for share in BAND)
    radii = (BAND_RADIUS * _radius(cone, low), BAND_RADIUS * _radius(cone, high))
    return tube((0.0, 0.0, low), (0.0, 0.0, high), *radii)


def _radius(cone: Cone, height: float) -> float:
    """Return the radius (m) of a cone's body at a height (m)."""
    return cone.radius * (BODY + (TIP - BODY) * height / cone.height)


def _placed(mesh: Mesh, cone: Cone, fall_direction: float | None) -> Mesh:
    if fall_direction is None:
        return mesh.moved(*cone.position)
    # A lying cone rests on the edge of its plate and on its tip.
    lean = math.pi / 2 + math.atan2((PLATE - TIP) * cone.radius, cone.height)
    return mesh.tilted(lean).moved(z=PLATE * cone.radius).moved(*cone.position, heading=fall_direction)

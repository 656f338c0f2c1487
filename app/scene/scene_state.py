"""The state of a scene during a trial: the present stage of the task, fallen cones, places of the movers."""

from app.geometry import Pose
from app.scene.cones import Cones
from app.scene.meshes.bodies import Part
from app.scene.task_marks import later_parts, task_parts
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.movers import Track
from app.world.progress import TaskProgress, progress_of


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
        """Start the task anew, and stand all cones up."""
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

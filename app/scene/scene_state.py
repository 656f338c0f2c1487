"""What happens in a plan while somebody drives: the present stage of the task, cones that fall, things that move."""

from app.geometry import Pose
from app.scene.cones import Cones
from app.scene.meshes.bodies import Part
from app.scene.task_marks import later_parts, task_parts
from app.world.floorplan import FloorPlan, PrescribedPath
from app.world.scenery import Track
from app.world.task_progress import TaskProgress, progress_of


class SceneState:
    """One attempt at one task; what it gives to draw is the same object until it changes.

    Attributes
    ----------
    task : dict of Part
        What shows the present stage.
    cones : Cones
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
        """Let the task begin from its start, and put up the cones."""
        self._scene_t = 0.0
        if self._plan is not None and self._path is not None:
            self._progress = progress_of(self._plan, self._path)
        self._show_part()
        self.cones.stand_up()

    def update(self, pose: Pose, v: float, scene_t: float) -> None:
        """Take note of the chair's pose and speed (m/s) at the scene's time (s)."""
        if scene_t < self._scene_t:  # the chair was put on the start again
            self.begin_again()
        self._scene_t = scene_t
        if self._progress is not None:
            self._progress.update(pose, v, scene_t)
            self._show_part()
        self.cones.touch(pose)

    def movers(self) -> list[Pose]:
        """Return where everything is that moves by itself."""
        return [track.at(self._scene_t).pose for track in self._tracks]

    def _show_part(self) -> None:
        if self._progress is None or self._path is None or self._progress.part is self._part:
            return
        self._part = self._progress.part
        self.task = task_parts(self._part) | later_parts(self._path)

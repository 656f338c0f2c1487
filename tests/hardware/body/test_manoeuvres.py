"""The simulated person turns, drives backwards, follows, and does several of these, on an open floor."""

import dataclasses
import json
import math
from typing import Any

import pytest
from hardware.body.wishes import wished

from app.geometry import Pose
from app.hardware.base import LeaderView
from app.hardware.body.driver import BackAim, Driver, TurnAim
from app.hardware.body.person_parameters import PRACTISED
from app.hardware.body.steering import Steering
from app.world.floorplan import FloorPlan
from app.world.progress import leader_of, progress_of

WORTH = {"right_elbow": 0.3, "left_elbow": -0.3, "right_shoulder": 0.45, "left_shoulder": -0.45}
DT = 0.01  # s

LINE = {"title": "T", "instruction": "Go.", "goal_radius": 0.3}
TURN: dict[str, Any] = {"points": [[0, 0], [0, 2]], "task": {"kind": "turn", "direction": "left"}}
BACK: dict[str, Any] = {"points": [[0, 0], [-2, 0]], "task": {"kind": "back"}}
STAGES: list[dict[str, Any]] = [
    {**LINE, **TURN},
    {**LINE, "points": [[0, 0], [0, 3]]},
    {**LINE, "points": [[0, 3], [0, 1.5]], "task": BACK["task"]},
]
COURSE = {"points": [[0, 0], [2, 0]], "task": {"kind": "course", "stages": STAGES}}
PACE = [[0, 0.0], [2, 0.5], [8, 0.2], [14, 0.5]]
LEADER = {"name": "anna", "kind": "person", "points": [[1.5, 0], [9, 0]], "pace": PACE}


def asked(**path):
    """Return a floor with one task, and the task's path."""
    movers = [LEADER] if path["task"]["kind"] == "follow" else []
    path = {"name": "task", **LINE, **path}
    document = {"name": "p", "title": "P", "walls": [], "paths": [path], "movers": movers}
    plan = FloorPlan.model_validate_json(json.dumps(document))
    return plan, plan.paths[0]


class Floor:
    """An open floor on which a full stroke changes 0.3 m/s or 0.45 rad, with the progress of the task."""

    def __init__(self, driver, plan, path) -> None:
        self.driver, self.progress = driver, progress_of(plan, path)
        self.leader = leader_of(plan, path)
        self.pose, self.v = path.start, 0.0
        self.t = self.scene_t = 0.0
        self.before = dict.fromkeys(WORTH, 0.0)
        driver.show_task(plan, path)

    def live(self, seconds, permitted=True) -> None:
        """Go on for so long, or until the task is done; what is not permitted stands."""
        for _ in range(round(seconds / DT)):
            if self.progress.reached:
                return
            self.t += DT
            if not permitted:
                self.v = 0.0
                self.driver.rest()
                self.before = {name: limb.level(self.t) for name, limb in self.driver.strokes.limbs.items()}
                continue
            self.scene_t += DT
            ahead = None if self.leader is None else LeaderView(*self.leader.at(self.scene_t))
            self.driver.drive(self.t, self.pose, self.v, False, ahead)
            self._move()
            self.progress.update(self.pose, self.v, self.scene_t)

    def _move(self) -> None:
        x, y, theta = self.pose
        for name, limb in self.driver.strokes.limbs.items():
            level = limb.level(self.t)
            rise, self.before[name] = max(0.0, level - self.before[name]), level
            if name.endswith("elbow"):
                self.v = min(0.8, max(-0.3, self.v + WORTH[name] * rise))
            else:
                theta = math.remainder(theta + WORTH[name] * rise, math.tau)
        self.pose = Pose(x + self.v * math.cos(theta) * DT, y + self.v * math.sin(theta) * DT, theta)


@pytest.mark.parametrize("seed", [1, 2, 3])
@pytest.mark.parametrize("task", [TURN, BACK, COURSE])
def test_what_is_asked_is_done(task, seed) -> None:
    floor = Floor(Driver(PRACTISED, seed), *asked(**task))
    floor.live(90.0)
    assert floor.progress.reached
    assert floor.progress.stage == floor.progress.stages - 1


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_leader_is_followed_at_the_asked_distance(seed) -> None:
    plan, path = asked(points=[[0, 0], [9, 0]], task={"kind": "follow", "leader": "anna", "distance": 1.5})
    floor = Floor(Driver(PRACTISED, seed), plan, path)
    gaps = []
    while not floor.progress.reached and floor.t < 60.0:
        floor.live(1.0)
        assert floor.leader is not None
        leader = floor.leader.at(floor.scene_t).pose
        gaps.append(math.hypot(leader.x - floor.pose.x, leader.y - floor.pose.y))
    assert floor.progress.reached
    assert min(gaps) > 0.7
    assert max(gaps) < 2.5


def test_a_stop_while_a_turn_is_held_hurries_nobody() -> None:
    """The time of looking at a mark stops while the chair may not move, for the progress and for the driver."""
    stages = [{**STAGES[0], "task": {**TURN["task"], "hold": 5.0}}, STAGES[1]]
    floor = Floor(Driver(PRACTISED, 1), *asked(**COURSE | {"task": {"kind": "course", "stages": stages}}))
    for _ in range(1000):
        floor.live(0.1)
        if abs(floor.pose.theta - math.pi / 2) < 0.09 and floor.v == 0.0:
            break
    floor.live(1.0)
    looking = floor.driver.steering
    assert isinstance(looking, TurnAim)
    floor.live(30.0, permitted=False)
    floor.live(1.5)
    assert floor.progress.stage == 0
    assert floor.driver.steering is looking
    floor.live(60.0)
    assert floor.progress.reached


def test_the_driver_goes_on_to_a_stage_after_the_judge_and_no_later_than_he_can_see() -> None:
    driver = Driver(dataclasses.replace(PRACTISED, reaction_time=0.4), 2)
    floor = Floor(driver, *asked(**COURSE))
    kinds = [TurnAim, Steering, BackAim]
    told = seen = 0
    told_at = 0.0
    while not floor.progress.reached and floor.t < 90.0:
        floor.live(DT)
        if floor.progress.stage != told:
            told, told_at = floor.progress.stage, floor.t
        if not isinstance(driver.steering, kinds[seen]):
            seen += 1
            assert isinstance(driver.steering, kinds[seen])
            assert seen == told
            assert floor.t - told_at == pytest.approx(0.4, abs=2.5 * DT)
    assert seen == 2


def test_who_turns_lets_the_chair_stand_first_and_turns_the_asked_way() -> None:
    _, path = asked(points=[[0, 0], [0, -2]], task={"kind": "turn", "direction": "left"})
    aim = TurnAim(path, path.task)
    here = Pose(0.0, 0.0, path.start.theta)
    assert wished(aim.want(0.0, here, 0.2)) == "slower"
    assert wished(aim.want(0.1, here, -0.2)) == "faster"
    assert wished(aim.want(0.2, here, 0.0)) == "left"
    past = Pose(0.0, 0.0, -math.pi / 2 + 0.3)
    for theta in (1.0, 2.0, 3.0, -2.0, past.theta):  # the long way round
        wish = aim.want(0.3, here._replace(theta=theta), 0.0)
    assert wished(wish) == "right"
    assert aim.want(0.4, here._replace(theta=-math.pi / 2 + 0.02), 0.0) is None


def test_who_rolls_off_the_spot_goes_back_to_it_when_it_lies_ahead_or_behind() -> None:
    _, path = asked(points=[[0, 0], [0, -2]], task={"kind": "turn", "direction": "left"}, goal_radius=0.4)
    aim = TurnAim(path, path.task)
    assert wished(aim.want(0.0, Pose(0.5, 0.0, 0.0), 0.0)) == "slower"
    assert aim.want(0.1, Pose(0.5, 0.0, 0.0), -0.12) is None
    assert wished(aim.want(0.2, Pose(-0.5, 0.0, 0.0), 0.0)) == "faster"
    assert wished(aim.want(0.3, Pose(0.0, 0.5, 0.0), 0.0)) in {"left", "right"}, "it lies to the side"
    assert wished(aim.want(0.4, Pose(0.2, 0.0, 0.0), 0.0)) in {"left", "right"}, "near enough"


def test_who_backs_begins_stands_at_the_end_and_keeps_to_the_line() -> None:
    _, path = asked(**BACK)
    aim = BackAim(path, PRACTISED)
    assert aim.want(0.0, path.start, 0.0) == ("slower", pytest.approx(0.2))
    assert aim.want(0.1, Pose(-0.5, 0.0, 0.0), -0.2) is None
    # Driving backwards, a chair that has come off to its left turns left, so that its back points to the line.
    assert wished(aim.want(0.2, Pose(-0.5, 0.3, 0.0), -0.2)) == "left"
    assert wished(aim.want(0.3, Pose(-0.5, -0.3, 0.0), -0.2)) == "right"
    aim.want(0.35, Pose(-1.2, 0.0, 0.0), -0.2)
    assert aim.want(0.4, Pose(-1.95, 0.0, 0.0), -0.2) == ("faster", pytest.approx(0.2))

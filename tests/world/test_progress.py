import pytest

from app.world.path import Path
from app.world.progress import LineProgress

ROUND = [(0, 0), (10, 0), (10, 10), (0, 10), (0, 0)]


def drive(progress, line, spacing=0.1):
    path = Path(line)
    for number in range(int(path.length / spacing) + 1):
        progress.update(*path.point_at(number * spacing))
    progress.update(*path.points[-1])


def test_the_end_is_reached_after_the_path():
    progress = LineProgress(Path([(0, 0), (10, 0)]), 0.5)
    drive(progress, [(0, 1), (9, 1)])
    assert progress.s == pytest.approx(9)
    assert progress.cross_track == pytest.approx(1)
    assert not progress.reached
    drive(progress, [(9, 1), (9.6, 0)])
    assert progress.reached


def test_a_round_course_is_not_done_at_its_start():
    progress = LineProgress(Path(ROUND), 0.5)
    drive(progress, [(0, 0), (-1.5, 0), (0.3, 0)])  # back and forth at the start
    assert not progress.reached
    drive(progress, [(0.3, 0), *ROUND[1:]])
    assert progress.reached


def test_a_short_cut_to_the_end_does_not_reach_it():
    progress = LineProgress(Path([(0, 0), (10, 0), (10, 3), (0, 3)]), 0.5)
    drive(progress, [(0, 0), (0, 3)])
    assert not progress.reached


def test_a_chair_that_left_the_path_is_found_on_another_part_of_it():
    progress = LineProgress(Path(ROUND), 0.5)
    drive(progress, [(0, 0), (6, 0), (6, 5), (9, 5), (9, 9)])
    assert progress.s == pytest.approx(19, abs=1.1)
    assert abs(progress.cross_track) < 1.1


def test_waiting_covers_nothing():
    progress = LineProgress(Path(ROUND), 0.5)
    for _ in range(1000):
        progress.update(0, 0)
    assert progress.covered < 0.02

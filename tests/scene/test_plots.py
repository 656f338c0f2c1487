import numpy as np
import pytest

from app.geometry import Pose
from app.scene.plots import ERROR_SHOWN, MOST_POINTS, ErrorSamples, PlotSeries, trajectory_ranges, trajectory_samples
from app.world.path import Path

CORNER = Path([(0, 0), (10, 0), (10, 5), (0, 5)])


def test_the_error_is_signed_and_the_newest_is_at_zero_seconds():
    driven = PlotSeries(CORNER)
    for step in range(50):
        driven.add(Pose(0.05 * step, 0.2, 0.0), 0.1 * step + 0.05)
    before_now, zero, error = driven.error.plotted()
    assert before_now[[0, -1]] == pytest.approx([-30.0, 0.0])
    assert 300 <= len(before_now) <= 600
    assert not zero.any()
    assert error[-40:] == pytest.approx(0.2)
    assert np.isnan(error[:200]).all()


def test_old_errors_leave_and_silence_leaves_a_gap():
    samples = ErrorSamples()
    samples.add(0.05, 0.3)
    samples.add(10.05, -0.4)
    error = samples.plotted()[2]
    assert error[-1] == -0.4
    assert error[-101] == 0.3
    assert np.isfinite(error).sum() == 2
    samples.add(100.05, 5.0)
    assert samples.plotted()[2][-1] == ERROR_SHOWN
    assert np.isfinite(samples.plotted()[2]).sum() == 1


def test_a_crossing_of_the_path_is_not_mistaken_for_where_the_chair_is():
    line = Path([(0, 0), (6, 0), (6, 3), (3, 3), (3, -3)])  # crosses itself at (3, 0)
    driven = PlotSeries(line)
    for step in range(60):
        driven.add(Pose(0.05 * step + 0.02, 0.1, 0.0), 0.1 * step + 0.05)
    assert driven.error.plotted()[2][-1] == pytest.approx(0.1)


def test_the_trajectory_stays_bounded_and_keeps_both_ends():
    driven = PlotSeries(None)
    for step in range(5000):
        driven.add(Pose(0.06 * step, 0.0, 0.0), 0.1 * step)
    assert len(driven.points) <= MOST_POINTS
    assert driven.points[0] == (0.0, 0.0)
    assert driven.points[-1] == (0.06 * 4999, 0.0)


def test_a_chair_that_is_put_elsewhere_begins_anew():
    driven = PlotSeries(CORNER)
    driven.add(Pose(0, 0, 0), 0.0)
    driven.add(Pose(10, 5, 0), 0.1)
    assert driven.points == [(10, 5)]
    assert np.isfinite(driven.error.plotted()[2]).sum() == 1


def test_path_and_trajectory_share_one_row_of_x_that_lies_inside_the_range():
    x_range, y_range = trajectory_ranges(CORNER, 2.2)
    assert (x_range[1] - x_range[0]) / (y_range[1] - y_range[0]) == pytest.approx(2.2)
    x, prescribed, actual = trajectory_samples(CORNER, [(1.0, 1.0), (99.0, 2.0)], x_range)
    assert len(x) == len(prescribed) == len(actual) == 6
    assert x_range[0] < x.min()
    assert x.max() < x_range[1]
    assert np.isnan(prescribed[4:]).all()
    assert np.isnan(actual[:4]).all()
    assert actual[4:] == pytest.approx([1.0, 2.0])

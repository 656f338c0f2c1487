"""`bodydrive score`: no full marks for the wrong way, and no results from other units."""

import numpy as np
import pytest

from app.cli.errors import InputError
from app.cli.score import FOLLOWING, score_files


@pytest.fixture
def scored(tmp_path):
    def measures(t, x):
        rows = "\n".join(f"{a},{b},0" for a, b in zip(t, x, strict=True))
        (tmp_path / "driven.csv").write_text(f"t,x,y\n{rows}\n")
        (tmp_path / "path.csv").write_text("x,y\n0,0\n10,0\n")
        return score_files(tmp_path / "driven.csv", tmp_path / "path.csv", 0.5)

    return measures


T, X = np.linspace(0, 20, 401), np.linspace(0, 10, 401)


def test_the_wrong_way_has_no_measures_of_following(scored):
    measures = scored(T, X[::-1])
    assert not measures["reached"]
    assert [measures[name] for name in FOLLOWING] == [None] * len(FOLLOWING)
    assert measures["dist"] == pytest.approx(10)


@pytest.mark.parametrize("end", [1.0, 0.6])
def test_the_right_way_has_them_whether_or_not_it_reaches_the_goal(scored, end):
    measures = scored(T, X * end)
    assert measures["reached"] == (end == 1.0)
    assert measures["e_diff"] == pytest.approx(0, abs=1e-6)


def test_times_in_milliseconds_are_refused(scored):
    with pytest.raises(InputError, match="give t in seconds, not in milliseconds"):
        scored(T * 1000, X)


def test_places_in_millimetres_are_refused(scored):
    with pytest.raises(InputError, match="give x and y in metres"):
        scored(T, X * 1000)

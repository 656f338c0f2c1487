import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.calibration.fit.pca import JointPCA, angle_between


@given(seed=st.integers(0, 2**32 - 1), channels=st.integers(1, 9))
def test_map_variance_equals_that_of_scikit_learn(seed, channels):
    from sklearn.decomposition import PCA  # here: it takes a second to load

    rng = np.random.default_rng(seed)
    values = rng.normal(size=(200, 12)) @ rng.normal(size=(12, 12)) + rng.normal(size=12)
    mine = rng.permutation(12)[:channels].tolist()
    fitted = JointPCA(mine).fit(values)
    reference = PCA(svd_solver="full").fit(values[:, mine])
    assert fitted.transform(values).var(ddof=1) == pytest.approx(reference.explained_variance_[0], rel=1e-9)
    assert fitted.explained_variance_ratio_[0] == pytest.approx(reference.explained_variance_ratio_[0], rel=1e-9)
    assert np.linalg.norm(fitted.direction) == pytest.approx(1.0)
    assert fitted.transform(values).mean() == pytest.approx(0.0, abs=1e-9)


def test_fit_returns_itself():
    pca = JointPCA([0, 1])
    assert pca.fit(np.random.default_rng(1).normal(size=(20, 3))) is pca


def test_angle_does_not_care_which_way_an_axis_points():
    one = np.array([1.0, 0.0])
    other = np.array([np.cos(0.5), np.sin(0.5)])
    assert angle_between(one, other) == pytest.approx(np.degrees(0.5))
    assert angle_between(one, -other) == pytest.approx(np.degrees(0.5))
    assert angle_between(one, one * (1 + 1e-16)) == 0.0

"""Principal component analysis of one joint's channels: the map of the paper."""

from collections.abc import Sequence
from typing import Self

import numpy as np
from numpy.typing import NDArray


class JointPCA:
    """PCA of one joint's channels, in the manner of scikit-learn.

    Attributes
    ----------
    components_ : (k, k) array
        Unit rows, the first component first; its sign is arbitrary.
    mean_ : (k,) array
        Mean of each channel, in signal units.
    explained_variance_ : (k,) array
        Variance along each component.
    explained_variance_ratio_ : (k,) array
        The same as shares of the joint's whole variance; the first is the EVR.
    """

    def __init__(self, channels: Sequence[int]) -> None:
        self.channels = list(channels)

    def fit(self, values: NDArray[np.float64]) -> Self:
        """Fit to the joint's k channels in frames (n, n_channels), which may not hold NaN."""
        from sklearn.decomposition import PCA

        fitted = PCA(svd_solver="covariance_eigh").fit(values[:, self.channels])
        self.components_: NDArray[np.float64] = fitted.components_
        self.mean_: NDArray[np.float64] = fitted.mean_
        self.explained_variance_: NDArray[np.float64] = fitted.explained_variance_
        self.explained_variance_ratio_: NDArray[np.float64] = fitted.explained_variance_ratio_
        return self

    @property
    def direction(self) -> NDArray[np.float64]:
        """The first component (k,), the only one that a map has."""
        first: NDArray[np.float64] = self.components_[0]
        return first

    def transform(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the projection (n,) of frames (n, n_channels) on the first component, in signal units."""
        place: NDArray[np.float64] = (values[:, self.channels] - self.mean_) @ self.direction
        return place


def angle_between(first: NDArray[np.float64], second: NDArray[np.float64]) -> float:
    """Return the angle (degrees, 0..90) between the lines along two unit vectors, whose signs do not matter."""
    return float(np.degrees(np.arccos(min(1.0, abs(float(first @ second))))))

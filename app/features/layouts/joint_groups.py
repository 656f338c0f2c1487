"""Which channels belong to one joint: groups of channels that move together, found in free movement."""

from typing import Final, Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from app.layout import MAX_JOINTS
from app.texts import Text

BLOCK: Final = 0.1  # s over which frames are averaged: a movement lasts longer, noise does not
SHORTEST: Final = 10.0  # s of movement, the free movement of a calibration
WHOLE: Final = 0.9  # share of the blocks in which a channel must have values
APART: Final = 0.5  # mean silhouette from which Kaufman and Rousseeuw call a structure reasonable
NEARLY: Final = 0.05  # of a mean silhouette: of partitions that are so nearly as good, the one of fewest groups
ALIKE: Final = 0.7  # mean |correlation| between the last two groups from which all channels are one joint

Verdict = Literal["groups", "one", "unclear", "still", "short"]


class JointGroups(NamedTuple):
    """Channels that move together, and how clear that is."""

    verdict: Verdict
    groups: tuple[tuple[int, ...], ...] = ()  # indices of channels, by the first of each group; empty: not clear
    still: tuple[int, ...] = ()  # channels that did not move, or have too few values
    silhouette: float = 0.0  # mean over the channels that moved, of the partition that was chosen; at most 1

    @property
    def text(self) -> Text:
        """What was found, and what to do where it is not clear."""
        return Text(f"layouts-proposal-{self.verdict}", count=len(self.groups), least=round(SHORTEST))


def joint_groups(values: NDArray[np.float64] | NDArray[np.float32], sample_rate: float) -> JointGroups:
    """Return the groups of channels that move together.

    1. Frames are averaged over blocks of BLOCK seconds, and differences of successive blocks taken: rates, without the
       offset, and nearly without the drift and creep of a fabric, which are slow.
    2. A channel moved when successive rates are alike (their correlation is positive). Rates of white noise, being
       differences, have a correlation of -1/2; those of a constant signal are 0.
    3. Between two channels i and j, r_ij is the correlation of their rates and d_ij = 1 - |r_ij| their distance. The
       sign does not count: where a joint stretches one sensor, it slackens another one.
    4. Groups are merged one after the other, at first each channel alone, always the two of the smallest mean distance
       between their channels (average linkage [1]_). That gives one partition for each number of groups.
    5. A partition is as good as its mean silhouette [2]_: of a channel with mean distance a to its own group and b to
       the nearest other group, (b - a) / max(a, b), and 0 of a group's only channel. Of the partitions into 2 to
       MAX_JOINTS groups whose mean silhouette is within NEARLY of the best, the one of fewest groups is chosen: a
       single channel that hangs behind the others makes no joint of its own.
    6. The groups are clear when that mean silhouette is at least APART; otherwise nothing is proposed. But where the
       mean |r| between the last two groups is at least ALIKE, all channels are one joint: silhouettes compare distances
       with each other, and would also divide channels that all move alike.

    A joint with two ways to move, such as a shoulder, can make two groups. Joints that were always moved together make
    one. So this is a proposal, which people correct.

    Parameters
    ----------
    values : (n, n_channels) array
        Frames of free movement, in any unit; not finite where a value is missing.
    sample_rate : float
        Hz.

    Returns
    -------
    JointGroups
        With the verdict "short" below SHORTEST seconds, "still" when fewer than two channels moved, "unclear" when
        groups are not apart, "one" when all channels that moved are one group; otherwise "groups".

    References
    ----------
    .. [1] R. R. Sokal, C. D. Michener: A statistical method for evaluating systematic relationships. University of
       Kansas Science Bulletin 38, 1958.
    .. [2] P. J. Rousseeuw: Silhouettes: a graphical aid to the interpretation and validation of cluster analysis.
       Journal of Computational and Applied Mathematics 20, 1987; APART is of L. Kaufman, P. J. Rousseeuw: Finding
       Groups in Data, 1990, chapter 2.
    """
    if len(values) < SHORTEST * max(sample_rate, 1.0 / BLOCK):
        return JointGroups("short")
    rates = _rates(values, sample_rate)
    has_moved = _has_moved(rates)
    moved = np.flatnonzero(has_moved)
    still = tuple(np.flatnonzero(~has_moved).tolist())
    if len(moved) < 2:
        return JointGroups("still", still=still)
    distances = _distances(rates[:, moved])
    partitions, last = _partitions(distances)
    if 1.0 - last >= ALIKE:
        return JointGroups("one", (tuple(moved.tolist()),), still)
    labels, silhouette = _best(distances, partitions)
    if silhouette < APART:
        return JointGroups("unclear", still=still, silhouette=silhouette)
    # Labels come in the order of the groups' first channels.
    groups = tuple(tuple(moved[labels == label].tolist()) for label in dict.fromkeys(labels.tolist()))
    return JointGroups("groups", groups, still, silhouette)


def _rates(values: NDArray[np.float64] | NDArray[np.float32], sample_rate: float) -> NDArray[np.float64]:
    """Return the differences (m, n_channels) of the means of successive blocks, NaN beside a block without values."""
    size = max(1, round(BLOCK * sample_rate))
    count = len(values) // size
    blocks = np.asarray(values[: count * size], dtype=np.float64).reshape(count, size, -1)
    present = np.isfinite(blocks)
    with np.errstate(invalid="ignore"):  # 0 / 0 in a block without values
        means = np.where(present, blocks, 0.0).sum(axis=1) / present.sum(axis=1)
    return np.diff(means, axis=0)


def _has_moved(rates: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return whether each channel (n_channels,) has values nearly always, and successive rates that are alike."""
    present = np.isfinite(rates)
    filled = np.where(present, rates, 0.0)
    filled -= filled.mean(axis=0)
    alike = (filled[1:] * filled[:-1]).sum(axis=0)
    moved: NDArray[np.bool_] = (present.mean(axis=0) >= WHOLE) & (alike > 0.0)
    return moved


def _distances(rates: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return 1 - |correlation| between channels (n, n), 0 on the diagonal, from their rates (m, n)."""
    whole = rates[np.isfinite(rates).all(axis=1)]
    centred = whole - whole.mean(axis=0) if len(whole) else whole
    norms = np.linalg.norm(centred, axis=0)
    unit = np.divide(centred, norms, out=np.zeros_like(centred), where=norms > 0.0)
    distances: NDArray[np.float64] = 1.0 - np.minimum(np.abs(unit.T @ unit), 1.0)
    np.fill_diagonal(distances, 0.0)
    return distances


def _partitions(distances: NDArray[np.float64]) -> tuple[dict[int, NDArray[np.intp]], float]:
    """Return the group of each channel (n,) by the number of groups, and the mean distance of the last two groups.

    A group is named by the index of its first channel.
    """
    between = distances.copy()
    np.fill_diagonal(between, np.inf)
    labels = np.arange(len(distances), dtype=np.intp)
    sizes = np.ones(len(distances))
    partitions, last = {len(labels): labels}, 0.0
    for count in range(len(distances) - 1, 0, -1):
        first, second = sorted(divmod(int(np.argmin(between)), len(distances)))
        last = float(between[first, second])
        both = sizes[first] * between[first] + sizes[second] * between[second]
        between[first] = between[:, first] = both / (sizes[first] + sizes[second])
        between[first, first] = np.inf
        between[second] = between[:, second] = np.inf
        sizes[first] += sizes[second]
        labels = np.where(labels == second, first, labels)
        partitions[count] = labels
    return partitions, last


def _best(distances: NDArray[np.float64], partitions: dict[int, NDArray[np.intp]]) -> tuple[NDArray[np.intp], float]:
    """Return the partition into the fewest groups that is nearly as good as the best one, and its mean silhouette."""
    counts = range(2, min(MAX_JOINTS, len(distances) - 1) + 1)
    silhouettes = {count: _silhouette(distances, partitions[count]) for count in counts}
    best = max(silhouettes.values(), default=0.0)
    chosen = next((count for count in counts if silhouettes[count] >= best - NEARLY), 1)
    return partitions[chosen], silhouettes.get(chosen, 0.0)


def _silhouette(distances: NDArray[np.float64], labels: NDArray[np.intp]) -> float:
    """Return the mean silhouette of a partition into at least two groups."""
    member = labels[:, np.newaxis] == np.unique(labels)  # (n, n_groups)
    sizes = member.sum(axis=0)
    sums = distances @ member
    others = (member @ sizes) - 1  # channels of the own group beside this one
    own = sums[member] / np.maximum(others, 1)
    nearest = np.where(member, np.inf, sums / sizes).min(axis=1)
    larger = np.maximum(own, nearest)
    scores = np.divide(nearest - own, larger, out=np.zeros_like(own), where=(others > 0) & (larger > 0.0))
    return float(scores.mean())

"""The prior as a map is fitted with it: sums over other people, per joint and per ring of sensors."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from app.calibration.prior.arrangement import RingMoments, total
from app.calibration.prior.documents import (
    JointEntry,
    JointSums,
    OwnPrior,
    PersonEntry,
    PriorDocument,
    ReleasedPeople,
)
from app.calibration.prior.moments import Moments
from app.layout import ShirtLayout
from app.texts import Text

Array = NDArray[np.float64]


class PriorError(Exception):
    """A prior cannot be used or released; the message says in one sentence why, and what to do."""


@dataclass(frozen=True, slots=True)
class JointPrior:
    """Sums over people of what each adds to the map of one joint of k channels."""

    people: int
    seconds: float
    strokes: float
    alive: Array  # (k,) people whose channel could be used
    logs: Array  # (k,) sums over those people of the logarithm of the channel's range
    moments: Moments

    def __add__(self, other: Self) -> Self:
        return type(self)(
            self.people + other.people,
            self.seconds + other.seconds,
            self.strokes + other.strokes,
            self.alive + other.alive,
            self.logs + other.logs,
            self.moments + other.moments,
        )

    @property
    def expected(self) -> Array:
        """Mean (k,) of the logarithm of each channel's range; NaN for a channel that nobody could use."""
        with np.errstate(invalid="ignore", divide="ignore"):
            mean: Array = self.logs / self.alive
        return mean

    @property
    def mean(self) -> Moments:
        """The moments as the mean over people."""
        return self.moments * (1.0 / self.people)


Summed = TypeVar("Summed", JointPrior, RingMoments)


@dataclass(frozen=True, slots=True)
class MapPrior:
    """What is known of other people in shirts of one layout."""

    layout: ShirtLayout
    joints: Mapping[str, JointPrior]
    rings: Mapping[str, RingMoments]

    @classmethod
    def of(cls, document: PriorDocument) -> Self:
        """Return the prior of a document."""
        if isinstance(document, OwnPrior):
            people = document.people.values()
            return cls(document.layout, *sums_of(entry.in_layout(document.layout) for entry in people))
        joints = {name: _joint_prior(sums) for name, sums in document.joints.items()}
        return cls(document.layout, joints, {name: ring.moments for name, ring in document.rings.items()})

    def __add__(self, other: Self) -> Self:
        """Return the sums over the people of both, in the layout that has rings; PriorError when the layouts differ."""
        check_layout(other.layout, self.layout)
        layout = self.layout if self.layout.rings else other.layout
        return type(self)(layout, _added(self.joints, other.joints), _added(self.rings, other.rings))

    @property
    def people(self) -> int:
        """How many people the joint with most of them has."""
        return max((joint.people for joint in self.joints.values()), default=0)


def sums_of(entries: Iterable[PersonEntry]) -> tuple[dict[str, JointPrior], dict[str, RingMoments]]:
    """Return the sums over people, per joint and per ring."""
    joints_of_people: dict[str, list[JointEntry]] = {}
    rings: dict[str, list[RingMoments]] = {}
    for entry in entries:
        for name, joint in entry.joints.items():
            joints_of_people.setdefault(name, []).append(joint)
        for name, ring in entry.rings.items():
            rings.setdefault(name, []).append(ring.moments)
    return {name: _sum(joints) for name, joints in joints_of_people.items()}, {
        name: total(ring) for name, ring in rings.items()
    }


def union_of_people(documents: Iterable[PriorDocument]) -> OwnPrior:
    """Return one own prior with the people of several, for use inside of one clinic.

    Raises
    ------
    PriorError
        When one is a release, the layouts differ, or two have different entries of one person.
    """
    layout: ShirtLayout | None = None
    people: dict[str, PersonEntry] = {}
    released = ReleasedPeople()
    for document in documents:
        if not isinstance(document, OwnPrior):
            raise PriorError(Text("calibration-prior-release-own"))
        check_layout(document.layout, layout or document.layout)
        layout = layout if layout is not None and layout.rings else document.layout
        for code, entry in document.people.items():
            if people.get(code, entry) != entry:
                raise PriorError(Text("calibration-prior-two-entries", code=code))
            people[code] = entry
        released += document.released
    if layout is None:
        raise PriorError(Text("calibration-prior-none"))
    return OwnPrior(layout=layout, people=people, released=released)


def check_layout(first: ShirtLayout, second: ShirtLayout) -> None:
    """Raise PriorError when channels or joints of two layouts differ, or their rings where both have rings.

    Their names and pictures may differ.
    """
    rings_differ = first.rings and second.rings and first.rings != second.rings
    if layout_key(first) != layout_key(second) or rings_differ:
        raise PriorError(Text("calibration-prior-layouts", first=first.name, second=second.name))


def layout_key(layout: ShirtLayout) -> tuple[tuple[str, str], ...]:
    """Return the names of the channels with their joints, equal where maps of one layout fit another."""
    return tuple((channel.name, channel.joint) for channel in layout.channels)


def _added(some: Mapping[str, Summed], others: Mapping[str, Summed]) -> dict[str, Summed]:
    both = {name: some[name] + others[name] for name in some.keys() & others.keys()}
    return {**some, **others, **both}


def _sum(entries: list[JointEntry]) -> JointPrior:
    """Return the sum over people; where a channel could not be used, the others are scaled as if it had moved."""
    alive = np.array([entry.alive for entry in entries], dtype=np.float64)
    logs = np.array([entry.logs for entry in entries])
    with np.errstate(invalid="ignore", divide="ignore"):
        expected = logs.sum(axis=0) / alive.sum(axis=0)
    used = alive.sum(axis=0) > 0.0
    parts = []
    for entry in entries:
        entry_alive = np.array(entry.alive)
        level = float(expected[used].mean() - expected[entry_alive].mean())  # 0 when every channel could be used
        parts.append(entry.moments.moments.rescaled(np.full(len(entry_alive), np.exp(-level / 2.0))))
    return JointPrior(
        people=len(entries),
        seconds=sum(entry.seconds for entry in entries),
        strokes=sum(entry.strokes for entry in entries),
        alive=alive.sum(axis=0),
        logs=logs.sum(axis=0),
        moments=reduce(add, parts),
    )


def _joint_prior(sums: JointSums) -> JointPrior:
    return JointPrior(
        sums.people, sums.seconds, sums.strokes, np.array(sums.alive), np.array(sums.logs), sums.moments.moments
    )

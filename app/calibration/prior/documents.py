"""The documents of a prior: one person's moments, a clinic's own prior with an entry per person, a release of sums."""

from collections.abc import Sequence
from typing import Annotated, Literal, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import ConfigDict, Field, model_validator

from app.calibration.linear_map import KINDS
from app.calibration.prior.arrangement import RingMoments
from app.calibration.prior.moments import Moments
from app.calibration.profile import CalibrationProfile
from app.layout import MAX_CHANNELS, ShirtLayout
from app.quantities import Document, Finite, Name
from app.texts import Text

FEWEST_PEOPLE = 4  # whose map is used for somebody else: with two, the worst person had a third of it out of phase
FEWEST_RELEASED = 8  # people whose sum may leave a clinic: the moments of one person alone identify that person
DIGITS = 6  # significant, of every stored number

MOST = KINDS * MAX_CHANNELS
Vector = Annotated[tuple[Finite, ...], Field(max_length=MOST)]
Triangle = Annotated[tuple[Finite, ...], Field(max_length=MOST * (MOST + 1) // 2)]
Amount = Annotated[float, Field(strict=True, allow_inf_nan=False, ge=0, le=1e9)]

Array = NDArray[np.float64]


class PriorPart(Document):
    """Base of the documents here; pydantic compiles each when it is first used, which takes 0.1 s of a start."""

    model_config = ConfigDict(defer_build=True)


class MomentsDocument(PriorPart):
    """Moments of the features of k channels; symmetric matrices as their upper triangles, row by row."""

    gram: Triangle
    moment: Vector
    stroke_mean: Vector
    stroke_gram: Triangle

    @classmethod
    def of(cls, moments: Moments) -> Self:
        """Return the document of `moments`, rounded to DIGITS."""
        upper = np.triu_indices(len(moments.moment))
        return cls(
            gram=rounded(moments.gram[upper]),
            moment=rounded(moments.moment),
            stroke_mean=rounded(moments.stroke_mean),
            stroke_gram=rounded(moments.stroke_gram[upper]),
        )

    @property
    def moments(self) -> Moments:
        """The moments as arrays."""
        return Moments(
            _symmetric(self.gram), np.array(self.moment), np.array(self.stroke_mean), _symmetric(self.stroke_gram)
        )

    @model_validator(mode="after")
    def _sizes_agree(self) -> Self:
        d = len(self.moment)
        if len(self.stroke_mean) != d or {len(self.gram), len(self.stroke_gram)} != {d * (d + 1) // 2} or d % KINDS:
            raise ValueError(Text("calibration-prior-moments"))
        return self


class RingDocument(PriorPart):
    """Sums over people of what tells the sensors of a ring apart; pairs as upper triangles without the diagonal."""

    sensors: Annotated[tuple[Name, ...], Field(max_length=MAX_CHANNELS)] = ()  # names round the limb; (): not noted
    people: Amount
    logs: Vector
    logs_squared: Vector
    pairs: Triangle
    pairs_squared: Triangle

    @classmethod
    def of(cls, ring: RingMoments, sensors: Sequence[str] = ()) -> Self:
        """Return the document of `ring`, rounded to DIGITS; `sensors` names its channels round the limb."""
        upper = np.triu_indices(len(ring.logs), 1)
        return cls(
            sensors=tuple(sensors),
            people=ring.people,
            logs=rounded(ring.logs),
            logs_squared=rounded(ring.logs_squared),
            pairs=rounded(ring.pairs[upper]),
            pairs_squared=rounded(ring.pairs_squared[upper]),
        )

    @property
    def moments(self) -> RingMoments:
        """The sums as arrays."""
        pairs, squares = (_symmetric(part, len(self.logs)) for part in (self.pairs, self.pairs_squared))
        return RingMoments(self.people, np.array(self.logs), np.array(self.logs_squared), pairs, squares)

    @model_validator(mode="after")
    def _sizes_agree(self) -> Self:
        k = len(self.logs)
        if len(self.logs_squared) != k or {len(self.pairs), len(self.pairs_squared)} != {k * (k - 1) // 2}:
            raise ValueError(Text("calibration-prior-ring"))
        return self


class JointEntry(PriorPart):
    """What one person adds to the map of one joint: means over this person's recordings."""

    alive: Annotated[tuple[bool, ...], Field(min_length=1, max_length=MAX_CHANNELS)]  # channels that could be used
    logs: Vector  # logarithms of the channels' ranges; 0 for a channel that could not be used
    seconds: Amount
    strokes: Amount
    moments: MomentsDocument


class PersonEntry(PriorPart):
    """What one person adds to a prior."""

    recordings: Annotated[int, Field(strict=True, ge=1)]
    joints: Annotated[dict[Name, JointEntry], Field(min_length=1)]
    rings: dict[Name, RingDocument] = Field(default_factory=dict)

    def in_layout(self, layout: ShirtLayout) -> "PersonEntry":
        """Return the entry with those of its rings only that are the layout's, sensor by sensor."""
        layout_rings = {ring: tuple(layout.channel_names[i] for i in sensors) for ring, sensors in layout.rings.items()}
        rings = {
            name: ring
            for name, ring in self.rings.items()
            if len(ring.logs) == len(layout_rings.get(name, ())) and ring.sensors in ((), layout_rings[name])
        }
        return self.model_copy(update={"rings": rings})

    def completed(self, earlier: "PersonEntry") -> "PersonEntry":
        """Return this entry with the joints and rings of an earlier one that it does not have itself."""
        joints, rings = {**earlier.joints, **self.joints}, {**earlier.rings, **self.rings}
        return self.model_copy(update={"joints": joints, "rings": rings})


class JointSums(PriorPart):
    """Sums over people of what each adds to the map of one joint."""

    people: Annotated[int, Field(strict=True, ge=FEWEST_RELEASED)]
    seconds: Amount
    strokes: Amount
    alive: Vector  # people whose channel could be used
    logs: Vector  # sums over those people
    moments: MomentsDocument


class ReleasedPeople(PriorPart):
    """The codes of the people of a clinic's own prior whose entries are in a release, per joint and per ring."""

    joints: dict[Name, tuple[Name, ...]] = Field(default_factory=dict)
    rings: dict[Name, tuple[Name, ...]] = Field(default_factory=dict)

    def __add__(self, other: Self) -> Self:
        return type(self)(joints=_both(self.joints, other.joints), rings=_both(self.rings, other.rings))

    def without(self, code: str) -> Self:
        """Return the codes without one."""
        joints, rings = (
            {name: tuple(other for other in codes if other != code) for name, codes in part.items()}
            for part in (self.joints, self.rings)
        )
        return type(self)(joints=joints, rings=rings)


class OwnPrior(PriorPart):
    """A clinic's own prior: one entry per person, so that a person can be taken out again. It never leaves."""

    format: Literal["bodydrive-prior"] = "bodydrive-prior"
    version: Literal[1] = 1
    kind: Literal["own"] = "own"
    layout: ShirtLayout
    people: dict[Name, PersonEntry] = Field(default_factory=dict)
    released: ReleasedPeople = Field(default_factory=ReleasedPeople)  # nobody is released twice

    @model_validator(mode="after")
    def _entries_fit_the_layout(self) -> Self:
        for code, entry in self.people.items():
            where = Text("calibration-prior-entry", code=code)
            for name, joint in entry.joints.items():
                sizes = {len(joint.alive), len(joint.logs), len(joint.moments.moment) // KINDS}
                _check_size(self.layout, where, name, sizes)
            for name, ring in entry.rings.items():
                _check_ring(self.layout, where, name, len(ring.logs))
        return self

    def with_person(self, code: str, entry: PersonEntry) -> "OwnPrior":
        """Return the prior with this person's entry, in place of an earlier one."""
        return self.model_copy(update={"people": {**self.people, code: entry}})

    def with_released(self, people: ReleasedPeople) -> "OwnPrior":
        """Return the prior that knows that these people, as far as they are in it, have been released."""
        strangers = {code for part in (people.joints, people.rings) for codes in part.values() for code in codes}
        for code in strangers - self.people.keys():
            people = people.without(code)
        return self.model_copy(update={"released": self.released + people})

    def without_person(self, code: str) -> "OwnPrior":
        """Return the prior as if this person had never been added."""
        people = {name: entry for name, entry in self.people.items() if name != code}
        return self.model_copy(update={"people": people, "released": self.released.without(code)})


class ReleasedPrior(PriorPart):
    """Sums over at least eight people, in which nobody can be found again: what may leave a clinic."""

    format: Literal["bodydrive-prior"] = "bodydrive-prior"
    version: Literal[1] = 1
    kind: Literal["release"] = "release"
    layout: ShirtLayout
    people: Annotated[int, Field(strict=True, ge=FEWEST_RELEASED)]
    joints: Annotated[dict[Name, JointSums], Field(min_length=1)]
    rings: dict[Name, RingDocument] = Field(default_factory=dict)

    @model_validator(mode="after")
    def _sums_fit_the_layout(self) -> Self:
        where = Text("calibration-prior-release")
        for name, joint in self.joints.items():
            sizes = {len(joint.alive), len(joint.logs), len(joint.moments.moment) // KINDS}
            _check_size(self.layout, where, name, sizes)
        for name, ring in self.rings.items():
            _check_ring(self.layout, where, name, len(ring.logs))
        return self


PriorDocument = Annotated[OwnPrior | ReleasedPrior, Field(discriminator="kind")]


def fitting_part(entry: PersonEntry, profile: CalibrationProfile) -> PersonEntry | None:
    """Return the entry without each ring whose detected arrangement differs from other people's, and without its joint.

    The sensors of such a ring lie where other people have other sensors. None when no joint is left.
    """
    arrangements = {
        joint.name: {**joint.prior.arrangement, **joint.prior.as_worn} for joint in profile.joints if joint.prior
    }
    turned = {joint: rings for joint, rings in arrangements.items() if rings}
    joints = {name: joint for name, joint in entry.joints.items() if name not in turned}
    out = {ring for rings in turned.values() for ring in rings}
    rings = {name: ring for name, ring in entry.rings.items() if name not in out}
    return entry.model_copy(update={"joints": joints, "rings": rings}) if joints else None


def rounded(numbers: Array) -> tuple[float, ...]:
    """Return the numbers (n,) with DIGITS significant digits."""
    return tuple(float(f"{number:.{DIGITS}g}") for number in numbers.tolist())


def _both(some: dict[str, tuple[str, ...]], others: dict[str, tuple[str, ...]]) -> dict[str, tuple[str, ...]]:
    return {name: tuple(sorted({*some.get(name, ()), *others.get(name, ())})) for name in sorted({*some, *others})}


def _symmetric(triangle: tuple[float, ...], size: int | None = None) -> Array:
    """Return the matrix of an upper triangle; with `size`, one without its diagonal, which becomes 0."""
    offset = 0 if size is None else 1
    side = round((np.sqrt(8 * len(triangle) + 1) - 1) / 2) if size is None else size
    matrix = np.zeros((side, side))
    upper = np.triu_indices(side, offset)
    matrix[upper] = triangle
    matrix.T[upper] = triangle
    return matrix


def _check_size(layout: ShirtLayout, where: Text, joint: str, sizes: set[int]) -> None:
    if joint not in layout.joint_names:
        raise ValueError(Text("calibration-prior-unknown-joint", where=where, joint=joint, layout=layout.name))
    if sizes != {len(layout.channels_of_joint[joint])}:
        raise ValueError(Text("calibration-prior-size", where=where, joint=joint))


def _check_ring(layout: ShirtLayout, where: Text, ring: str, size: int) -> None:
    if len(layout.rings.get(ring, ())) != size:
        raise ValueError(Text("calibration-prior-ring-size", where=where, count=size, ring=ring, layout=layout.name))

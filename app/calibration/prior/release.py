"""What may leave a clinic: sums over at least eight people, each person in one release only.

Sums can be subtracted from each other: two releases that differ by one person would show that person. Releases that
share nobody can only be added up, which is what `merge` does with them.
"""

from collections.abc import Iterable, Mapping
from functools import reduce
from operator import add
from typing import NamedTuple, TypeVar

from app.calibration.prior.documents import (
    FEWEST_RELEASED,
    JointSums,
    MomentsDocument,
    OwnPrior,
    PriorDocument,
    ReleasedPeople,
    ReleasedPrior,
    RingDocument,
    rounded,
)
from app.calibration.prior.map_prior import JointPrior, MapPrior, PriorError, sums_of, union_of_people
from app.texts import Text

Part = TypeVar("Part")


class Release(NamedTuple):
    """A release, and whose entries of its own a clinic must not release again."""

    document: ReleasedPrior
    people: ReleasedPeople
    left_out: tuple[str, ...]  # joints of which fewer than eight people are in no release yet


def release(documents: Iterable[PriorDocument]) -> Release:
    """Return the sums over one or several priors of one layout, as far as they may leave the clinic.

    Of an own prior, those people count who are in no release yet, joint by joint; eight of them must come together,
    because a release that is added to them can be subtracted again.

    Raises
    ------
    PriorError
        When the layouts differ, two own priors have different entries of one person, or no joint has eight people.
    """
    priors = list(documents)
    sums = [MapPrior.of(document) for document in priors if isinstance(document, ReleasedPrior)]
    people, left_out = ReleasedPeople(), set[str]()
    own_priors = [document for document in priors if isinstance(document, OwnPrior)]
    if own_priors:
        united = union_of_people(own_priors)
        people = _new_people(united)
        if not people.joints:
            raise PriorError(_too_few(united))
        left_out = {name for entry in united.people.values() for name in entry.joints} - people.joints.keys()
        sums.append(_sums_over(united, people))
    everybody = reduce(add, sums)
    document = ReleasedPrior(
        layout=everybody.layout,
        people=everybody.people,
        joints={name: _joint_sums(joint) for name, joint in everybody.joints.items()},
        rings={name: RingDocument.of(ring) for name, ring in everybody.rings.items()},
    )
    return Release(document, people, tuple(sorted(left_out)))


def _new_people(prior: OwnPrior) -> ReleasedPeople:
    """Return the codes of the people who are in no release yet, of joints and rings that have eight of them."""
    joints = {code: entry.joints for code, entry in prior.people.items()}
    rings = {code: entry.rings for code, entry in prior.people.items()}
    return ReleasedPeople(
        joints=_eight_or_more(joints, prior.released.joints), rings=_eight_or_more(rings, prior.released.rings)
    )


def _eight_or_more(
    parts: Mapping[str, Mapping[str, Part]], released: Mapping[str, tuple[str, ...]]
) -> dict[str, tuple[str, ...]]:
    """Return {part: codes} of the parts with enough people in no release; `parts` is {code: {part: what is stored}}."""
    new: dict[str, tuple[str, ...]] = {}
    for code, names in parts.items():
        for name in names:
            if code not in released.get(name, ()):
                new[name] = (*new.get(name, ()), code)
    return {name: codes for name, codes in new.items() if len(codes) >= FEWEST_RELEASED}


def _sums_over(prior: OwnPrior, people: ReleasedPeople) -> MapPrior:
    """Return the sums over these people, joint by joint and ring by ring."""
    chosen = [
        entry.model_copy(
            update={
                "joints": {name: part for name, part in entry.joints.items() if code in people.joints.get(name, ())},
                "rings": {name: part for name, part in entry.rings.items() if code in people.rings.get(name, ())},
            }
        )
        for code, entry in prior.people.items()
    ]
    return MapPrior(prior.layout, *sums_of(chosen))


def _too_few(prior: OwnPrior) -> Text:
    count = len(prior.people)
    if any(prior.released.joints.values()):
        return Text("calibration-prior-few-new", count=count, least=FEWEST_RELEASED)
    return Text("calibration-prior-few-released", count=count, least=FEWEST_RELEASED)


def _joint_sums(joint: JointPrior) -> JointSums:
    return JointSums(
        people=joint.people,
        seconds=round(joint.seconds, 2),
        strokes=joint.strokes,
        alive=rounded(joint.alive),
        logs=rounded(joint.logs),
        moments=MomentsDocument.of(joint.moments),
    )

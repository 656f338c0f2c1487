"""The shirt of a calibration, and the prior that other people's movements in such a shirt give."""

import hashlib
import json
from typing import NamedTuple, Protocol

from app.calibration.prior.documents import PersonEntry, ReleasedPrior
from app.calibration.prior.map_prior import MapPrior, layout_key
from app.calibration.prior.shipped import SHIPPED_SEED, shipped_prior
from app.layout import ShirtLayout
from app.source import OWN_GROUPS, SourceGroup


class Garment(NamedTuple):
    """What must be equal so that other people's movements can be used for a patient.

    Rings need not be equal: they may be added to a layout later.
    """

    layout: ShirtLayout
    group: SourceGroup  # of the shirt
    seed: int | None  # of a simulated shirt: each seed is a different one

    @property
    def hash(self) -> str:
        """SHA-256, hex."""
        # None twice: stored hashes have the places of a ring and of a place in it, which do not count.
        key: list[object] = [[(*channel, None, None) for channel in layout_key(self.layout)], self.seed]
        if self.group in OWN_GROUPS:
            key.append(self.group)
        return hashlib.sha256(json.dumps(key).encode()).hexdigest()

    @property
    def simulated(self) -> bool:
        """Whether nobody wears the shirt."""
        return self.group == "simulated"

    @property
    def shipped_prior(self) -> ReleasedPrior | None:
        """The prior that ships with this shirt; None for a worn shirt, and for another simulated one."""
        return shipped_prior(self.layout) if self.simulated and self.seed == SHIPPED_SEED else None


class OthersPrior(Protocol):
    """The prior from other people for the patient of a session, to which this patient can be added."""

    def people(self, session_id: int, garment: Garment) -> int:
        """Return how many other people are known in this shirt; 0 when they are too few, or the owner wants none."""

    def of_others(self, session_id: int, garment: Garment) -> MapPrior | None:
        """Return what is known of other people in this shirt; None when they are too few, or the owner wants none."""

    def may_learn(self, session_id: int, garment: Garment) -> bool:
        """Return whether the calibration of a session may add to what is known."""

    def add(self, session_id: int, garment: Garment, entry: PersonEntry) -> None:
        """Store what the patient of a session adds."""


class NobodyElse:
    """The prior of a program without a feature that stores what people add: it is empty, and stays so."""

    def people(self, _session_id: int, _garment: Garment) -> int:
        """Return 0."""
        return 0

    def of_others(self, _session_id: int, _garment: Garment) -> MapPrior | None:
        """Return None."""
        return None

    def may_learn(self, _session_id: int, _garment: Garment) -> bool:
        """Return False."""
        return False

    def add(self, _session_id: int, _garment: Garment, _entry: PersonEntry) -> None:
        """Store nothing."""

"""The source of a recording: its shirt, the body inside a simulated shirt, its chair; and its description."""

from collections.abc import Mapping
from typing import Annotated, Literal

from pydantic import Field, ValidationError

from app.quantities import Document

UNKNOWN = "unknown"

Kind = Annotated[str, Field(min_length=1, max_length=32)]
SourceGroup = Literal["worn", "simulated", "unknown"]
"""Trials of different groups are never in one curve, one assessment or one warning."""

SHIRT_NAMES = {"simulator": "Simulated shirt", "replay": "Recorded signals", "udp": "Worn shirt"}
BODY_NAMES = {"person": "simulated person", "visitor": "moved on the screen", "recorded": "recorded body"}
CHAIR_NAMES = {"virtual": "virtual chair", "udp": "real chair", UNKNOWN: "chair not recorded"}


class Source(Document):
    """The origin of a recording's signals, and the chair that they drove."""

    shirt: Kind  # a shirt's kind (docs/protocols.md, section 2), or "unknown"
    body: Kind | None  # kind of the body inside the simulated shirt; None: no simulated body
    chair: Kind  # "virtual", "udp" (a real one), or "unknown"
    simulated: bool | None  # whether nobody wore the shirt; None: unknown

    @property
    def group(self) -> SourceGroup:
        """Return the group of trials that a trial of this source is compared with."""
        if self.simulated is None:
            return "unknown"
        return "simulated" if self.simulated else "worn"


def source_description(source: Source) -> str:
    """Return the description of a source on pages, in reports and in exports."""
    if source.shirt == UNKNOWN:
        shirt = "Shirt not recorded"
    else:
        shirt = SHIRT_NAMES.get(source.shirt, f"Shirt of the kind '{source.shirt}'")
    body = "" if source.body is None else f" ({BODY_NAMES.get(source.body, source.body)})"
    chair = CHAIR_NAMES.get(source.chair, f"chair of the kind '{source.chair}'")
    practice = ": practice only" if source.simulated else ""
    return f"{shirt}{body}, {chair}{practice}"


STUDY_SOURCE = Source(shirt="simulator", body="person", chair="virtual", simulated=True)  # of all studies
UNKNOWN_SOURCE = Source(shirt=UNKNOWN, body=None, chair=UNKNOWN, simulated=None)


def source_of_header(header: Mapping[str, object]) -> Source:
    """Return the source in the header of a recording (`run.json`); an unknown one when the header cannot be read."""
    try:
        return Source.model_validate(header.get("source"))
    except ValidationError:
        return UNKNOWN_SOURCE

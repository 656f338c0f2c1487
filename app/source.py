"""The source of a recording: its shirt, the body inside a simulated shirt, its chair; and its description."""

from collections.abc import Mapping
from typing import Annotated, Final, Literal

from pydantic import Field, ValidationError

from app.quantities import Document
from app.texts import Text

UNKNOWN = "unknown"

Kind = Annotated[str, Field(min_length=1, max_length=32)]
SourceGroup = Literal["worn", "camera", "phones", "slimevr", "bluetooth", "brainflow", "lsl", "simulated", "unknown"]
"""Trials of different groups are never in one curve, one assessment or one warning."""

OWN_GROUPS: Final[Mapping[str, SourceGroup]] = {
    "camera": "camera",
    "phones": "phones",
    "slimevr": "slimevr",
    "bluetooth": "bluetooth",
    "brainflow": "brainflow",
    "lsl": "lsl",
}
"""The kinds of shirts that measure a body in another way than a worn shirt, each with the group of its own."""

NAMED_SHIRTS = frozenset({*OWN_GROUPS, "simulator", "serial", "udp", "replay", UNKNOWN})
NAMED_BODIES = frozenset({"person", "visitor", "recorded"})
NAMED_CHAIRS = frozenset({"virtual", "udp", UNKNOWN})


def source_group(shirt: str, simulated: bool | None) -> SourceGroup:
    """Return the group of a kind of shirt; `simulated` says whether nobody wore it, None: unknown."""
    if simulated is None:
        return "unknown"
    return "simulated" if simulated else OWN_GROUPS.get(shirt, "worn")


class Source(Document):
    """The origin of a recording's signals, and the chair that they drove."""

    shirt: Kind  # a shirt's kind (docs/protocols.md, section 2), or "unknown"
    body: Kind | None  # kind of the body inside the simulated shirt; None: no simulated body
    chair: Kind  # "virtual", "udp" (a real one), or "unknown"
    simulated: bool | None  # whether nobody wore the shirt; None: unknown

    @property
    def group(self) -> SourceGroup:
        """Return the group of trials that a trial of this source is compared with."""
        return source_group(self.shirt, self.simulated)


def source_description(source: Source) -> str:
    """Return the description of a source on pages, in reports and in exports, in the reader's language."""
    shirt, chair = Text("source-other-shirt", kind=source.shirt), Text("source-other-chair", kind=source.chair)
    if source.shirt in NAMED_SHIRTS:
        shirt = Text(f"source-shirt-{source.shirt}")
    if source.chair in NAMED_CHAIRS:
        chair = Text(f"source-chair-{source.chair}")
    if source.body is not None:
        body = Text(f"source-body-{source.body}") if source.body in NAMED_BODIES else source.body
        shirt = Text("source-with-body", shirt=shirt, body=body)
    signals = Text("source-signals", shirt=shirt, chair=chair)
    return str(Text("source-practice-only", source=signals) if source.simulated else signals)


STUDY_SOURCE = Source(shirt="simulator", body="person", chair="virtual", simulated=True)  # of all studies
UNKNOWN_SOURCE = Source(shirt=UNKNOWN, body=None, chair=UNKNOWN, simulated=None)


def source_of_header(header: Mapping[str, object]) -> Source:
    """Return the source in the header of a recording (`run.json`); an unknown one when the header cannot be read."""
    try:
        return Source.model_validate(header.get("source"))
    except ValidationError:
        return UNKNOWN_SOURCE

"""What a feature gives to the rest of the program, and the features that are registered.

The rest of the program imports no feature: it asks `features()` for what they give. Each feature says it in its
`feature.py`, as one `Feature` named FEATURE.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import datetime
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, Protocol

from sqlalchemy import ColumnElement
from sqlalchemy.orm import Session

from app.features import names
from app.store.tables import PatientSession, Table
from app.texts import Text

if TYPE_CHECKING:
    from fastapi import APIRouter

    from app.api.parts import Parts
    from app.computing_process import ComputingProcess
    from app.news import Notify
    from app.scoring.verdict.spread import SpreadsOf
    from app.session.calibration.garment import OthersPrior
    from app.session.control_link import ControlLink
    from app.session.run_flow import RunFlow
    from app.session.runs import SessionRuns
    from app.settings import Settings
    from app.store.consent import Consent
    from app.store.database import Database

    MakeFlow = Callable[[Database, ControlLink, SessionRuns, Notify, ComputingProcess], RunFlow[Any]]
    MakeBackground = Callable[[Parts, Notify], "Background"]

    MakeReport = Callable[[], bytes]
    ReportOf = Callable[[Database, Settings, int, SpreadsOf], MakeReport | None]

EventKind = Literal[
    "begin",
    "calibration",
    "map",
    "parameters",
    "trial",
    "test",
    "stop",
    "drive",
    "note",
    "comment",
    "sign-off",
    "unlock",
    "end",
]
Reason = Literal["drive", "deterioration", "halted", "comment", "unsigned", "absent"]


class StoryEvent(NamedTuple):
    """One thing that happened in a session, or was written about it."""

    at: datetime
    kind: EventKind
    person: str | None  # who did or said it; None: not recorded
    text: Text | str  # what was said, or a title; what a person wrote is in their words
    facts: dict[str, Any]  # by names that the page puts into words


class Attention(NamedTuple):
    """One reason why somebody should look at a patient."""

    reason: Reason
    number: int  # of drives, trials, comments, sessions or days
    session_id: int | None  # where to look
    trial_id: int | None
    sentence: Text | None = None  # of a deterioration


class TrialRemark(Protocol):
    """What somebody said about a moment of a trial, for a report."""

    @property
    def session_id(self) -> int:
        """Return the session of the trial."""

    @property
    def floorplan_title(self) -> Text | str:
        """Return the title of the trial's floor plan."""

    @property
    def number(self) -> int:
        """Return the number of the trial."""

    @property
    def person(self) -> str:
        """Return the name of the author."""

    @property
    def t(self) -> float:
        """Return the moment on the time line of the trial (s)."""

    @property
    def text(self) -> str:
        """Return what was said."""

    @property
    def written(self) -> datetime:
        """Return when it was said."""

    @property
    def revised(self) -> datetime | None:
        """Return when its text was changed last, None when it never was."""


class Background(Protocol):
    """A part that runs from the start of the web process to its end."""

    def start(self) -> None:
        """Begin."""

    async def close(self) -> None:
        """End what runs."""


def _complete(_db: Session, _rows: list[dict[str, Any]]) -> None:
    """Add nothing to the rows of a table."""


@dataclass(frozen=True, slots=True)
class ArchivedTable:
    """A table whose rows go along in the archive of a patient."""

    kind: type[Table]
    by: str  # the column by which its rows are found: it names a row of a table before it
    forms: Mapping[str, Any] = field(default_factory=dict)  # of columns whose type does not say it
    complete: Callable[[Session, list[dict[str, Any]]], None] = _complete  # adds what only this clinic knows


def _nothing(_db: Session) -> None:
    """Listen to nothing."""


def _no_parts(_parts: "Parts") -> None:
    """Add nothing to the parts of the web process."""


def _no_matter(_db: Session, _patient_id: int, _consent: "Consent") -> None:
    """Leave everything as it is."""


def _no_lock(_db: Session, _session_id: int) -> Text | None:
    return None


def _no_events(_db: Session, _session: PatientSession) -> Iterator[StoryEvent]:
    return iter(())


def _no_attention(_db: Session, _person_id: int) -> Iterator[tuple[int, Attention]]:
    return iter(())


def _no_remarks(_db: Session, _patient_id: int) -> Sequence[TrialRemark]:
    return ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Feature:
    """What a feature gives: its tables, its routes, and what it adds to what others show."""

    tables: tuple[type[Table], ...] = ()
    routes: tuple[str, ...] = ()  # modules in its folder, each with a `router`; only the web application imports them

    flow: "MakeFlow | None" = None
    """Returns what starts runs of its own in a session and follows them, beside trials and drives."""
    background: "MakeBackground | None" = None
    """Returns what runs as long as the web process, which gives it its parts (some are added later, before anything
    starts), and what tells the pages that something changed."""
    add_parts: "Callable[[Parts], None]" = _no_parts
    """Adds its own long-lived parts to those of the web process."""

    archived: tuple[ArchivedTable, ...] = ()
    not_archived: Mapping[str, str] = field(default_factory=dict)  # its other tables, with the reason

    of_incidents: tuple[type[Table], ...] = ()  # of patients, by `patient_id`: an incident's archive holds their rows

    begin: Callable[[Session], None] = _nothing
    """Called with each transaction that begins: it may listen to what is written."""
    why_locked: Callable[[Session, int], Text | None] = _no_lock
    """Of a session: the sentence why nothing of it may be changed, None when it may."""
    consented: "Callable[[Consent], ColumnElement[bool]] | None" = None
    """The condition that the patient of a query (`Patient`) has given a consent; None: it keeps no consents."""
    consent_withdrawn: "Callable[[Session, int, Consent], None]" = _no_matter
    """Called when a patient has withdrawn a consent."""
    prior: "Callable[[Database], OthersPrior] | None" = None
    """Returns what is known of other people, for calibrations."""
    story: Callable[[Session, PatientSession], Iterator[StoryEvent]] = _no_events
    attention: Callable[[Session, int], Iterator[tuple[int, Attention]]] = _no_attention
    """Of a clinic, for a person: yields patients, each with a reason to look at them."""
    remarks: Callable[[Session, int], Sequence[TrialRemark]] = _no_remarks
    """Of a patient."""
    report: "ReportOf | None" = None
    """Of a clinic's patient: returns what makes the report of the course as HTML, None without a session."""


@cache
def features() -> Mapping[str, Feature]:
    """Return the features that the program has, by name."""
    return {name: import_module(f"app.features.{name}.feature").FEATURE for name in names()}


def feature_routers() -> Iterator["APIRouter"]:
    """Yield the routers of all features."""
    for name, feature in features().items():
        for module in feature.routes:
            yield import_module(f"app.features.{name}.{module}").router


def report_for_archive(
    database: "Database", settings: "Settings", patient_id: int, spreads_of: "SpreadsOf"
) -> "MakeReport | None":
    """Return what makes the report that an archive holds; None: there is none."""
    reports = (
        feature.report(database, settings, patient_id, spreads_of)
        for feature in features().values()
        if feature.report is not None
    )
    return next(reports, None)

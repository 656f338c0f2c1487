"""The report of a session or of a course of sessions, as a document in one language: its texts and drawings.

Both renderers show this document and the labels of `LABELS`, and add nothing of their own.
"""

from dataclasses import dataclass
from typing import Final, Literal

from app.texts import Text

Form = Literal["pdf", "html"]
Paper = Literal["a4", "us-letter"]
Tone = Literal["good", "bad", ""]

LABELS: Final = {
    "source": Text("report-source"),
    "goal": Text("report-goal"),
    "goals_between": Text("report-goals-between"),
    "trials": Text("report-trials"),
    "no_trial": Text("report-no-trial"),
    "tests": Text("report-tests"),
    "drives": Text("report-drives"),
    "condition": Text("report-condition"),
    "scales": Text("report-scales"),
    "no_scale": Text("report-no-scale"),
    "sessions": Text("report-sessions"),
    "notes": Text("report-notes"),
    "comments": Text("report-comments"),
    "signature": Text("report-signature"),
    "signature_line": Text("report-signature-line"),
    "measure": Text("report-measures-measure"),
    "now": Text("report-measures-now"),
    "band": Text("report-measures-band"),
    "verdict": Text("report-measures-verdict"),
    "trajectories": Text("report-trajectories-title"),
}
"""Headings and labels of every report."""


@dataclass(frozen=True, slots=True)
class Fact:
    """A name and its value."""

    name: str
    value: str


@dataclass(frozen=True, slots=True)
class Drawing:
    """A drawing as SVG, without words of people; `description` is for those who do not see it."""

    svg: str
    description: str


@dataclass(frozen=True, slots=True)
class MeasureRow:
    """One measure: its level in what is reported, the earlier one, and the verdict on the difference."""

    name: str
    now: str
    before: str  # "" when there is nothing to compare with
    noise: str  # the band in which a level is within noise; "" without one
    verdict: str
    tone: Tone
    drawing: Drawing | None  # of the band, and both levels


@dataclass(frozen=True, slots=True)
class TaskReport:
    """One task: a path of a floor plan, with the trials of one source."""

    title: str
    lead: str  # how many trials counted, and which sessions are compared
    before: str  # head of the column of the earlier levels; "" without one
    measures: tuple[MeasureRow, ...]
    trajectories: Drawing | None
    trajectories_description: str
    curve: Drawing | None
    curve_title: str
    curve_description: str
    sentences: tuple[str, ...]  # on a deterioration, on the curve and on its sessions
    statistics: tuple[str, ...]  # behind these sentences, in small print


@dataclass(frozen=True, slots=True)
class Remark:
    """A text that a person wrote, and by whom and when."""

    head: str
    text: str


@dataclass(frozen=True, slots=True)
class ReportTable:
    """A table of words."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


NO_TABLE: Final = ReportTable((), ())


@dataclass(frozen=True, slots=True)
class InterfaceTestReport:
    """The two-minute tests of one kind of source."""

    lead: str  # how many there are, and of which source
    table: ReportTable


@dataclass(frozen=True, slots=True)
class Report:
    """Everything that a report shows."""

    title: str
    code: str  # of the patient
    clinic: str
    made: str  # when
    practice: bool  # whether a signal was simulated, which a reader must see first
    source: str
    facts: tuple[Fact, ...]  # who, when
    goals: tuple[Remark, ...]  # of a course, the first and the newest one
    other_goals: tuple[Remark, ...]  # of a course, those between them
    condition: tuple[Fact, ...]
    controls: ReportTable  # which movement does what, with its gains
    condition_note: str
    tasks: tuple[TaskReport, ...]
    tests: tuple[InterfaceTestReport, ...]  # two-minute tests, one for each kind of source
    drives: ReportTable  # of real chairs; without rows when there was none
    sessions: ReportTable  # of a course; without rows for one session
    scales: ReportTable
    notes: tuple[Remark, ...]
    comments: tuple[Remark, ...]  # on moments of trials; empty when there are none
    signed: str  # a sentence; "" when nobody has signed off: then there is a line to sign on
    identity: tuple[Fact, ...]  # software, parameter set, head of the log
    explanation: str
    missing: str = ""  # the characters that the fonts of a PDF do not have

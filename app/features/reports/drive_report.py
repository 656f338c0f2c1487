"""The drives of real chairs in a report: each of a session, or a row for each session of a course."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Final

from app.features.reports.document import NO_TABLE, ReportTable
from app.source import Source, SourceGroup
from app.store.database import Transaction
from app.store.drives import drives_of
from app.store.tables import PairedChair
from app.texts import Figure, Text, value_text

SESSION_HEAD: Final = (
    *(Text("report-drives-drive"), Text("report-drives-chair"), Text("report-drives-begun")),
    *(Text("report-drives-lasted"), Text("report-drives-distance"), Text("report-drives-end")),
)
COURSE_HEAD: Final = (
    *(Text("report-drives-session"), Text("report-drives-count"), Text("report-drives-chairs")),
    *(Text("report-drives-lasted"), Text("report-drives-distance"), Text("report-drives-faults")),
)
ENDS: Final = {"by hand": Text("report-drive-ended"), "fault": Text("report-drive-fault")}


@dataclass(frozen=True, slots=True)
class ReportedDrive:
    """One drive of a real chair."""

    session: int  # number
    chair: str
    started: datetime
    ended: datetime | None
    end: str | None
    distance: float | None  # m; None: the chair reported none
    group: SourceGroup
    source: Source
    parameters_id: int


def reported_drives(db: Transaction, patient_id: int, sessions: dict[int, int]) -> list[ReportedDrive]:
    """Return a patient's drives in the reported sessions, in the order driven; `sessions` are their numbers by id."""
    return [
        ReportedDrive(
            session=sessions[drive.session_id],
            chair=db.get_one(PairedChair, drive.chair_id).name,
            started=drive.started,
            ended=drive.ended,
            end=drive.end,
            distance=drive.distance,
            group=drive.source.group,
            source=drive.source,
            parameters_id=drive.parameters_id,
        )
        for drive in drives_of(db, patient_id)
        if drive.session_id in sessions
    ]


def drives_table(drives: Sequence[ReportedDrive], *, course: bool) -> ReportTable:
    """Return the table of the drives; an empty one when there was none."""
    if not drives:
        return NO_TABLE
    if not course:
        rows = tuple(_row(number, drive) for number, drive in enumerate(drives, start=1))
        return ReportTable(tuple(map(str, SESSION_HEAD)), rows)
    of: dict[int, list[ReportedDrive]] = {}
    for drive in drives:
        of.setdefault(drive.session, []).append(drive)
    rows = tuple(_session_row(session, session_drives) for session, session_drives in of.items())
    return ReportTable(tuple(map(str, COURSE_HEAD)), rows)


def _row(number: int, drive: ReportedDrive) -> tuple[str, ...]:
    ended = ENDS.get(drive.end or "", Text("report-drive-end-unknown"))
    return (
        str(number),
        drive.chair,
        value_text(drive.started.astimezone().time()),
        _duration([drive]),
        _distance([drive]),
        str(Text("report-drive-goes-on") if drive.ended is None else ended),
    )


def _session_row(session: int, drives: list[ReportedDrive]) -> tuple[str, ...]:
    halted = sum(drive.end == "fault" for drive in drives)
    return (
        str(session),
        str(len(drives)),
        ", ".join(dict.fromkeys(drive.chair for drive in drives)),
        _duration(drives),
        _distance(drives),
        str(halted or ""),
    )


def _duration(drives: Iterable[ReportedDrive]) -> str:
    seconds = [(drive.ended - drive.started).total_seconds() for drive in drives if drive.ended is not None]
    if not seconds:
        return ""
    minutes, rest = divmod(round(sum(seconds)), 60)
    if not minutes:
        return str(Text("report-drive-seconds", seconds=rest))
    return str(Text("report-drive-minutes", minutes=minutes, seconds=rest))


def _distance(drives: Iterable[ReportedDrive]) -> str:
    distances = [drive.distance for drive in drives if drive.distance is not None]
    if not distances:
        return str(Text("report-drive-distance-unknown"))
    return str(Text("report-drive-distance", distance=Figure(sum(distances), 1)))

"""How much time has really passed: what is erased after days must not go because the clock was set forward.

The time of the wall clock is compared with the count of the machine's monotonic clock, which goes on while the machine
runs or sleeps, also when the program does not run. Nothing counts while the machine is off: each start of it counts as
one day at most. By how much the wall clock has gone on beyond that is taken off again for 30 days that were counted.
So what is erased after 30 days has waited for 30 counted days, whatever the clock was set to.
"""

import sqlite3
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Final

from sqlalchemy import NullPool, create_engine, select
from sqlalchemy.orm import Session

from app.clock import boot_name, monotonic, utc_now
from app.store.keeping.keeping_tables import PassedTime
from app.store.log import write_log
from app.store.tables import LogEntry
from app.texts import Text

DAY: Final = 86_400.0  # s
TAKEN_OFF_FOR: Final = 30 * DAY  # of counted time; nothing that is erased by itself waits for longer
COUNTED_AT_A_START: Final = DAY
LONGEST_JUMP: Final = DAY  # of counted time: what the clock runs too fast within it is one jump
REPORTED_RUNNING: Final = 3600.0  # s; the machine was on: the clock was set
REPORTED_STARTED: Final = 4 * DAY  # s; longer than a weekend: the clock was set, or the machine was off
REPORTED_BACK: Final = 3600.0  # s


@dataclass(frozen=True, slots=True)
class Reading:
    """What the clocks of the machine say at one moment."""

    wall: datetime
    count: float  # s, of the monotonic clock
    boot: str  # the start of the machine in which it counts; empty: unknown


@dataclass(frozen=True, slots=True)
class Jump:
    """By how much the wall clock went on beyond the time that was counted."""

    by: float  # s
    counted: float  # s that have passed since
    told: bool  # large enough for people to be told


@dataclass(frozen=True, slots=True)
class Passed:
    """The last look at the clocks, with the jumps forward that are taken off."""

    reading: Reading
    jumps: tuple[Jump, ...] = ()

    @property
    def now(self) -> datetime:
        """Return the time up to which time has passed; behind the wall clock after a jump."""
        try:
            return self.reading.wall - timedelta(seconds=sum(jump.by for jump in self.jumps))
        except OverflowError:
            return datetime.min.replace(tzinfo=UTC)


def compare_clocks(last: Passed | None, now: Reading) -> tuple[Passed, float]:
    """Return the look that follows `last`, and by how many seconds the clock jumped, 0 when nobody need be told."""
    if last is None:
        return Passed(now), 0.0
    gone_on = (now.wall - last.reading.wall).total_seconds()
    running = now.boot == last.reading.boot != "" and now.count >= last.reading.count
    counted = now.count - last.reading.count if running else min(max(gone_on, 0.0), COUNTED_AT_A_START)
    older = [replace(jump, counted=jump.counted + counted) for jump in last.jumps]
    jumps = [jump for jump in older if jump.counted < TAKEN_OFF_FOR]
    beyond = gone_on - counted
    is_reported = beyond >= (REPORTED_RUNNING if running else REPORTED_STARTED)
    if beyond > 0:
        joins = bool(jumps) and not is_reported and not jumps[-1].told and jumps[-1].counted < LONGEST_JUMP
        before = jumps.pop() if joins else Jump(0.0, 0.0, is_reported)
        jumps.append(replace(before, by=before.by + beyond))
    return Passed(now, tuple(jumps)), beyond if is_reported or beyond <= -REPORTED_BACK else 0.0


def passed_now(db: Session) -> datetime:
    """Return the time up to which time has passed: what is erased after days is due by it, not by the wall clock."""
    return compare_clocks(_last(db), _reading())[0].now


def passed_of(file: Path) -> datetime:
    """Return the time up to which time has passed, of a database that is only read."""
    uri = f"{file.resolve().as_uri()}?mode=ro"
    engine = create_engine("sqlite://", creator=lambda: sqlite3.connect(uri, uri=True), poolclass=NullPool)
    with Session(engine) as db:
        return passed_now(db)


def store_clocks(db: Session) -> None:
    """Store what the clocks say, and log a jump of the wall clock."""
    passed, jump = compare_clocks(_last(db), _reading())
    row = db.get(PassedTime, 1) or PassedTime(id=1)
    row.wall, row.count, row.boot = passed.reading.wall, passed.reading.count, passed.reading.boot
    row.jumps = [{"by": jump.by, "counted": jump.counted, "told": jump.told} for jump in passed.jumps]
    db.add(row)
    if jump:
        write_log(db, None, "clock jumped", seconds=round(jump))


def clock_warning(db: Session) -> Text | None:
    """Return that the wall clock went forward, while that keeps back what is to be erased; None: it does not."""
    jumps = compare_clocks(_last(db), _reading())[0].jumps
    days = sum(jump.by for jump in jumps if jump.told) / DAY
    if not days:
        return None
    return Text("store-clock-hours", hours=round(days * 24)) if days < 2 else Text("store-clock-days", days=round(days))


def _reading() -> Reading:
    return Reading(utc_now(), monotonic(), boot_name())


def _last(db: Session) -> Passed | None:
    """Return the last look; before the first one the newest row of the log says when the program ran."""
    row = db.get(PassedTime, 1)
    if row is not None:
        return Passed(Reading(row.wall, row.count, row.boot), tuple(Jump(**jump) for jump in row.jumps))
    logged = _logged(db)
    return None if logged is None else Passed(Reading(logged, 0.0, ""))


def _logged(db: Session) -> datetime | None:
    return db.scalar(select(LogEntry.at).order_by(LogEntry.id.desc()).limit(1))

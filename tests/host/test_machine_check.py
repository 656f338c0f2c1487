"""What `bodydrive check` makes of its measurements."""

import datetime as dt
import socket
from pathlib import Path

import pytest
from fake_clock import FakeClock
from hypothesis import given
from hypothesis import strategies as st

from app.disk_room import LITTLE_ROOM, ROOM_TO_RECORD
from app.host.machine_check import (
    PERIOD,
    Finding,
    clock_finding,
    disk_finding,
    free_room,
    lateness_finding,
    measure_lateness,
    port_finding,
    real_time_findings,
    screen_finding,
    summary,
)
from app.texts import Text

NOW = dt.datetime(2026, 5, 1, tzinfo=dt.UTC)


class LateClock(FakeClock):
    """Wakes up late: by 2 ms, and once by 30 ms."""

    def __init__(self) -> None:
        super().__init__()
        self.waits = 0

    def sleep_until(self, deadline: float) -> None:
        self.waits += 1
        super().sleep_until(deadline + (0.030 if self.waits == 50 else 0.002))


def test_each_deadline_counts_from_the_start() -> None:
    lateness = measure_lateness(LateClock(), 1.0)
    assert len(lateness) == 100
    assert sorted(lateness)[-4:] == pytest.approx([0.010, 0.020, 0.030, 0.030], abs=0.011)
    assert lateness[0] == pytest.approx(0.002)
    assert lateness[-1] == pytest.approx(0.002)
    found = lateness_finding(lateness)
    assert found.verdict == "bad"
    assert "the latest after 30.0 ms" in str(found.message)


@given(st.lists(st.floats(0, 0.1), min_size=1, max_size=3000))
def test_the_verdict_is_the_share_of_ticks_later_than_a_period(lateness: list[float]) -> None:
    late = sum(each > PERIOD for each in lateness)
    expected = "good" if late == 0 else "attention" if late <= len(lateness) / 1000 else "bad"
    assert lateness_finding(lateness).verdict == expected


def test_room_clock_and_rights_in_words(tmp_path: Path) -> None:
    assert disk_finding(ROOM_TO_RECORD - 1).verdict == "bad"
    assert disk_finding(LITTLE_ROOM - 1).verdict == "attention"
    assert disk_finding(LITTLE_ROOM).verdict == "good"
    assert free_room(tmp_path / "not" / "yet") > 0
    assert clock_finding(NOW, NOW + dt.timedelta(days=1), is_kept=True).verdict == "bad"
    assert [clock_finding(NOW, NOW, is_kept=kept).verdict for kept in (True, None, False)] == [
        *("good", "good", "attention")
    ]
    texts = [Text("realtime-granted"), Text("realtime-memory-refused")]
    assert [finding.verdict for finding in real_time_findings(texts)] == ["good", "attention"]


def test_a_port_is_free_taken_or_the_clinics_own() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        assert str(port_finding(port, is_own=False).message) == f"Port {port} is in use, perhaps by the clinic itself."
        assert port_finding(port, is_own=True).verdict == "good"
    assert str(port_finding(port, is_own=False).message) == f"Port {port} is free."


def test_a_screen_is_judged_by_its_pictures_a_second() -> None:
    rates = (None, 0.0, 9.9, 10.0, 19.9, 20.0, 60.0)
    verdicts = [screen_finding("The page of Ada", rate).verdict for rate in rates]
    assert verdicts == ["attention", "bad", "bad", "attention", "attention", "good", "good"]
    assert str(screen_finding("The page of Ada", 59.6).message) == "The page of Ada draws 60 pictures a second."


def test_the_worst_finding_decides() -> None:
    good, attention, bad = (Finding(verdict, Text("any")) for verdict in ("good", "attention", "bad"))
    assert str(summary([good]).message) == "This computer is good enough for driving."
    assert summary([good, attention]).verdict == "attention"
    assert "not good enough" in str(summary([bad, attention]).message)

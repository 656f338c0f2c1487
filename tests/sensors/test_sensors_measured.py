"""What `make sensors` measures of each driver, for some frames, and the page that it writes."""

import sys
from argparse import Namespace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sensors import __main__ as command
from sensors import measure as measuring
from sensors.__main__ import is_kept, keep_lsl_local, page, row
from sensors.far_ends import age_of_angle, age_of_parts, angle_at, time_parts
from sensors.measure import Measured, cut_off, measure
from sensors.subjects import SUBJECTS, Subject
from sources_tried.figures import HEADING, section_of

from app.hardware.base import HardwareError
from app.hardware.configs import KINDS
from app.hardware.shirt import serial_line
from needed import lacks

FRAMES = 20
JUNK = 300


@pytest.mark.parametrize("subject", SUBJECTS, ids=lambda subject: subject.title)
def test_each_driver_is_measured(subject: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(serial_line, "REOPEN_AFTER", 0.05)
    monkeypatch.setattr(measuring, "ALIVE", 0.1)
    monkeypatch.setenv("LSLAPICFG", "")  # put back at the end
    is_lsl = subject.title == "LSL"
    if is_lsl and not keep_lsl_local(tmp_path):
        lacks("there is no pylsl with liblsl here: install what pyproject.toml names")
    cuts = 0 if is_lsl else 1  # a lost stream is looked for in turns of a second
    found = measure(subject, 0.0, cuts, JUNK, tmp_path, least=FRAMES, apart=False)
    assert found.frames >= len(found.ages) == FRAMES
    assert found.found == (found.cuts or 0)
    assert not found.junk
    if subject.is_counted:
        assert found.lost == 0, "a busy machine delays frames, and loses none"
    assert np.median(found.ages) > -1e-3
    assert row(found).count("|") == 13


def test_every_kind_that_somebody_wears_is_measured() -> None:
    assert {subject.kind for subject in SUBJECTS} == {"simulator", *(kind.name for kind in KINDS if not kind.simulated)}


@pytest.mark.parametrize(
    ("silence", "frame", "is_found"), [(True, True, True), (False, True, False), (True, False, False)]
)
def test_a_cut_is_found_when_silence_and_then_a_frame_came(silence: bool, frame: bool, is_found: bool) -> None:
    came, asked = iter((silence, frame)), list[str]()
    reading: Any = SimpleNamespace(quiet_for=lambda _: None, reads_until=lambda _: next(came))
    assert (cut_off(reading, asked.append, Subject()) is not None) == is_found
    assert asked == ["cut", "mend"]


class Unplugged(Subject):
    """A driver that cannot be opened."""

    title, what = "unplugged", "no sensors"

    def shirt(self, _folder: Path) -> Any:
        raise HardwareError("no | such line")


def test_a_driver_that_fails_is_a_row_and_the_others_are_measured(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("LSLAPICFG", "")  # put back at the end
    monkeypatch.setattr(command, "SUBJECTS", (Unplugged(), SUBJECTS[0]))
    out, driven = tmp_path / "page.md", f"{HEADING}A table of `make sources-tried`.\n"
    out.write_text(f"An earlier table.\n{driven}", encoding="utf-8")
    monkeypatch.setattr(sys, "argv", ["sensors", "--seconds", "0.01", "--jobs", "2", "--out", str(out)])
    assert command.main() == 1
    failed, measured = capsys.readouterr().out.splitlines()[2:]
    assert failed.startswith("| unplugged | no sensors | 100 | **HardwareError: no / such line** | – |")
    assert measured.startswith("| simulator (reference) |")
    assert failed.count("|") == measured.count("|") == 13
    written = out.read_text(encoding="utf-8")
    assert failed in written
    assert "An earlier table." not in written
    assert section_of(written) == driven, "the part of the other command stays"


@given(st.floats(0.0, 1e7), st.floats(0.0, 4.0))
def test_the_time_in_a_frame_shows_its_age(t: float, age: float) -> None:
    parts = np.array(time_parts(t), dtype=np.float32)
    assert age_of_parts(parts, t + age) == pytest.approx(age, abs=2e-6)
    assert age_of_angle(np.float32(angle_at(t)), t + age) == pytest.approx(age, abs=1e-5)


def test_the_page_marks_what_is_lost_and_says_what_was_left_out() -> None:
    good = Measured("UDP", "52 sensors", 1000.0, 2.0, 2000, 2000, 0, np.full(2000, 1e-3), 0.05, 30, 30, 0.2, 0, "none")
    bad = Measured("phones", "6 phones", 60.0, 2.0, 720, 119, 1, np.full(119, 0.02), 0.05, 30, 29, 0.2, None, None)
    assert [is_kept(good), is_kept(bad)] == [True, False]
    written = page([good, bad], ["LSL"], Namespace(seconds=2.0, cuts=30, junk=100_000, jobs=1))
    assert "| UDP | 52 sensors | 1000 | 2,000 | 2,000 | 0 | 1.0 | 1.0 | 50.0 | 30 found, back after 0.20 s" in written
    assert "| **1** | 20.0 |" in written
    assert "Not measured, without its library: LSL." in written

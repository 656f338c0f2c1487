"""What `make sensors` measures of each driver, for a fraction of a second, and the page that it writes."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from sensors import measure as measuring
from sensors.__main__ import is_kept, keep_lsl_local, page, row
from sensors.far_ends import age_of_angle, age_of_parts, angle_at, time_parts
from sensors.measure import Measured, measure
from sensors.subjects import SUBJECTS

from app.hardware.shirt import serial_line
from needed import lacks

SECONDS = 0.2
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
    found = measure(subject, SECONDS, cuts, JUNK, tmp_path, apart=False)
    assert found.frames >= len(found.ages) > 0
    assert found.found == (found.cuts or 0)
    assert not found.junk
    if subject.is_counted:
        assert found.lost == 0, "a busy machine delays frames, and loses none"
    assert np.median(found.ages) > -1e-3
    assert row(found).count("|") == 13


@given(st.floats(0.0, 1e7), st.floats(0.0, 4.0))
def test_the_time_in_a_frame_shows_its_age(t: float, age: float) -> None:
    parts = np.array(time_parts(t), dtype=np.float32)
    assert age_of_parts(parts, t + age) == pytest.approx(age, abs=2e-6)
    assert age_of_angle(np.float32(angle_at(t)), t + age) == pytest.approx(age, abs=1e-5)


def test_the_page_marks_what_is_lost_and_says_what_was_left_out() -> None:
    good = Measured("UDP", "52 sensors", 1000.0, 2.0, 2000, 2000, 0, np.full(2000, 1e-3), 0.05, 30, 30, 0.2, 0, "none")
    bad = Measured("phones", "6 phones", 60.0, 2.0, 720, 119, 1, np.full(119, 0.02), 0.05, 30, 29, 0.2, None, None)
    assert [is_kept(good), is_kept(bad)] == [True, False]
    written = page([good, bad], ["LSL"], 2.0, 30, 100_000)
    assert "| UDP | 52 sensors | 1000 | 2,000 | 2,000 | 0 | 1.0 | 1.0 | 50.0 | 30 found, back after 0.20 s" in written
    assert "| **1** | 20.0 |" in written
    assert "Not measured, without its library: LSL." in written

"""The details of a row of the log as words; the module runs in node, without a page."""

import re
from pathlib import Path

from app.faults import Fault
from folders import ROOT


def test_patients_have_their_code_and_changes_say_before_and_now(run_script):
    assert " hold" in run_script("pages/log_details.mjs")


def test_every_reason_of_a_stop_has_words(modules: Path) -> None:
    words = (modules / "texts" / "en" / "records" / "log.js").read_text()
    missing = [fault.name for fault in Fault if fault and f'"log.value.fault.{fault.name.lower()}":' not in words]
    assert missing == []


def test_what_happened_has_words_only_for_what_the_log_says(modules: Path) -> None:
    words = (modules / "texts" / "en" / "records" / "log.js").read_text()
    known = re.findall(r'^  "log\.what\.(.+?)":', words, re.MULTILINE)
    code = "".join(file.read_text() for file in (ROOT / "app").rglob("*.py"))
    assert len(known) >= 20
    assert [what for what in known if f'"{what}"' not in code] == []

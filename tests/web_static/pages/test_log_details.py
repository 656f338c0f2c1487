"""The details of a row of the log as words; the module runs in node, without a page."""

from web_static.messages import LITERAL, WORDS, id_of, ids_of

from app.faults import Fault
from folders import ROOT

IDS = ids_of(WORDS / "en" / "log.ftl")


def test_patients_have_their_code_and_changes_say_before_and_now(run_script):
    assert " hold" in run_script("pages/log_details.mjs")


def test_every_reason_of_a_stop_has_words() -> None:
    missing = [fault.name for fault in Fault if fault and f"log-value-fault-{id_of(fault.name.lower())}" not in IDS]
    assert missing == []


def test_what_happened_has_words_only_for_what_the_log_says() -> None:
    known = [name for name in IDS if name.startswith("log-what-")]
    code = "".join(file.read_text() for file in (ROOT / "app").rglob("*.py"))
    said = {f"log-what-{id_of(text)}" for text in LITERAL.findall(code)}
    assert len(known) >= 20
    assert [what for what in known if what not in said] == []

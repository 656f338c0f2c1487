"""The details of a row of the log as words; the module runs in node, without a page."""

from web_static.log_rows import log_rows
from web_static.messages import WORDS, id_of, ids_of

from app.faults import Fault
from app.store.keeping.owned_rows import foreign_keys
from app.store.schema import metadata

IDS = ids_of(WORDS / "en" / "log.ftl")
SHOWN_ALONE = {"patient"}  # by its code


def test_patients_have_their_code_and_changes_say_before_and_now(run_script, reference_file):
    assert " hold" in run_script("pages/log_details.mjs", reference_file)


def test_every_reason_of_a_stop_has_words() -> None:
    missing = [fault.name for fault in Fault if fault and f"log-value-fault-{id_of(fault.name.lower())}" not in IDS]
    assert missing == []


def test_every_row_that_the_program_writes_has_a_message() -> None:
    assert log_rows().unread == []
    assert len(log_rows().names) > 100
    assert [name for name in sorted(log_rows().names) if f"log-what-{id_of(name)}" not in IDS] == []


def test_every_message_of_a_row_is_for_one_that_the_program_writes() -> None:
    written = {f"log-what-{id_of(name)}" for name in log_rows().names}
    assert [name for name in IDS if name.startswith("log-what-") and name not in written] == []


def test_every_detail_that_the_program_writes_has_a_name() -> None:
    assert len(log_rows().details) > 60
    named = {name for name in log_rows().details if f"log-name-{id_of(name)}" in IDS}
    assert named | SHOWN_ALONE == log_rows().details


def test_every_table_with_rows_of_patients_has_a_name() -> None:
    """The row of an erased patient counts them by their tables."""
    keys = [key for key in foreign_keys(metadata()) if key.required]
    tables, before = {"patient"}, 0
    while before < len(tables):
        before = len(tables)
        tables |= {key.table for key in keys if key.parent in tables}
    assert len(tables) > 15
    assert [name for name in sorted(tables - SHOWN_ALONE) if f"log-name-{id_of(name)}" not in IDS] == []

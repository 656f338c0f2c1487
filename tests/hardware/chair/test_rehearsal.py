"""The record of a rehearsal: what counts as kept, and that no change of it passes."""

import json

import pytest
from fluent.syntax import FluentParser
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.chair.key import Key
from app.hardware.chair.outputs import OUTPUTS
from app.hardware.chair.rehearsal import STEPS, RehearsalStep, StepResult, is_genuine, judged, record_of
from app.texts import LANGUAGES
from words import WORDS

KEY = Key(7, bytes(range(32)))
RESULTS = [StepResult("paired", 3000, 20), StepResult("stopped", 500, None)]


@pytest.mark.parametrize(
    ("took", "took_ms", "is_kept"),
    [(0.0, 0, True), (0.4991, 500, True), (0.5, 500, True), (0.5001, 501, False), (None, None, False)],
)
def test_a_step_is_kept_when_it_happened_in_time(took, took_ms, is_kept):
    result = judged(RehearsalStep("stopped", 500), took)
    assert (result.took_ms, result.is_kept) == (took_ms, is_kept)


def test_each_output_is_one_of_a_receiver_and_each_step_has_its_sentences():
    assert STEPS.keys() <= OUTPUTS.keys()
    names = {step.name for steps in STEPS.values() for step in steps}
    for language in LANGUAGES:
        source = (WORDS / language / "server" / "command_line.ftl").read_text(encoding="utf-8")
        entries = {entry.id.name: entry for entry in FluentParser().parse(source).body if hasattr(entry, "value")}
        for message in ("cli-rehearsal-step", "cli-rehearsal-must"):
            (placeable,) = entries[message].value.elements
            assert {variant.key.name for variant in placeable.expression.variants} == names


def test_a_record_is_genuine_as_it_was_written_and_with_its_key_only():
    record = json.loads(json.dumps(record_of(RESULTS, KEY, who="Zoë", speeds={"forward": 0.5})))
    assert is_genuine(record, KEY)
    assert not is_genuine(record, Key(7, bytes(32)))
    assert [step["kept"] for step in record["steps"]] == [True, False]
    for change in ({"who": "Ada"}, {"steps": []}, {"further": 1}, {"sha256": "0"}, {"hmac": None}, {"hmac": "\ud800"}):
        assert not is_genuine({**record, **change}, KEY)


LEAVES = st.none() | st.booleans() | st.floats() | st.text()


@given(st.recursive(LEAVES, lambda inner: st.lists(inner) | st.dictionaries(st.text(), inner)))
def test_what_is_no_record_is_not_genuine(document):
    assert not is_genuine(document, KEY)

"""What a stop says to the patient."""

import re

import pytest

from app.faults import Fault
from app.session.patient_words import WAIT, patient_words

TECHNICAL = re.compile(r"process|tablet|recording|disk|loop|telemetry|control|network|command|number", re.IGNORECASE)


@pytest.mark.parametrize("fault", [fault for fault in Fault if fault is not Fault.NONE])
def test_every_fault_is_two_plain_sentences(fault: Fault) -> None:
    words = patient_words(fault)
    assert words.endswith(f". {WAIT}")
    assert words.count(".") == 2
    assert not TECHNICAL.search(words)
    assert len(words) < 100


def test_who_stopped_the_chair_is_told_right() -> None:
    assert patient_words(Fault.STOP_GESTURE).startswith("You stopped")
    assert patient_words(Fault.STOP_TABLET).startswith("Your clinician stopped")

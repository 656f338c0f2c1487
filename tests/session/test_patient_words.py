"""What the patient reads in each state: what happened, and who is waited for."""

import re
from itertools import product

import pytest

from app.faults import Fault, State
from app.session.patient_words import Awaited, patient_words

TECHNICAL = re.compile(r"process|tablet|recording|disk|loop|telemetry|control|network|command|number", re.IGNORECASE)
NAMES = {
    Awaited.CLINICIAN: "We wait for your clinician,",
    Awaited.PROGRAM: "We wait for the program:",
    Awaited.SHIRT: "We wait for the shirt:",
    Awaited.PATIENT: "the chair waits",
}
FAULTS = [fault for fault in Fault if fault is not Fault.NONE]
OF_THE_SHIRT = {Fault.SHIRT_SILENT, Fault.SHIRT_LOSSY}


@pytest.mark.parametrize(("state", "fault"), list(product(State, Fault)))
def test_in_every_state_and_fault_a_sentence_names_who_is_waited_for(state: State, fault: Fault) -> None:
    for drives, shirt_alive in product([True, False], repeat=2):
        words = patient_words(state, fault, drives=drives, shirt_alive=shirt_alive)
        assert NAMES[words.awaited] in words.wait
        assert sum(name in words.wait for name in NAMES.values()) == 1
        assert bool(words.happened) == (state is State.FAULT)
        for sentence in filter(None, words):
            assert not TECHNICAL.search(sentence)
            assert len(sentence) < 70  # read from 2 m
        assert words.wait.endswith(".")


@pytest.mark.parametrize("fault", FAULTS)
def test_after_a_stop_the_clinician_goes_on_or_something_comes_back_first(fault: Fault) -> None:
    def awaited(shirt_alive: bool) -> Awaited:
        return patient_words(State.FAULT, fault, drives=True, shirt_alive=shirt_alive).awaited

    first = Awaited.PROGRAM if fault is Fault.CONTROL_LOST else Awaited.CLINICIAN
    assert awaited(True) is first
    assert awaited(False) is (Awaited.SHIRT if fault in OF_THE_SHIRT else first)


@pytest.mark.parametrize(
    ("state", "drives", "shirt_alive", "awaited"),
    [
        (State.CHECKING, True, True, Awaited.PATIENT),
        (State.ARMED, True, True, Awaited.PATIENT),
        (State.DISARMED, True, True, Awaited.PROGRAM),
        (State.DISARMED, False, True, Awaited.CLINICIAN),
        (State.DISARMED, False, False, Awaited.SHIRT),
    ],
)
def test_without_a_stop(state: State, drives: bool, shirt_alive: bool, awaited: Awaited) -> None:
    words = patient_words(state, Fault.NONE, drives=drives, shirt_alive=shirt_alive)
    assert words.awaited is awaited


def test_who_stopped_the_chair_is_told_right() -> None:
    def happened(fault: Fault) -> str:
        return patient_words(State.FAULT, fault, drives=True, shirt_alive=True).happened

    assert happened(Fault.STOP_GESTURE).startswith("You stopped")
    for fault in (Fault.STOP_TABLET, Fault.STOP_KEY):
        assert "on a clinician's page" in happened(fault)
    told = {happened(fault) for fault in (Fault.SCREEN_LOST, Fault.SCREEN_HIDDEN, Fault.SCREEN_SLOW)}
    assert len(told) == 3

"""The words for the patient in each state: what happened, and who acts next."""

import re
from itertools import product

import pytest

from app.faults import Fault, State
from app.session.patient_messages import Actor, patient_message

TECHNICAL = re.compile(r"process|tablet|recording|disk|loop|telemetry|control|network|command|number", re.IGNORECASE)
NAMES = {
    Actor.CLINICIAN: "We wait for your clinician ",
    Actor.PROGRAM: "We wait for the program:",
    Actor.SHIRT: "We wait for the shirt:",
    Actor.PATIENT: "the chair waits",
}
FAULTS = [fault for fault in Fault if fault is not Fault.NONE]
OF_THE_SHIRT = {Fault.SHIRT_SILENT, Fault.SHIRT_LOSSY}


def test_in_every_state_and_fault_a_sentence_names_who_is_waited_for() -> None:
    for case in product(State, Fault, [True, False], [True, False]):
        state, fault, drives, shirt_alive = case
        words = patient_message(state, fault, drives=drives, shirt_alive=shirt_alive)
        wait = str(words.wait)
        assert NAMES[words.actor] in wait, case
        assert sum(name in wait for name in NAMES.values()) == 1, case
        assert bool(words.happened) == (state is State.FAULT), case
        for sentence in (str(words.happened or ""), wait):
            assert not TECHNICAL.search(sentence), case
            assert len(sentence) < 70, case  # read from 2 m
        assert wait.endswith("."), case


@pytest.mark.parametrize("fault", FAULTS)
def test_after_a_stop_the_clinician_goes_on_or_something_comes_back_first(fault: Fault) -> None:
    def actor(shirt_alive: bool) -> Actor:
        return patient_message(State.FAULT, fault, drives=True, shirt_alive=shirt_alive).actor

    first = Actor.PROGRAM if fault is Fault.CONTROL_LOST else Actor.CLINICIAN
    assert actor(True) is first
    assert actor(False) is (Actor.SHIRT if fault in OF_THE_SHIRT else first)


@pytest.mark.parametrize(
    ("state", "drives", "shirt_alive", "actor"),
    [
        (State.CHECKING, True, True, Actor.PATIENT),
        (State.ARMED, True, True, Actor.PATIENT),
        (State.DISARMED, True, True, Actor.PROGRAM),
        (State.DISARMED, False, True, Actor.CLINICIAN),
        (State.DISARMED, False, False, Actor.SHIRT),
    ],
)
def test_without_a_stop(state: State, drives: bool, shirt_alive: bool, actor: Actor) -> None:
    words = patient_message(state, Fault.NONE, drives=drives, shirt_alive=shirt_alive)
    assert words.actor is actor


def test_who_stopped_the_chair_is_told_right() -> None:
    def happened(fault: Fault) -> str:
        return str(patient_message(State.FAULT, fault, drives=True, shirt_alive=True).happened)

    assert happened(Fault.STOP_GESTURE).startswith("You stopped")
    for fault in (Fault.STOP_TABLET, Fault.STOP_KEY):
        assert "on a clinician's page" in happened(fault)
    assert len({happened(fault) for fault in (Fault.SCREEN_LOST, Fault.SCREEN_HIDDEN, Fault.SCREEN_SLOW)}) == 3

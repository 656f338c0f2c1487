"""The texts for the patient while the chair stands: why it was stopped, and who acts next."""

from enum import StrEnum
from typing import NamedTuple

from app.faults import EXPLANATIONS, Fault, State
from app.texts import Text


class Actor(StrEnum):
    """Who must act before the chair moves."""

    CLINICIAN = "clinician"
    PROGRAM = "program"
    SHIRT = "shirt"
    PATIENT = "patient"


class PatientNotice(NamedTuple):
    """What the patient reads while the chair stands, without technical details."""

    happened: Text | None  # why the chair was stopped; None when it was not
    actor: Actor
    wait: Text  # who must act


def patient_message(state: State, fault: Fault, *, drives: bool, shirt_alive: bool) -> PatientNotice:
    """Return the words for the patient; `drives`: a trial or drive is going on, `shirt_alive`: the shirt sends."""
    if state is State.FAULT:
        actor = _actor_after(fault, shirt_alive)
        return PatientNotice(EXPLANATIONS[fault].patient, actor, Text(f"fault-waits-{actor}"))
    return PatientNotice(None, *_actor_without_stop(state, drives, shirt_alive))


def _actor_after(fault: Fault, shirt_alive: bool) -> Actor:
    if fault is Fault.CONTROL_LOST:
        return Actor.PROGRAM
    if fault in {Fault.SHIRT_SILENT, Fault.SHIRT_LOSSY} and not shirt_alive:
        return Actor.SHIRT
    return Actor.CLINICIAN  # a stop is cleared by Continue only


def _actor_without_stop(state: State, drives: bool, shirt_alive: bool) -> tuple[Actor, Text]:
    if state is State.ARMED:
        return Actor.PATIENT, Text("fault-waits-movements")
    if state is State.CHECKING:
        return Actor.PATIENT, Text("fault-waits-rest")
    if drives:
        return Actor.PROGRAM, Text("fault-waits-moment")
    if not shirt_alive:
        return Actor.SHIRT, Text("fault-waits-shirt")
    return Actor.CLINICIAN, Text("fault-waits-begin")

"""The sentences for the patient while the chair stands: why it was stopped, and who acts next."""

from enum import StrEnum
from typing import NamedTuple

from app.faults import Fault, State


class Actor(StrEnum):
    """Who must act before the chair moves."""

    CLINICIAN = "clinician"
    PROGRAM = "program"
    SHIRT = "shirt"
    PATIENT = "patient"


class PatientNotice(NamedTuple):
    """What the patient reads while the chair stands, without technical details."""

    happened: str  # why the chair was stopped; empty when it was not
    actor: Actor
    wait: str  # who must act, in a sentence


_HAPPENED: dict[Fault, str] = {
    Fault.STOP_TABLET: "Stop was pressed on a clinician's page.",
    Fault.STOP_GESTURE: "You stopped the chair.",
    Fault.STOP_KEY: "Stop was pressed on a clinician's page.",
    Fault.NOT_NEUTRAL: "Your body was not at rest yet: let your arms hang.",
    Fault.SHIRT_SILENT: "The shirt sent nothing any more.",
    Fault.SHIRT_LOSSY: "Signals of the shirt were lost.",
    Fault.CHANNELS_BAD: "Some sensors of the shirt need a look.",
    Fault.BRAKE_BAD: "Some sensors of the shirt need a look.",
    Fault.NO_MOVEMENT: "The signals did not come from your movement: let your arms hang.",
    Fault.SHIRT_RATE: "The shirt has to be set anew.",
    Fault.WEB_SILENT: "The program was interrupted.",
    Fault.SCREEN_LOST: "Your clinician's screen was out of reach.",
    Fault.SCREEN_HIDDEN: "Your clinician's page was out of view.",
    Fault.SCREEN_SLOW: "Your clinician's screen was too slow.",
    Fault.PICTURE_LOST: "The picture was lost.",
    Fault.BAD_NUMBER: "The program made a mistake.",
    Fault.LOOP_LATE: "The program was too slow.",
    Fault.RECORDING_LOST: "The drive could not be recorded.",
    Fault.CONTROL_LOST: "A part of the program ended.",
    Fault.STOP_CHAIR: "The chair's stop switch was pressed, or the chair has a fault.",
    Fault.CHAIR_SILENT: "The chair was out of reach.",
    Fault.CHAIR_DISARMED: "The chair was out of reach.",
    Fault.CHAIR_NOT_READY: "The chair was not ready in time.",
}
_STOPPED = "The chair was stopped."
_AFTER_STOP = {
    Actor.CLINICIAN: "We wait for your clinician to look and to go on.",
    Actor.PROGRAM: "We wait for the program: it starts again by itself.",
    Actor.SHIRT: "We wait for the shirt: your clinician looks after it.",
}


def patient_message(state: State, fault: Fault, *, drives: bool, shirt_alive: bool) -> PatientNotice:
    """Return the words for the patient; `drives`: a trial or drive is going on, `shirt_alive`: the shirt sends."""
    if state is State.FAULT:
        actor = _actor_after(fault, shirt_alive)
        return PatientNotice(_HAPPENED.get(fault, _STOPPED), actor, _AFTER_STOP[actor])
    return PatientNotice("", *_actor_without_stop(state, drives, shirt_alive))


def _actor_after(fault: Fault, shirt_alive: bool) -> Actor:
    if fault is Fault.CONTROL_LOST:
        return Actor.PROGRAM
    if fault in {Fault.SHIRT_SILENT, Fault.SHIRT_LOSSY} and not shirt_alive:
        return Actor.SHIRT
    return Actor.CLINICIAN  # a stop is cleared by Continue only


def _actor_without_stop(state: State, drives: bool, shirt_alive: bool) -> tuple[Actor, str]:
    if state is State.ARMED:
        return Actor.PATIENT, "You drive: the chair waits for your movements."
    if state is State.CHECKING:
        return Actor.PATIENT, "Let your arms hang: the chair waits until your body is at rest."
    if drives:
        return Actor.PROGRAM, "We wait for the program: it needs a moment."
    if not shirt_alive:
        return Actor.SHIRT, _AFTER_STOP[Actor.SHIRT]
    return Actor.CLINICIAN, "We wait for your clinician to begin."

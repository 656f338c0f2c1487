"""What the patient reads while the chair stands or waits: what happened, and who is waited for."""

from enum import StrEnum
from typing import NamedTuple

from app.faults import Fault, State


class Awaited(StrEnum):
    """Who has to do something before the chair moves."""

    CLINICIAN = "clinician"
    PROGRAM = "program"
    SHIRT = "shirt"
    PATIENT = "patient"


class PatientWords(NamedTuple):
    """Plain sentences; nothing technical, which is for the clinician."""

    happened: str  # why the chair was stopped; empty when it was not
    awaited: Awaited
    wait: str  # who is waited for


_HAPPENED: dict[Fault, str] = {
    Fault.STOP_TABLET: "Stop was pressed on a clinician's page.",
    Fault.STOP_GESTURE: "You stopped the chair.",
    Fault.STOP_KEY: "Stop was pressed on a clinician's page.",
    Fault.NOT_NEUTRAL: "Your body was not at rest yet: let your arms hang.",
    Fault.SHIRT_SILENT: "The shirt was not felt any more.",
    Fault.SHIRT_LOSSY: "The shirt was hard to hear.",
    Fault.CHANNELS_BAD: "Some sensors of the shirt need a look.",
    Fault.BRAKE_BAD: "Some sensors of the shirt need a look.",
    Fault.WEB_SILENT: "The program was interrupted.",
    Fault.SCREEN_LOST: "Your clinician's screen was not heard.",
    Fault.SCREEN_HIDDEN: "Your clinician's page was out of view.",
    Fault.SCREEN_SLOW: "Your clinician's screen was too slow.",
    Fault.PICTURE_LOST: "The picture was lost.",
    Fault.BAD_NUMBER: "The program made a mistake.",
    Fault.LOOP_LATE: "The program was too slow.",
    Fault.RECORDING_LOST: "The drive could not be recorded.",
    Fault.CONTROL_LOST: "A part of the program ended.",
    Fault.STOP_CHAIR: "The chair stopped by itself, or its stop switch was pressed.",
    Fault.CHAIR_SILENT: "The chair was out of reach.",
    Fault.CHAIR_DISARMED: "The chair was out of reach.",
    Fault.CHAIR_NOT_READY: "The chair was not ready in time.",
}
_STOPPED = "The chair was stopped."
_AFTER_STOP = {
    Awaited.CLINICIAN: "We wait for your clinician, who looks and goes on.",
    Awaited.PROGRAM: "We wait for the program: it starts again by itself.",
    Awaited.SHIRT: "We wait for the shirt: your clinician looks after it.",
}


def patient_words(state: State, fault: Fault, *, drives: bool, shirt_alive: bool) -> PatientWords:
    """Return what the patient reads; `drives`: a trial or a drive goes on, `shirt_alive`: the shirt sends."""
    if state is State.FAULT:
        awaited = _awaited_after(fault, shirt_alive)
        return PatientWords(_HAPPENED.get(fault, _STOPPED), awaited, _AFTER_STOP[awaited])
    return PatientWords("", *_moving_on(state, drives, shirt_alive))


def _awaited_after(fault: Fault, shirt_alive: bool) -> Awaited:
    if fault is Fault.CONTROL_LOST:
        return Awaited.PROGRAM
    if fault in {Fault.SHIRT_SILENT, Fault.SHIRT_LOSSY} and not shirt_alive:
        return Awaited.SHIRT
    return Awaited.CLINICIAN  # nothing but Continue takes a stop back


def _moving_on(state: State, drives: bool, shirt_alive: bool) -> tuple[Awaited, str]:
    if state is State.ARMED:
        return Awaited.PATIENT, "You drive: the chair waits for your movements."
    if state is State.CHECKING:
        return Awaited.PATIENT, "Let your arms hang: the chair waits until your body is at rest."
    if drives:
        return Awaited.PROGRAM, "We wait for the program: it needs a moment."
    if not shirt_alive:
        return Awaited.SHIRT, _AFTER_STOP[Awaited.SHIRT]
    return Awaited.CLINICIAN, "We wait for your clinician, who begins."

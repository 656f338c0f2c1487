"""Every stop and fault in one plain sentence for the patient, who can do nothing about it but wait."""

from app.faults import Fault

WAIT = "Please wait a moment."

_HAPPENED: dict[Fault, str] = {
    Fault.STOP_TABLET: "Your clinician stopped the chair.",
    Fault.STOP_GESTURE: "You stopped the chair.",
    Fault.STOP_KEY: "Your clinician stopped the chair.",
    Fault.NOT_NEUTRAL: "The chair waits until your body is at rest.",
    Fault.SHIRT_SILENT: "The shirt is not felt at the moment.",
    Fault.SHIRT_LOSSY: "The shirt is hard to hear at the moment.",
    Fault.CHANNELS_BAD: "Some sensors of the shirt need a look.",
    Fault.BRAKE_BAD: "Some sensors of the shirt need a look.",
    Fault.PICTURE_LOST: "The picture was lost.",
    Fault.STOP_CHAIR: "The chair's own stop switch was used.",
    Fault.CHAIR_SILENT: "The chair is hard to reach at the moment.",
    Fault.CHAIR_DISARMED: "The chair is hard to reach at the moment.",
    Fault.CHAIR_NOT_READY: "The chair is not ready yet.",
}


def patient_words(fault: Fault) -> str:
    """Return what a fault says to the patient; what is technical is told to the clinician alone."""
    return f"{_HAPPENED.get(fault, 'The program needs a moment.')} {WAIT}"

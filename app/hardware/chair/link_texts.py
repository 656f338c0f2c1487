"""Texts of the catalogue for what `key.py` and `reasons.py` say in English, which do without a catalogue."""

from pathlib import Path

from app.hardware.chair.key import Key, KeyRefused, read_key
from app.hardware.chair.reasons import DESCRIPTIONS, Reason
from app.texts import Text


def refusal_text(refused: KeyRefused) -> Text:
    """Return why a key file is refused."""
    return Text(f"device-key-{refused.problem}", file=refused.file, why=refused.why)


def lost_key(file: Path, key: Key) -> Text | None:
    """Return why `key`, which was read from `file` earlier, counts no longer; None while it does."""
    try:
        return None if read_key(file) == key else Text("device-key-changed", file=str(file))
    except KeyRefused as refused:
        return refusal_text(refused)


def reason_text(fault: int) -> Text | None:
    """Return why a chair stands, by the fault code of its telemetry; None for no fault, and for an unknown one."""
    if fault == Reason.NONE or fault not in DESCRIPTIONS:
        return None
    return Text("chairdev-reason", reason=Reason(fault).name.lower())

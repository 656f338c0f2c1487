"""Why a key file is refused, as a text of the catalogue; `app.hardware.chair.key` does without one."""

from pathlib import Path

from app.hardware.chair.key import Key, KeyRefused, read_key
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

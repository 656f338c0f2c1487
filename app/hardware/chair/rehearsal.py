"""The steps of a rehearsal without a chair, what must happen in each and how soon, and the signed record of it.

No clock, no process, no file.
"""

import hashlib
import hmac
import json
import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from app.hardware.chair.key import Key

FORMAT = 1  # of a record
SIGNATURES = ("sha256", "hmac")  # fields of a record that cover all others


class RehearsalStep(NamedTuple):
    """What is done, what must happen, by the message of its name, and within which time."""

    name: str
    limit: int  # ms; includes 100 ms until the next telemetry, where that says what happened


EVERY_OUTPUT = (
    RehearsalStep("paired", 3000),
    RehearsalStep("armed", 1500),
    RehearsalStep("driven", 1000),
    RehearsalStep("stopped", 500),
    RehearsalStep("switch", 500),
    RehearsalStep("silence", 600),
)
WITH_A_CABLE = (RehearsalStep("hand", 500), RehearsalStep("cable", 800), RehearsalStep("plugged", 1500))
AT_THE_END = (RehearsalStep("killed", 500),)
STEPS: Mapping[str, Sequence[RehearsalStep]] = {
    "sim": EVERY_OUTPUT + AT_THE_END,
    "whill": EVERY_OUTPUT + WITH_A_CABLE + AT_THE_END,
}


class StepResult(NamedTuple):
    """What happened in a step."""

    step: str
    limit_ms: int
    took_ms: int | None  # None: it did not happen

    @property
    def is_kept(self) -> bool:
        """Whether it happened in time."""
        return self.took_ms is not None and self.took_ms <= self.limit_ms


def judged(step: RehearsalStep, took: float | None) -> StepResult:
    """Return the result of a step that took `took` seconds, rounded up to ms; None: it did not happen."""
    return StepResult(step.name, step.limit, None if took is None else math.ceil(1000 * took))


def record_of(results: Sequence[StepResult], key: Key, **about: object) -> dict[str, object]:
    """Return the record of a rehearsal, signed with the chair's key; `about` are further fields."""
    steps = [{**result._asdict(), "kept": result.is_kept} for result in results]
    record: dict[str, object] = {"format": FORMAT, "key_id": key.id, **about, "steps": steps}
    covered = _covered(record)
    record["sha256"] = hashlib.sha256(covered).hexdigest()
    record["hmac"] = hmac.digest(key.secret, covered, "sha256").hex()
    return record


def is_genuine(record: object, key: Key) -> bool:
    """Return whether a record is as it was signed with this key."""
    if not isinstance(record, dict):
        return False
    covered = _covered({name: value for name, value in record.items() if name not in SIGNATURES})
    right = hmac.digest(key.secret, covered, "sha256").hex()
    given = record.get("hmac")
    is_signed = isinstance(given, str) and hmac.compare_digest(given.encode(errors="replace"), right.encode())
    return is_signed and record.get("sha256") == hashlib.sha256(covered).hexdigest()


def _covered(record: Mapping[str, object]) -> bytes:
    """Return the bytes of a record that are signed: JSON with sorted names and without spaces."""
    return json.dumps(record, sort_keys=True, separators=(",", ":")).encode()

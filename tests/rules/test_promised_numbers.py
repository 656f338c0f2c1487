"""The numbers of the promises are those of the program: a test that reads a limit there cannot see it change."""

import re
from datetime import timedelta

import pytest
from odd_values import odd_values
from processes.test_odd_equipment import FIELDS
from promises.page import SAFETY, promises

from app import disk_room
from app.api.live import screens
from app.api.sign_in import passwords, set_up, sign_in_limits
from app.calibration.vocabulary import DriveParameters
from app.hardware.chair import receiver
from app.hardware.shirt import frame_order
from app.messages import FRESH_PERIODS
from app.pipeline import chain, channel_health, frame_loss, loop, movement_check, opening, safety_gate
from app.recording.format import LOST_AT_MOST
from app.session import run_watch, screen_codes
from app.store.access import sign_ins
from app.store.files import replacements
from app.store.keeping import erasure

NUMBERS = [
    ("S2", "for 500 ms after every arming", safety_gate.NEUTRAL_TIME, 0.5),
    ("S2", "not within 5 s", safety_gate.NEUTRAL_PATIENCE, 5.0),
    ("S2", "The receiver asks for the same", receiver.NEUTRAL_TIME, 0.5),
    ("S2", "The receiver asks for the same", receiver.NEUTRAL_PATIENCE, 5.0),
    ("S3", "for 100 ms: towards standstill", receiver.QUIET, 0.1),
    ("S3", "for 300 ms: disarmed", receiver.SILENT, 0.3),
    ("S4", "older than 50 ms", safety_gate.SHIRT_STALE, 0.05),
    ("S4", "10 % lost in 1 s", (frame_loss.LOSS_LIMIT, frame_loss.LOSS_WINDOW), (0.1, 1.0)),
    ("S4", "older than 200 ms", safety_gate.SHIRT_SILENT, 0.2),
    ("S4", "losses for 1.5 s", safety_gate.LOSSY_LIMIT, 1.5),
    ("S4", "Below 60 Hz: 3 and 12 periods", safety_gate.shirt_limits(10.0), (0.3, 1.2)),
    ("S4", "Below 60 Hz", safety_gate.SLOW_SHIRT, 60.0),
    ("S5", "flat for 200 ms", channel_health.FLAT_TIME, 0.2),
    ("S5", "quieter than its own noise for 300 ms", channel_health.STUCK_TIME, 0.3),
    ("S5", "nothing for three periods", FRESH_PERIODS, 3.0),
    ("S5", "1.5 x its calibrated range", channel_health.RANGE_FACTOR, 1.5),
    ("S5", "two such gestures stop", safety_gate.BAD_GESTURES, 2),
    ("S7", "300 ms of silence", safety_gate.SCREEN_SILENT, 0.3),
    ("S7", "own thread is silent for 1 s (3 s", (screens.SILENCE_LIMIT, screens.VIRTUAL_SILENCE_LIMIT), (1.0, 3.0)),
    ("S7", "after 1 s of reports in time", loop.PUNCTUAL, 1.0),
    ("S10", "speed goes to 0 after 10 s", DriveParameters.model_fields["cruise_time"].default, 10.0),
    ("S10", "turning after 3 s", DriveParameters.model_fields["turn_cruise_time"].default, 3.0),
    ("S17", "below 500 MB", disk_room.ROOM_TO_RECORD, 500_000_000),
    ("S21", "silent for 300 ms", safety_gate.CHAIR_SILENT, 0.3),
    ("S23", "in time by the shirt's own clock", frame_order.LATE, 0.1),
    ("S27", "waits 5 min for Continue", run_watch.HALT_LIMIT, 300.0),
    ("S28", "at most 8 s", opening.OPENING_LIMIT, 8.0),
    ("S30", "within 2 s after one", movement_check.DOUBT, 2.0),
    ("S31", "by a quarter or more", chain.RATE_TOLERANCE, 0.25),
    ("C4", "After 10 min without use", sign_ins.IDLE_FOR, timedelta(minutes=10)),
    ("C4", "after 12 h", sign_ins.SIGNED_IN_FOR, timedelta(hours=12)),
    ("C9", "for 30 min", set_up.VALID_FOR, 1800.0),
    ("C10", "8 characters or more", passwords.SHORTEST, 8),
    ("C12", "for 10 min", screen_codes.VALID_FOR, 600.0),
    ("C23", "limit of wrong passwords", sign_in_limits.PASSWORDS_PER_NAME, 5),
    ("C23", "limit of wrong passwords", sign_in_limits.PASSWORDS_PER_ADDRESS, 10),
    ("D1", "at most 0.5 s", LOST_AT_MOST, 0.5),
    ("D4", "Below 2 GB it warns", disk_room.LITTLE_ROOM, 2_000_000_000),
    ("D4", "below 500 MB", disk_room.ROOM_TO_RECORD, 500_000_000),
    ("D10", "for 30 days", erasure.UNDO_FOR, timedelta(days=30)),
    ("D14", "for 30 days", replacements.KEPT_FOR, timedelta(days=30)),
]
WORDS = {promise.id: promise.words for promise in promises()}


@pytest.mark.parametrize(("row", "words", "found", "promised"), NUMBERS)
def test_a_number_of_a_promise_is_that_of_the_program(row: str, words: str, found: object, promised: object) -> None:
    assert re.search(re.escape(words), WORDS[row])
    assert found == pytest.approx(promised) if isinstance(promised, float | tuple) else found == promised


def test_as_many_odd_values_are_tried_in_as_many_fields_as_are_promised() -> None:
    (row,) = (line for line in SAFETY.read_text(encoding="utf-8").splitlines() if line.startswith("| S28 |"))
    values = odd_values()
    assert f"{len(FIELDS)} fields x {len(values)} odd values (`make test`: {len(values[::5])} of each" in row

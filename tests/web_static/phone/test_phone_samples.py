"""The page of a phone that is a sensor: its messages are read as they were meant, and it misses its sensor."""

import pytest

from app.hardware.shirt.orientation_sensors.phones import decode_phone

SAMPLES = [
    [7, 0, 0.0, {"alpha": 0, "beta": 0, "gamma": 0}],
    [2**32 - 1, 2**32 - 1, 123456.789, {"alpha": 359.9, "beta": -179.9, "gamma": 89.9}],
    [1, 2, 3.5, {"alpha": 0.1, "beta": 90, "gamma": -90}],
]


def test_a_message_is_read_as_it_was_meant(answered):
    for message, (page, seq, sent, angles) in zip(answered("phone/sample.mjs", SAMPLES), SAMPLES, strict=True):
        sample = decode_phone(bytes.fromhex(message))
        assert (sample.page, sample.seq, sample.sent_t) == (page, seq, sent)
        assert sample.angles_deg == pytest.approx(tuple(angles.values()), abs=1e-4)


def test_a_sensor_is_asked_for_and_its_end_is_noticed(run_script):
    assert " hold" in run_script("phone/sensor.mjs")

"""A shirt that falls silent: the pages are told, nothing is started, and all is well once it sends again."""

import pytest
from api.fake_clinic import WHERE, WORD, Clinic, is_news, next_message

from app.session.equipment import shirt_watch
from app.session.equipment.shirt import Equipment

NO_FRAMES = "No frames from a shirt on 127.0.0.1:5252 (the shirt sends 40 sensors, its layout has 52)."


@pytest.fixture(autouse=True)
def _quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shirt_watch, "WATCH_EVERY", 0.01)


def test_nothing_is_started_while_the_shirt_is_silent_and_the_pages_know_why(calibrated: Clinic) -> None:
    process = calibrated.process
    assert calibrated.good("GET", "/session")["obstacle"] is None
    with calibrated.socket("/live") as socket:
        process.sends, process.shirt_words = False, NO_FRAMES
        next_message(socket, is_news("equipment"))  # the pages are told
        obstacle = calibrated.good("GET", "/session")["obstacle"]
        assert obstacle["page"] == "shirt"
        assert calibrated.good("GET", "/controls/obstacle") == obstacle
        assert calibrated.good("GET", "/controls")["obstacle"] == obstacle
        for path, body in (("/trials", WHERE), ("/interface-tests", {"screen": WORD})):
            assert calibrated.refused(409, "POST", path, json=body) == obstacle["message"]
        assert process.runs == calibrated.good("GET", "/session")["session"]["trials"] == 0
        next_message(socket, lambda m: m.get("shirt_words") == NO_FRAMES)

        process.sends, process.shirt_words = True, "Sends."
        next_message(socket, is_news("equipment"))  # the pages are told
        assert calibrated.good("GET", "/session")["obstacle"] is None
        calibrated.start_trial()


def test_the_pages_are_told_which_sensors_the_shirt_has_found(calibrated: Clinic) -> None:
    assert calibrated.good("GET", "/equipment")["status"]["found"] == []
    with calibrated.socket("/live") as socket:
        calibrated.process.found = ["A1:B2:C3:D4:E5:F6"]
        next_message(socket, lambda m: m.get("event") == "equipment")
        assert calibrated.good("GET", "/equipment")["status"]["found"] == ["A1:B2:C3:D4:E5:F6"]


def test_the_state_of_another_shirt_is_known_as_soon_as_it_is_chosen(calibrated: Clinic) -> None:
    calibrated.process.shirt_words = "Another one."
    calibrated.good("PUT", "/equipment/shirt", json={"kind": "simulator", "seed": 2})
    assert calibrated.parts[Equipment].state == "Another one."
    calibrated.start_trial()

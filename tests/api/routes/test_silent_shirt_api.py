"""A shirt that falls silent: the pages are told, nothing is started, and all is well once it sends again."""

import json
from collections.abc import Callable
from typing import Any

import pytest
from api.fake_clinic import WHERE, WORD, Clinic, is_news, next_message

from app.arrivals import Arrivals
from app.session.equipment import shirt_watch
from app.session.equipment.shirt import Equipment
from app.texts import Text, to_document

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
        next_message(socket, lambda m: m.get("news", {}).get("what") == "equipment")
        assert calibrated.good("GET", "/equipment")["status"]["found"] == ["A1:B2:C3:D4:E5:F6"]


def verdict_is(verdict: str) -> Callable[[Any], bool]:
    return lambda message: (message.get("arrivals") or {}).get("verdict") == verdict


def test_the_pages_get_what_arrives_and_what_to_do(calibrated: Clinic) -> None:
    nothing = Arrivals("nothing", Text("arrivals-udp-nothing", place="0.0.0.0:5252", port=5252, reach="network"), 3, 4)
    with calibrated.socket("/live") as socket:
        assert next_message(socket, lambda m: "arrivals" in m)["arrivals"] is None  # a shirt that does not say it
        calibrated.process.arrivals = json.loads(json.dumps(nothing._asdict(), default=to_document))
        arrivals = next_message(socket, verdict_is("nothing"))["arrivals"]
    assert arrivals["message"].endswith("and open UDP port 5252 in its firewall.")
    assert (arrivals["accepted"], arrivals["left_out"]) == (3, 4)


def test_a_shirt_that_cannot_be_opened_says_why(calibrated: Clinic) -> None:
    why = "the shirt on /dev/ttyACM0 cannot be opened (Permission denied)"
    with calibrated.socket("/live") as socket:
        calibrated.process.refuse["shirt"] = why
        refused = calibrated.refused(409, "PUT", "/equipment/shirt", json={"kind": "serial"})
        assert refused.lower() == f"{why.lower()}."
        arrivals = next_message(socket, verdict_is("unopened"))["arrivals"]
    assert arrivals["message"] == why


def test_the_state_of_another_shirt_is_known_as_soon_as_it_is_chosen(calibrated: Clinic) -> None:
    calibrated.process.shirt_words = "Another one."
    calibrated.good("PUT", "/equipment/shirt", json={"kind": "simulator", "seed": 2})
    assert calibrated.parts[Equipment].state == "Another one."
    calibrated.start_trial()

"""Chairs, limits and the speed dial as the pages use them."""

import stat
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from api.conftest import sign_in
from api.fake_clinic import Clinic
from api.running_app import running

from app.hardware.chair.key import read_key
from app.settings import Settings
from app.speed_limits import HIGHEST_SPEEDS, Speeds

SLOW = {**Speeds().model_dump(), "forward": 0.4, "turn": 0.6}
CHAIR = {"name": "Blue chair", "host": "10.0.0.7", "port": 5354, "speeds": SLOW}


def test_a_key_is_shown_once_kept_for_us_alone_and_told_to_nobody_else(signed_in: Clinic, settings: Settings) -> None:
    answer = signed_in.good("POST", "/chairs", json=CHAIR)
    file = settings.keys / "1.key"
    key = read_key(file)
    assert answer["key_line"] == key.line
    assert (answer["qr"].startswith("<svg"), "script" in answer["qr"]) == (True, False)
    assert [stat.S_IMODE(place.stat().st_mode) for place in (file, settings.keys)] == [0o600, 0o700]
    later = signed_in.good("GET", "/chairs")
    assert not {"key_line", "qr"} & later.keys()
    secret = key.secret.hex()
    assert secret not in str(later)
    signed_in.good("PUT", "/chairs/chosen", json={"id": later["chairs"][0]["id"], "dynamics": "unicycle"})
    assert secret not in str(signed_in.process.calls)
    for file in settings.state.glob("bodydrive.sqlite*"):
        assert secret.encode() not in file.read_bytes()
        assert key.secret not in file.read_bytes()


def test_unpairing_deletes_the_key_and_its_number_is_not_used_again(signed_in: Clinic, settings: Settings) -> None:
    first = signed_in.good("POST", "/chairs", json=CHAIR)["chairs"][0]
    assert signed_in("POST", "/chairs", json=CHAIR).status_code == 409
    signed_in.good("PUT", "/chairs/chosen", json={"id": first["id"], "dynamics": "wheelchair"})
    left = signed_in.good("DELETE", f"/chairs/{first['id']}")
    assert (left["chairs"], left["chosen"], left["dynamics"]) == ([], None, "wheelchair")
    assert signed_in.process.chair == "virtual"
    assert list(settings.keys.iterdir()) == []
    assert signed_in("DELETE", f"/chairs/{first['id']}").status_code == 404
    assert signed_in.good("POST", "/chairs", json=CHAIR)["chairs"][0]["key_id"] == 2


def test_a_chair_that_cannot_be_is_refused_in_a_sentence(signed_in: Clinic) -> None:
    fields: list[dict[str, Any]] = [{"port": 0}, {"port": 70_000}, {"host": "a b"}, {"name": ""}]
    for wrong in (*fields, {"speeds": {**SLOW, "forward": 1.6}}):
        assert signed_in.refused(422, "POST", "/chairs", json={**CHAIR, **wrong}), wrong
    assert signed_in.good("GET", "/chairs")["chairs"] == []


def test_a_chosen_chair_is_opened_and_given_to_the_next_control_process(signed_in: Clinic, settings: Settings) -> None:
    chair = signed_in.good("POST", "/chairs", json=CHAIR)["chairs"][0]
    chosen = signed_in.good("PUT", "/chairs/chosen", json={"id": chair["id"], "dynamics": "unicycle"})
    assert chosen["chosen"] == chair["id"]
    config = {"kind": "udp", "name": "Blue chair", "host": "10.0.0.7", "port": 5354, "speeds": SLOW}
    config["key_file"] = str(settings.keys / "1.key")
    assert signed_in.process.calls[-1] == ("chair", {"config": config})
    before = signed_in.process
    before.die()
    signed_in.until("/equipment", lambda e: signed_in.process is not before and e["status"]["control"] == "alive")
    assert ("chair", {"config": config}) in signed_in.process.calls
    assert signed_in.process.calls[0][0] == "limits"


def test_the_choice_outlives_the_application(settings: Settings, signed_in: Clinic) -> None:
    chair = signed_in.good("POST", "/chairs", json=CHAIR)["chairs"][0]
    signed_in.good("PUT", "/chairs/chosen", json={"id": chair["id"], "dynamics": "wheelchair"})
    signed_in.good("PUT", "/limits", json=SLOW)
    for again in running(settings):
        sign_in(again)
        assert again.good("GET", "/chairs")["chosen"] == chair["id"]
        assert again.good("GET", "/limits") == SLOW
        assert ("limits", {"clinic": SLOW}) in again.process.calls


def test_a_chair_that_does_not_open_is_said_and_changes_nothing(signed_in: Clinic, settings: Settings) -> None:
    chair = signed_in.good("POST", "/chairs", json=CHAIR)["chairs"][0]
    signed_in.process.refuse["chair"] = f"the key file {settings.keys}/1.key cannot be read"
    refused = signed_in.refused(409, "PUT", "/chairs/chosen", json={"id": chair["id"], "dynamics": "unicycle"})
    assert refused == "The key file 1.key cannot be read."
    assert signed_in.good("GET", "/chairs")["chosen"] is None


def test_a_virtual_chair_may_move_like_a_wheelchair(signed_in: Clinic) -> None:
    signed_in.good("PUT", "/chairs/chosen", json={"id": None, "dynamics": "wheelchair"})
    assert signed_in.process.calls[-1] == ("chair", {"config": {"kind": "virtual", "dynamics": "wheelchair"}})
    assert signed_in("PUT", "/chairs/chosen", json={"id": 9, "dynamics": "unicycle"}).status_code == 404
    assert signed_in("PUT", "/chairs/chosen", json={"id": None, "dynamics": "rocket"}).status_code == 422


def test_limits_hold_in_the_control_process_first_and_are_logged(signed_in: Clinic, settings: Settings) -> None:
    assert signed_in.good("GET", "/limits") == HIGHEST_SPEEDS.model_dump()
    assert signed_in.good("PUT", "/limits", json=SLOW) == SLOW
    assert ("limits", {"clinic": SLOW}) in signed_in.process.calls
    signed_in.process.refuse["limits"] = "Limits are raised only while the chair stands."
    refused = signed_in.refused(409, "PUT", "/limits", json=HIGHEST_SPEEDS.model_dump())
    assert refused == signed_in.process.refuse["limits"]
    assert signed_in.good("GET", "/limits") == SLOW
    rows = signed_in.log()
    assert [row.details["now"]["forward"] for row in rows if row.what == "limits set"] == [0.4]
    assert signed_in("PUT", "/limits", json={**SLOW, "forward": float("1e9")}).status_code == 422


def test_a_set_above_the_limits_keeps_its_numbers_and_says_what_holds(calibrated: Clinic) -> None:
    assert calibrated.good("GET", "/controls")["held"] == {}
    calibrated.good("PUT", "/limits", json=SLOW)
    view = calibrated.good("GET", "/controls")
    assert view["parameters"]["speeds"]["forward"] == 0.8
    assert view["held"] == {"forward": 0.4, "turn": 0.6}
    chair = calibrated.good("POST", "/chairs", json={**CHAIR, "speeds": {**SLOW, "forward": 0.3}})["chairs"][0]
    calibrated.good("PUT", "/chairs/chosen", json={"id": chair["id"], "dynamics": "unicycle"})
    assert calibrated.good("GET", "/controls")["held"] == {"forward": 0.3, "turn": 0.6}


def test_the_dial_is_turned_logged_and_given_to_the_next_control_process(signed_in: Clinic) -> None:
    assert signed_in.good("POST", "/control/dial", json={"share": 0.5}) == {"share": 0.5}
    for wrong in (0.05, 1.1, True, "1"):
        assert signed_in("POST", "/control/dial", json={"share": wrong}).status_code == 422
    signed_in.process.refuse["dial"] = "The dial is turned up only while the chair stands."
    assert signed_in("POST", "/control/dial", json={"share": 0.9}).status_code == 409
    before = signed_in.process
    before.die()
    signed_in.until("/equipment", lambda e: signed_in.process is not before and e["status"]["control"] == "alive")
    assert signed_in.process.dial == 0.5
    assert [row.details["share"] for row in signed_in.log() if row.what == "dial turned"] == [0.5]


@pytest.fixture
def usage(monkeypatch: pytest.MonkeyPatch) -> Any:
    """What the disk says of itself: how many bytes are free."""
    said = SimpleNamespace(free=3_000_000_000)
    monkeypatch.setattr("app.store.files.disk_watch.shutil.disk_usage", lambda _folder: said)
    return said


def test_the_disk_is_told_before_it_is_full(signed_in: Clinic, usage: Any) -> None:
    assert signed_in.good("GET", "/equipment")["disk"] == {"free": 3_000_000_000, "message": ""}
    usage.free = 1_400_000_000
    assert "1.4 GB" in signed_in.good("GET", "/equipment")["disk"]["message"]


def test_no_session_is_opened_where_nothing_could_be_recorded(signed_in: Clinic, usage: Any) -> None:
    patient = signed_in.add_patient("P-1")
    usage.free = 499_900_000
    assert "only 499 MB are free" in signed_in.refused(507, "POST", "/session", json={"patient_id": patient})
    assert signed_in.good("GET", "/session")["session"] is None
    usage.free = 500_000_000
    signed_in.good("POST", "/session", json={"patient_id": patient})
    usage.free = 0
    signed_in.good("DELETE", "/session")


def test_a_full_disk_is_a_sentence(signed_in: Clinic, monkeypatch: pytest.MonkeyPatch) -> None:
    def full(_file: Path, *_given: Any) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("app.session.equipment.pairing.write_key", full)
    assert "make room" in signed_in.refused(507, "POST", "/chairs", json=CHAIR)
    assert signed_in.good("GET", "/chairs")["chairs"] == []

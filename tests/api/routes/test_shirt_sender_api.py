"""The sender of the shirt's frames: shown to everybody, chosen by a clinician, not while a run is going on."""

from api.fake_clinic import Clinic

from app.session.equipment.shirt import Equipment

FORGER = "10.0.0.9:4000"
SENDERS = {"shirt": "10.0.0.2:4000", "other": FORGER, "others": 3}


def test_where_nobody_else_could_send_nobody_is_named(signed_in: Clinic) -> None:
    assert signed_in.good("GET", "/equipment/sender") == {"shirt": "", "other": "", "others": 0}


def test_another_sender_is_shown_and_taken_by_a_tap_that_is_logged(signed_in: Clinic) -> None:
    signed_in.process.senders = SENDERS
    assert signed_in.good("GET", "/equipment/sender") == SENDERS
    signed_in.good("PUT", "/equipment/sender", json={"sender": FORGER})
    assert ("sender", {"sender": FORGER}) in signed_in.process.calls
    row = signed_in.log()[-1]
    assert (row.what, row.details) == ("shirt's sender chosen", {"sender": FORGER})


def test_what_the_control_process_refuses_is_said(signed_in: Clinic) -> None:
    signed_in.process.refuse["sender"] = "The chair is armed: end the drive first."
    refused = signed_in.refused(409, "PUT", "/equipment/sender", json={"sender": FORGER})
    assert refused == "The chair is armed: end the drive first."
    assert signed_in("PUT", "/equipment/sender", json={"sender": "x" * 101}).status_code == 422


def test_a_key_is_chosen_by_its_name_among_those_of_shirts(signed_in: Clinic) -> None:
    keys = signed_in.parts[Equipment]._keys
    keys.mkdir(parents=True)
    for name in ("shirt-1.key", "1.key"):
        (keys / name).touch()
    equipment = signed_in.good("GET", "/equipment")
    assert equipment["shirt_keys"] == ["shirt-1.key"]
    config = {"kind": "udp", "layout": equipment["layout"], "key_file": "shirt-1.key"}
    assert signed_in.good("PUT", "/equipment/shirt", json=config)["shirt"]["key_file"] == "shirt-1.key"
    sent = [fields["config"] for do, fields in signed_in.process.calls if do == "shirt"][-1]
    assert sent["key_file"] == str(keys / "shirt-1.key")
    for name in ("1.key", "../keys/shirt-1.key", str(keys / "shirt-1.key")):
        assert signed_in("PUT", "/equipment/shirt", json={**config, "key_file": name}).status_code == 404

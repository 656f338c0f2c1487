"""The choice of the head tracker over the API."""

from typing import Any

OPENTRACK = {"kind": "opentrack", "host": "127.0.0.1", "port": 4242}


def test_a_head_tracker_is_chosen_kept_and_taken_away(signed_in: Any) -> None:
    assert signed_in.good("GET", "/equipment")["head"]["config"] is None
    shown = signed_in.good("PUT", "/equipment/head", json={"config": OPENTRACK})
    assert shown["head"]["config"] == OPENTRACK
    assert signed_in.process.calls[-1] == ("head", {"config": OPENTRACK})
    (chosen,) = [entry for entry in signed_in.log() if entry.what == "head tracker chosen"]
    assert chosen.details == {"kind": "opentrack"}
    assert signed_in.good("PUT", "/equipment/head", json={"config": None})["head"]["config"] is None


def test_a_tracker_that_cannot_be_had_is_a_sentence_and_leaves_none(signed_in: Any) -> None:
    signed_in.good("PUT", "/equipment/head", json={"config": OPENTRACK})
    signed_in.process.refuse["head"] = "the port is taken"
    refused = signed_in.refused(409, "PUT", "/equipment/head", json={"config": {**OPENTRACK, "port": 4243}})
    assert refused == "The port is taken."
    assert signed_in.good("GET", "/equipment")["head"]["config"] is None


def test_nonsense_is_refused(signed_in: Any) -> None:
    for config in ({"kind": "nose"}, {**OPENTRACK, "port": 70_000}, {"kind": "flock_of_birds"}, 3):
        assert signed_in("PUT", "/equipment/head", json={"config": config}).status_code == 422


def test_straight_ahead_is_asked_of_the_control_process(signed_in: Any) -> None:
    signed_in.good("POST", "/equipment/head/ahead", json={})
    assert ("head_ahead", {}) in signed_in.process.calls
    signed_in.process.refuse["head_ahead"] = "wait for its first pose"
    assert signed_in("POST", "/equipment/head/ahead", json={}).status_code == 409


def test_a_recorded_head_is_played_from_a_brought_file(signed_in: Any) -> None:
    content = b"t,yaw_deg,pitch_deg,roll_deg\n0,1,2,3\n1,1,2,3\n"
    shown = signed_in.good("POST", "/equipment/files", files={"file": ("head.csv", content)})
    assert [(file["name"], file["kind"]) for file in shown["files"]] == [("head.csv", "head")]
    signed_in.good("PUT", "/equipment/head", json={"config": {"kind": "recorded", "file": "head.csv"}})
    assert signed_in.process.calls[-1][1]["config"]["file"].endswith("/head.csv")
    signed_in.refused(404, "PUT", "/equipment/head", json={"config": {"kind": "recorded", "file": "other.csv"}})

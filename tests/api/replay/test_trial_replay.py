"""The replay of a trial: its time line, and its picture in 3D."""

from typing import Any

import pytest
from api.fake_clinic import BASE
from recorded_trial import record_trial
from starlette.websockets import WebSocketDisconnect

from app.api.replay.replays import Replays
from app.session.trial import TrialFlow
from app.world.scene import find_place
from building import make_parameters


@pytest.fixture
def driven(calibrated: Any) -> Any:
    """A clinic with one finished trial and its recording."""
    calibrated.trial = calibrated.start_trial()
    calibrated.folder = calibrated.parts[TrialFlow].current.run.folder
    assert calibrated("GET", f"/trials/{calibrated.trial['id']}/timeline").status_code == 409
    calibrated.end_trial()
    return calibrated


def viewings(clinic: Any) -> int:
    return len([row for row in clinic.log() if row.what == "trial viewed"])


def test_a_time_line_is_answered_kept_and_logged(driven: Any) -> None:
    record_trial(driven.folder, make_parameters(n_channels=8))
    address = f"/trials/{driven.trial['id']}/timeline"
    line = driven.good("GET", address)
    assert len(line["t"]) == len(line["x"]) == len(line["gestures"][0]["activation"]) == 1200
    assert [event["kind"] for event in line["events"]][:2] == ["checking", "armed"]
    plain = driven("GET", address, headers={"Accept-Encoding": "identity"})
    assert "content-encoding" not in plain.headers
    assert plain.json() == line
    assert viewings(driven) == 2
    driven.client.cookies.clear()
    assert driven("GET", address).status_code == 401


def test_a_trial_without_a_recording_says_so(driven: Any) -> None:
    refused = driven.refused(404, "GET", f"/trials/{driven.trial['id']}/timeline")
    assert refused == "The recording of this trial cannot be read: restore it from a backup."
    assert driven("GET", "/trials/999/timeline").status_code == 404
    assert viewings(driven) == 0  # nobody was shown anything


def page_of(clinic: Any, word: str) -> int:
    return clinic.client.get(f"/view/replay/{word}/", headers={"Origin": BASE}).status_code


def test_a_trial_is_shown_in_3d_at_a_moment_and_closed(driven: Any) -> None:
    record_trial(driven.folder, make_parameters(n_channels=8), seconds=3.0, plan=find_place("apartment"))
    logged = viewings(driven)
    word = driven.good("POST", "/replays", json={"trial": driven.trial["id"]})["id"]
    assert viewings(driven) == logged + 1
    page = driven.client.get(f"/view/replay/{word}/")
    assert 'content: "Replay"' in page.text
    assert "connect-src" in page.headers["content-security-policy"]
    assert driven("POST", f"/replays/{word}/at", json={"t": 1.5, "view": "top"}).status_code == 204
    assert driven.parts[Replays].find(word, 1)._t == 1.5
    for bad in ({"t": "1"}, {"t": 1e9}, {"t": 1.0, "view": "free fall"}):
        assert driven("POST", f"/replays/{word}/at", json=bad).status_code == 422
    address = f"{BASE.replace('http', 'ws')}/view/replay/{word}"
    with driven.client.websocket_connect(address, ["viser-v1.1.1"], headers={"Origin": BASE}) as socket:
        assert len(socket.receive_bytes()) > 0
    # Whoever else comes finds nothing: another word, another page's origin, nobody.
    assert driven("POST", "/replays/another-word/at", json={"t": 0.0}).status_code == 404
    foreign = {"Origin": "http://evil.example"}
    with pytest.raises(WebSocketDisconnect), driven.client.websocket_connect(address, headers=foreign):
        pass
    with pytest.raises(Exception, match="closed"):
        driven.parts[Replays].find(word, 2)
    assert [driven("DELETE", f"/replays/{word}").status_code for _ in range(2)] == [204, 204]
    assert page_of(driven, word) == 404
    driven.client.cookies.clear()
    assert driven("POST", "/replays", json={"trial": driven.trial["id"]}).status_code == 401


def test_only_two_are_open_and_none_moves_while_somebody_drives(driven: Any) -> None:
    record_trial(driven.folder, make_parameters(n_channels=8), seconds=3.0, plan=find_place("apartment"))
    body = {"trial": driven.trial["id"]}
    words = [driven.good("POST", "/replays", json=body)["id"] for _ in range(3)]
    assert [page_of(driven, word) for word in words] == [404, 200, 200]
    logged = viewings(driven)
    running = driven.start_trial()
    driven("POST", "/replays", json={"trial": running["id"]})
    for path, sent in (("/replays", body), (f"/replays/{words[2]}/at", {"t": 0.0})):
        assert driven.refused(409, "POST", path, json=sent).startswith("Somebody drive")
    assert viewings(driven) == logged
    assert len(driven.good("GET", f"/trials/{driven.trial['id']}/timeline")["t"]) == 300
    driven.end_trial()
    assert driven("POST", f"/replays/{words[2]}/at", json={"t": 0.0}).status_code == 204


def test_a_recording_without_a_place_has_no_picture(driven: Any) -> None:
    assert "no picture" in driven.refused(404, "POST", "/replays", json={"trial": driven.trial["id"]})
    assert viewings(driven) == 0

"""A drive of a real chair through the whole application: pairing, practice, arming, stop by a hidden screen, end."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from paired_shirt import PairedShirt, calibrated_as_worn
from processes.chair_process import ReceiverProcess
from processes.served_demo import CONTINUES, Demo, InView, until
from processes.udp_shirt import free_port

from app.hardware.chair.key import Key, write_key
from app.speed_limits import Speeds

WORD = "the-screen-of-this-test"


@pytest.fixture
def demo(tmp_path: Path) -> Iterator[Demo]:
    with Demo.running(tmp_path) as running:
        yield running


def good(demo: Demo, method: str, path: str, body: Any = None) -> Any:
    answer = demo.client.request(method, path, json=body)
    assert answer.status_code in {200, 201}, answer.text
    return answer.json()


def drive_begun(demo: Demo, live: Any, digest: str) -> Any:
    """Begin a drive; continue after a fault, as a person would."""
    for _ in range(CONTINUES):
        answer = demo.client.post("/drives", json={"hash": digest, "screen": WORD})
        if answer.is_success:
            return answer.json()
        demo.go_on_until(live, lambda _: True)
    raise AssertionError(answer.text)


def wear(demo: Demo, live: Any, shirt: PairedShirt, database: Path) -> None:
    """Choose a paired shirt in place of the simulated shirt, after checking each refusal of the simulated shirt."""
    refusals = good(demo, "GET", "/drives/summary")["refusals"]
    assert any("nobody wears it" in sentence for sentence in refusals)
    good(demo, "PUT", "/equipment/shirt", shirt.config)
    assert "that nobody wore" in good(demo, "GET", "/controls")["obstacle"]["message"]
    calibrated_as_worn(database)
    until(live, lambda m: m["values"] is not None)


def test_the_story_of_a_real_chair(demo: Demo, tmp_path: Path) -> None:
    port = free_port()
    chair = {"name": "Blue", "host": "127.0.0.1", "port": port, "speeds": Speeds(forward=0.5).model_dump()}
    paired = good(demo, "POST", "/chairs", chair)
    number, secret = paired["key_line"].split()
    write_key(tmp_path / "7.key", Key(int(number), bytes.fromhex(secret)))
    receiver = ReceiverProcess(tmp_path, port)
    database = next(tmp_path.rglob("bodydrive.sqlite"))
    shirt = PairedShirt(database.parent)
    screen = InView(demo, WORD)
    try:
        with demo.socket("live") as live:
            until(live, lambda m: m["values"] is not None)
            wear(demo, live, shirt, database)
            plan = good(demo, "GET", "/floorplans/apartment")
            where = {"floorplan": plan["name"], "path": plan["paths"][0]["name"], "screen": WORD}
            trial = good(demo, "POST", "/trials", where)
            demo.go_on_until(live, lambda m: m["trial"] is not None and m["trial"]["t"] > 1.0)
            demo.client.post("/trials/current/end", json={})  # on a busy machine, answered before it is measured
            until(live, lambda m: m["trial"] is None)
            assert good(demo, "GET", f"/trials/{trial['id']}")["measures"] is not None

            good(demo, "PUT", "/chairs/chosen", {"id": paired["chairs"][0]["id"], "dynamics": "unicycle"})
            until(live, lambda m: m["chair"] is not None and (m["chair"]["age"] or 9.0) < 0.3)
            summary = good(demo, "GET", "/drives/summary")
            assert (summary["practised"]["trials"], summary["speeds"]["forward"]) == (1, 0.5)
            assert [sentence[:20] for sentence in summary["refusals"]] == ["With “Keeps its spee"]
            receiver.press(True)
            until(live, lambda m: m["chair"]["stop_input"])
            receiver.press(False)
            until(live, lambda m: not m["chair"]["stop_input"] and m["chair"]["state"] == "disarmed")
            assert good(demo, "GET", "/drives/summary")["refusals"] == []

            drive = drive_begun(demo, live, summary["parameters"]["hash"])
            shown = demo.go_on_until(live, lambda m: m["state"] == m["chair"]["state"] == "armed")
            assert shown["drive"]["id"] == drive["id"]
            receiver.wait_for(lambda line: line["state"] == "armed")

            screen.hide()
            stopped = until(live, lambda m: m["state"] == "fault")
            assert stopped["fault"]["name"] == "screen_hidden"
            receiver.wait_for(lambda line: line["state"] == "disarmed" and line["v"] == 0.0)
            screen.visible = True
            assert demo.go_on_until(live, lambda m: m["state"] == "armed")["drive"]["id"] == drive["id"]
            ended = good(demo, "POST", "/drives/current/end")
            assert (ended["end"], ended["hash"]) == ("by hand", summary["parameters"]["hash"])
            receiver.wait_for(lambda line: line["state"] == "disarmed")
    finally:
        screen.close()
        receiver.close()
        shirt.close()

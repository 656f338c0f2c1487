"""What a person types as equipment never ends or blocks the control process: real processes, through the API."""

import asyncio
import json
import os
import socket
import warnings
from contextlib import contextmanager
from pathlib import Path

import pytest
from api.one_hop import OneHop
from odd_values import odd_values
from processes.running_control import SIMULATED, refusal, running, tick_with

from app.api.app import create_app
from app.computing_process import ComputingProcess
from app.process.supervisor import ControlProcess
from app.settings import Settings
from app.speed_limits import Speeds
from app.store.database import Database
from app.store.people import add_clinic
from app.visible_text import visible_line
from building import make_layout
from event_loop import in_event_loop

with warnings.catch_warnings():
    # Starlette announces the successor of httpx, which is not needed here.
    warnings.simplefilter("ignore")
    from starlette.testclient import TestClient

HERE = Path(__file__).parent
BASE = "http://127.0.0.1:8080"
LAYOUT = make_layout(4).model_dump(mode="json")
MOST = 300  # letters of a sentence
ROWS = "t,right_elbow_1\n" + "".join(f"{i / 100},{i}\n" for i in range(20))


def shirt(**fields):
    return "PUT", "/equipment/shirt", {"kind": "udp", "port": 0, "layout": LAYOUT, **fields}


def other_shirt(kind, **fields):
    return "PUT", "/equipment/shirt", {"kind": kind, **fields}


def layout(**fields):
    return shirt(layout={**LAYOUT, **fields})


def head(**fields):
    return "PUT", "/equipment/head", {"config": fields}


def first(things, **fields):
    return [{**things[0], **fields}, *things[1:]]


FIELDS = {
    "shirt's host": lambda text: shirt(host=text),
    "shirt's port": lambda text: shirt(port=text),
    "shirt's file": lambda text: other_shirt("replay", file=text),
    "camera's rate": lambda text: other_shirt("camera", sample_rate=text),
    "phone": lambda text: other_shirt("phones", trunk=text),
    "trackers' host": lambda text: other_shirt("slimevr", host=text, port=0),
    "trackers' port": lambda text: other_shirt("slimevr", port=text),
    "tracker": lambda text: other_shirt("slimevr", port=0, head=text),
    "shirt's serial line": lambda text: other_shirt("serial", device=text),
    "serial line's baud rate": lambda text: other_shirt("serial", baud=text),
    "serial line's format": lambda text: other_shirt("serial", format=text),
    "Bluetooth sensor": lambda text: other_shirt("bluetooth", trunk=text),
    "Bluetooth sensors' rate": lambda text: other_shirt("bluetooth", sample_rate=text),
    "board": lambda text: other_shirt("brainflow", board=text),
    "board's data": lambda text: other_shirt("brainflow", data=text),
    "board's stream": lambda text: other_shirt("brainflow", preset=text),
    "board's serial line": lambda text: other_shirt("brainflow", serial_port=text),
    "board's MAC address": lambda text: other_shirt("brainflow", mac_address=text),
    "board's IP address": lambda text: other_shirt("brainflow", ip_address=text),
    "board's port": lambda text: other_shirt("brainflow", ip_port=text),
    "board's serial number": lambda text: other_shirt("brainflow", serial_number=text),
    "board's other details": lambda text: other_shirt("brainflow", other_info=text),
    "stream's name": lambda text: other_shirt("lsl", name=text),
    "stream's source": lambda text: other_shirt("lsl", source_id=text),
    "stream's type": lambda text: other_shirt("lsl", type=text),
    "stream's computer": lambda text: other_shirt("lsl", host=text),
    "shirt's kind": lambda text: shirt(kind=text),
    "layout's name": lambda text: layout(name=text),
    "channel's name": lambda text: layout(channels=first(LAYOUT["channels"], name=text)),
    "channel's joint": lambda text: layout(channels=first(LAYOUT["channels"], joint=text)),
    "joint's label": lambda text: layout(joints=first(LAYOUT["joints"], label=text)),
    "dead channel": lambda text: ("PUT", "/equipment/shirt", {**SIMULATED, "dead_channels": [text]}),
    "unused channel": lambda text: ("PUT", "/equipment/unused", {"channels": [text]}),
    "head's host": lambda text: head(kind="opentrack", host=text, port=0),
    "other head's host": lambda text: head(kind="freepie", host=text, port=0),
    "head's serial line": lambda text: head(kind="flock_of_birds", device=text),
    "head's file": lambda text: head(kind="recorded", file=text),
    "body's file": lambda text: ("PUT", "/equipment/body", {"kind": "recorded", "file": text}),
    "body's skill": lambda text: ("PUT", "/equipment/body", {"kind": "person", "skill": text}),
}


@contextmanager
def clinic(folder):
    """Yield a browser that is signed in, and the list of the control processes that were started for it."""
    settings = Settings(state=folder, demo_code="the-code-of-the-link")
    database = Database(settings.database)
    with database.transaction() as db:
        add_clinic(db, "Clinic")
    database.close()
    processes = []

    async def start_process():
        processes.append(await ControlProcess.start())
        return processes[-1]

    app = create_app(settings, start_process, ComputingProcess())
    browser = ("127.0.0.1", 50_000)
    with TestClient(app, base_url=BASE, raise_server_exceptions=False, client=browser) as client:
        loop = client.portal.call(asyncio.get_running_loop)
        client._transport = OneHop(app, loop, browser, client._transport)
        client.headers["Origin"] = BASE
        assert client.post("/api/v1/auth/demo", json={"code": "the-code-of-the-link"}).status_code == 200
        yield client, processes


def import_from(folder, monkeypatch):
    """Let the processes that are started import modules of a folder first."""
    monkeypatch.setenv("PYTHONPATH", f"{folder}{os.pathsep}{os.environ.get('PYTHONPATH', '')}")


def put_files(folder: Path):
    """Make files of every odd kind in the folder of the clinic's files."""
    folder.mkdir(parents=True)
    (folder / "folder").mkdir()
    (folder / "words.csv").write_text("t,right_elbow_1\n0,a\n")
    (folder / "empty.csv").touch()
    (folder / "good.csv").write_text(ROWS)
    (folder / "link.csv").symlink_to("/dev/zero")
    os.mkfifo(folder / "pipe.csv")
    os.mkfifo(folder / "pipe")


def ask(client, method, path, document):
    """Send a document as a browser could: also with what is no text."""
    content = json.dumps(document).encode()
    headers = {"Content-Type": "application/json", "Patient-Session": "none"}
    return client.request(method, f"/api/v1{path}", content=content, headers=headers)


def badness(answer):
    """Return what is wrong with the answer to a value, empty when it is right."""
    if answer.status_code >= 500:
        return f"{answer.status_code} {answer.text[:200]}"
    sentence = answer.json()["detail"] if answer.status_code >= 400 else "It was taken."
    is_one = sentence.endswith(".") and len(sentence) <= MOST
    return "" if is_one and is_visible(sentence) else sentence


def is_visible(sentence):
    """Return whether nothing in a sentence is invisible, which would change how its other letters look."""
    try:
        return visible_line(sentence) == sentence
    except ValueError:
        return False


@pytest.mark.parametrize("step", [5, pytest.param(1, marks=pytest.mark.long)], ids=["40 of 200", "all 200"])
def test_odd_values_in_every_field_of_the_equipment_are_taken_or_refused_in_a_sentence(tmp_path, monkeypatch, step):
    put_files(tmp_path / "files")
    import_from(HERE / "no_device", monkeypatch)
    with clinic(tmp_path) as (client, processes):
        for number, (name, request) in enumerate(FIELDS.items()):
            values = odd_values()[number % step :: step]
            wrong = [(value[:60], why) for value in values if (why := badness(ask(client, *request(value))))]
            assert (name, wrong) == (name, [])
            assert len(processes) == 1, name
        # ... and a valid value is accepted.
        assert ask(client, *shirt(host="localhost")).status_code == 200
        assert ask(client, *head(kind="opentrack", host="127.0.0.1", port=0)).status_code == 200
        assert ask(client, "PUT", "/equipment/shirt", {"kind": "replay", "file": "good.csv"}).status_code == 200
        assert len(processes) == 1


def test_200_odd_addresses_of_a_chair_are_taken_or_refused_in_a_sentence(tmp_path):
    with clinic(tmp_path) as (client, processes):
        taken = []
        for count, value in enumerate(odd_values()):
            chair = {"name": f"Chair {count}", "host": value, "port": 5354, "speeds": Speeds().model_dump()}
            answer = ask(client, "POST", "/chairs", chair)
            assert answer.status_code in {201, 422}, f"{value[:60]!r}: {answer.text[:200]}"
            if answer.status_code == 201:
                chosen = {"id": answer.json()["chairs"][-1]["id"], "dynamics": "unicycle"}
                taken.append(ask(client, "PUT", "/chairs/chosen", chosen).status_code)
        assert len(taken) > 5
        assert set(taken) <= {200, 409}
        assert len(processes) == 1


@pytest.mark.parametrize(
    ("do", "config"),
    [
        ("shirt", {"kind": "udp", "host": "shirt.slow", "port": 0, "layout": LAYOUT}),
        ("head", {"kind": "opentrack", "host": "head.slow", "port": 0}),
    ],
)
@in_event_loop
async def test_a_name_that_takes_5_s_to_resolve_holds_nothing_up(monkeypatch, do, config):
    import_from(HERE / "slow_names", monkeypatch)
    async with running(screen=None) as control:
        await tick_with(control, lambda _tick: True)
        begun = int(control.newest()["number"])
        opening = asyncio.create_task(refusal(control, do, config=config))
        await asyncio.sleep(0.5)
        assert "being opened" in await refusal(control, "arm", hash="0" * 64)
        assert not opening.done()
        sentence = await opening
        ticks = control.since(begun)
        assert len(ticks) > 150  # in 5 s at 50 Hz, on a busy machine
        assert config["host"] in sentence
        assert (await control.call("status"))["late"] < 20


@in_event_loop
async def test_a_driver_that_raises_anything_is_a_sentence():
    async with running(screen=None) as control:
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other:
            other.bind(("127.0.0.1", 0))
            taken = {"kind": "udp", "port": other.getsockname()[1], "layout": LAYOUT}
            assert "a port that is free" in await refusal(control, "shirt", config=taken)
        await control.call("shirt", config=SIMULATED)
        file = {"kind": "recorded", "file": "/dev/zero"}
        assert "ordinary file" in await refusal(control, "body", config=file)
        assert "ordinary file" in await refusal(control, "head", config=file)
        assert "ordinary file" in await refusal(control, "shirt", config={**file, "kind": "replay"})

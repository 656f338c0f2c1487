"""The bridge between a browser and the 3D servers, without a browser."""

import asyncio
import socket
import time
from contextlib import asynccontextmanager

import httpx
import msgspec
import numpy as np
import pytest
import websockets
from browser.served.view_app import running
from fastapi import FastAPI, HTTPException
from fastapi.testclient import TestClient
from starlette.websockets import WebSocketDisconnect

from app.api.refusals import install_refusals
from app.api.view import view_bridge
from app.api.view.view_bridge import view_router
from app.api.view.view_controls import view_controls
from app.scene.client_messages import SUBPROTOCOL
from app.world.floorplan import bundled_floorplans, load_floorplan
from event_loop import in_event_loop

PLAN = load_floorplan(bundled_floorplans()["corridors"])


@pytest.fixture(scope="module")
def served():
    with running(PLAN) as app:
        yield app


def socket_of(served, role="clinician", slash="", **options):
    address = f"{served.address.replace('http', 'ws')}/view/{role}{slash}"
    options = {"subprotocols": [SUBPROTOCOL], "compression": None, "proxy": None, "max_size": None} | options
    return websockets.connect(address, **options)


def camera():
    lens = {"fov": 1.0, "near": 0.05, "far": 400.0, "image_height": 500, "image_width": 250}
    pose = {"wxyz": (1.0, 0.0, 0.0, 0.0), "position": (0.0, 0.0, 0.0)}
    towards = {"look_at": (1.0, 0.0, 0.0), "up_direction": (0.0, 0.0, 1.0)}
    return msgspec.msgpack.encode({"type": "ViewerCameraMessage", **pose, **lens, **towards})


def clients_of(served, role):
    return served.scene_thread.scene._servers[role].get_clients()


async def eventually(condition):
    async with asyncio.timeout(10):
        while not condition():
            await asyncio.sleep(0.02)


@pytest.mark.parametrize("slash", ["", "/"])
@in_event_loop
async def test_a_browser_gets_the_scene_and_its_camera_arrives(served, slash):
    async with socket_of(served, slash=slash) as browser:
        assert browser.subprotocol == SUBPROTOCOL
        assert len(await browser.recv()) > 1000
        await browser.send(camera())
        await eventually(lambda: len(clients_of(served, "clinician")) == 1)
        (client,) = clients_of(served, "clinician").values()
        assert (client.camera.image_width, client.camera.image_height) == (250, 500)
        assert not clients_of(served, "patient")
    await eventually(lambda: not clients_of(served, "clinician"))


@in_event_loop
async def test_what_may_not_pass_does_not_arrive_and_the_view_goes_on(served):
    arrived = []
    server = served.scene_thread.scene._servers["patient"]._websock_server
    original = server._handle_incoming_message

    async def noted(client_id, message):
        arrived.append(type(message).__name__)
        await original(client_id, message)

    server._handle_incoming_message = noted
    async with socket_of(served, "patient") as browser:
        for content in (b"", b"\xc1\xff", msgspec.msgpack.encode({"type": "ShareUrlRequest"})):
            await browser.send(content)
        await browser.send("words")
        await browser.send(msgspec.msgpack.encode({"type": "GuiUpdateMessage", "uuid": "a", "updates": {}}))
        await browser.send(camera())
        await eventually(lambda: len(clients_of(served, "patient")) == 1)
        assert await browser.recv()
    server._handle_incoming_message = original
    assert arrived == ["ViewerCameraMessage"]


@pytest.mark.parametrize("change", [{"subprotocols": None}, {"subprotocols": ["viser-v1.0.0"]}, {"role": "reviewer"}])
@in_event_loop
async def test_a_wrong_version_and_an_unknown_role_are_refused_before_they_are_accepted(served, change):
    with pytest.raises(websockets.InvalidStatus) as refused:
        async with socket_of(served, **change):
            pass
    assert refused.value.response.status_code == 403


def test_a_browser_that_takes_nothing_is_cut_off(served, monkeypatch):
    monkeypatch.setattr(view_bridge, "SEND_WITHIN", 0.3)
    request = (
        "GET /view/patient HTTP/1.1\r\nHost: here\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
        "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\n"
        f"Sec-WebSocket-Protocol: {SUBPROTOCOL}\r\n\r\n"
    )
    server = served.scene_thread.scene._servers["patient"]
    states = server._websock_server._client_state_from_id
    before = len(states)
    with socket.socket() as stalled:
        stalled.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        stalled.connect(("127.0.0.1", int(served.address.rsplit(":", 1)[1])))
        stalled.sendall(request.encode())
        deadline = time.monotonic() + 10
        while len(states) == before:
            assert time.monotonic() < deadline
            time.sleep(0.01)
        # Never read: enough is sent to fill every buffer on the way.
        noise = np.random.default_rng(1)
        deadline = time.monotonic() + 20
        while len(states) > before:
            assert time.monotonic() < deadline, "a browser that takes nothing is still connected"
            points = noise.random((20_000, 2, 3), dtype="float32")
            server.scene.add_line_segments("/filling", points, (0, 0, 0))
            server.flush()
            time.sleep(0.02)
    server.scene.remove_by_name("/filling")


def test_the_page_is_served_packed_with_its_own_policy(served):
    answer = httpx.get(f"{served.address}/view/clinician/", headers={"accept-encoding": "gzip"})
    assert (answer.status_code, answer.headers["content-encoding"]) == (200, "gzip")
    assert "bodydriveView" in answer.text
    policy = answer.headers["content-security-policy"]
    host = served.address.removeprefix("http://")
    assert f"connect-src 'self' ws://{host} blob: data:" in policy
    assert "frame-ancestors 'self'" in policy
    assert "unsafe-eval'" not in policy.replace("'wasm-unsafe-eval'", "")
    again = httpx.get(f"{served.address}/view/clinician/", headers={"if-none-match": answer.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")
    assert httpx.get(f"{served.address}/view/owner/").status_code == 422


def application(admitted, port, scene=None):
    @asynccontextmanager
    async def may_view(websocket, role):
        if not admitted:
            await websocket.close(4401)
        yield admitted

    def nobody():
        raise HTTPException(401, "You are not signed in.")

    app = FastAPI()
    install_refusals(app)
    app.include_router(view_router(lambda _role: port, may_view, nobody))
    app.include_router(view_controls(lambda: scene, lambda: None), prefix="/api/v1")
    return TestClient(app)


def test_who_is_not_admitted_gets_neither_page_nor_socket():
    client = application(admitted=False, port=1)
    assert client.get("/view/clinician/").status_code == 401
    with pytest.raises(WebSocketDisconnect) as ended, client.websocket_connect("/view/clinician", [SUBPROTOCOL]):
        pass
    assert ended.value.code == 4401


@pytest.mark.parametrize("port", [None, 1])
def test_without_a_3d_server_the_socket_is_refused(port):
    client = application(admitted=True, port=port)
    with pytest.raises(WebSocketDisconnect) as ended, client.websocket_connect("/view/clinician", [SUBPROTOCOL]):
        pass
    assert ended.value.code == view_bridge.NO_VIEW


def test_the_controls_of_the_view(served):
    api = f"{served.address}/api/v1/view"

    def said(path, **body):
        return httpx.post(f"{api}/{path}", json=body).json()

    seen = said("patient/camera", view="top")
    assert (seen["view"], seen["plots"]) == ("top", False)
    for is_open in (True, False):
        seen = said("clinician/plots", open=is_open)
        assert (seen["view"], seen["plots"]) == ("eye", is_open)
    for bad in ({"view": "side"}, {"view": 1}, {"view": "top", "more": 1}):
        assert httpx.post(f"{api}/clinician/camera", json=bad).status_code == 422
    assert httpx.post(f"{api}/clinician/plots", json={"open": "yes"}).status_code == 422


def test_what_is_not_named_about_the_eye_stays_as_it_is(served):
    api = f"{served.address}/api/v1/view"
    eye = {"fov_deg": 90, "eye_height": 1.4, "roll_share": 0.5, "head": False}
    assert httpx.post(f"{api}/patient/camera", json={"view": "eye"} | eye).json().items() >= eye.items()
    after = httpx.post(f"{api}/patient/camera", json={"view": "chase", "fov_deg": 40}).json()
    assert after.items() >= (eye | {"fov_deg": 40, "view": "chase"}).items()
    assert httpx.post(f"{api}/patient/camera", json={"eye_height": 1.0}).json()["view"] == "chase"
    assert httpx.post(f"{api}/clinician/camera", json={"view": "eye"}).json()["fov_deg"] == 68
    for bad in ({"fov_deg": 29}, {"fov_deg": 111}, {"eye_height": 0.5}, {"roll_share": 1.1}, {"head": 1}):
        assert httpx.post(f"{api}/patient/camera", json={"view": "eye"} | bad).status_code == 422


def test_the_free_camera_goes_where_it_is_put(served):
    api = f"{served.address}/api/v1/view"
    place = {"azimuth": 1.0, "elevation": 0.6, "distance": 8.0, "x": 2.0, "y": 3.0}
    assert httpx.post(f"{api}/patient/free", json=place).json()["free"] == place
    assert httpx.post(f"{api}/clinician/camera", json={"view": "eye"}).json()["free"] != place
    for bad in ({"elevation": 0}, {"elevation": 2}, {"distance": 0.2}, {"distance": 500}, {"azimuth": None}):
        assert httpx.post(f"{api}/patient/free", json=place | bad).status_code == 422


def test_without_a_session_the_controls_say_what_to_do():
    answer = application(admitted=True, port=None).post("/api/v1/view/clinician/camera", json={"view": "top"})
    assert answer.status_code == 409
    assert "no session is open: open one" in answer.json()["detail"]

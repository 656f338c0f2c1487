import math

import msgspec
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from viser import _messages

from app.scene.client_messages import may_pass
from app.scene.role_servers import ROLES

# JavaScript writes a whole number as one, such as the first of the position.
CAMERA = (
    {"type": "ViewerCameraMessage", "wxyz": (1.0, 0.0, 0.0, 0.0), "fov": 1.2, "near": 0.05, "far": 400}
    | {"position": (0, 0.0, 0.0), "look_at": (1.0, 0.0, 0.0), "up_direction": (0.0, 0.0, 1.0)}
    | {"image_height": 768, "image_width": 1024}
)
GUI = {"type": "GuiUpdateMessage", "uuid": "a", "updates": {"value": 3}}


def packed(message):
    return msgspec.msgpack.encode(message)


@pytest.mark.parametrize("role", ROLES)
def test_a_camera_may_pass(role):
    assert may_pass(role, packed(CAMERA))
    assert isinstance(_messages.Message.deserialize(packed(CAMERA)), _messages.ViewerCameraMessage)


def test_only_a_clinician_may_touch_the_panel():
    assert may_pass("clinician", packed(GUI))
    assert not may_pass("patient", packed(GUI))


@pytest.mark.parametrize("role", ROLES)
def test_no_other_message_that_viser_knows_may_pass(role):
    allowed = {"ViewerCameraMessage"} | ({"GuiUpdateMessage"} if role == "clinician" else set())
    names = {kind.__name__ for kind in _messages.Message.get_subclasses()}
    assert {"ShareUrlRequest", "ShareUrlDisconnect", "FileTransferStartUpload", "FileTransferPart"} <= names
    for name in names - allowed:
        assert not may_pass(role, packed({"type": name}))
        assert not may_pass(role, packed(CAMERA | {"type": name}))


@pytest.mark.parametrize(
    "change",
    [
        *({"fov": math.nan}, {"fov": "1"}, {"position": (math.inf, 0.0, 0.0)}, {"wxyz": (1.0, 0.0, 0.0)}),
        *({"image_width": 10**9}, {"image_height": -1}, {"image_height": 3.5}),
        *({"more": 1}, {"look_at": None}, {"excluded_self_client": 1}),
    ],
)
def test_a_camera_of_another_form_is_left_out(change):
    assert not may_pass("clinician", packed(CAMERA | change))


def test_a_camera_with_something_missing_is_left_out():
    for name in CAMERA:
        assert not may_pass("clinician", packed({key: value for key, value in CAMERA.items() if key != name}))


@given(st.binary(max_size=400))
@example(b"\xdf\x00\x00\x00\x01\xa1\x80")  # a map whose key is no text
def test_no_bytes_raise(content):
    for role in ROLES:
        assert may_pass(role, content) in {True, False}


@given(st.integers(0, 400))
def test_a_message_cut_off_is_left_out(end):
    whole = packed(CAMERA)
    assert may_pass("patient", whole[:end]) == (end >= len(whole))


def test_a_long_message_is_left_out():
    assert not may_pass("clinician", packed(GUI | {"updates": {"value": "x" * 5000}}))


@pytest.mark.parametrize("message", [b"\x91" * 4000, b"\x81\xa1a" * 1300])
def test_a_deeply_nested_message_does_not_pass(message):
    for role in ("clinician", "patient"):
        assert not may_pass(role, message)

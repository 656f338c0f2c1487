"""What a page makes of a camera's pictures is what the server expects of it."""

import json
import math
from collections.abc import Callable

from app.hardware.shirt.camera import decode_sample
from app.layout import ShirtLayout
from app.settings import data_folder


def test_the_channels_of_a_drawn_skeleton_hold_and_are_those_of_the_layout(run_script: Callable[..., str]) -> None:
    made = json.loads(run_script("camera/channels.mjs"))
    layout = ShirtLayout.model_validate_json((data_folder() / "shirts" / "camera-upper-body.json").read_bytes())
    assert made["channels"] == layout.channel_names
    assert {joint.rpartition("_")[2] for joint in layout.joint_names} == {"head", "trunk", "shoulder", "elbow", "wrist"}
    sample = decode_sample(bytes.fromhex(made["message"]), 3)
    assert sample is not None
    assert sample[:3] == (4294967295, 12.5, 12.625)
    first, second, third = sample.values.tolist()
    assert (first, math.isnan(second), third) == (0.25, True, -3.0)

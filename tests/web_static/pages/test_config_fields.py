"""The form of a shirt is made of the schema of its configuration: also of a kind that stands in this file only."""

from collections.abc import Callable
from typing import Annotated, Any, Literal

import pytest
from hardware.shirt.shirts import small_layout
from pydantic import Field

from app.api.routes.equipment import shirt_kind_view
from app.hardware.addresses import SerialLine
from app.hardware.configs import SHIRTS
from app.hardware.shirt.kind import LayoutFile, ShirtConfig, ShirtKey, ShirtKind, SignalFile, page_texts
from app.hardware.shirt.standard import standard_layout
from app.hardware.shirt.udp import UdpShirt

NOTHING: dict[str, Any] = {"now": None, "layout": None, "files": [], "keys": [], "found": [], "layouts": []}
FILES = [
    {"name": "knit.csv", "kind": "signals", "size": 2_000},
    {"name": "body.csv", "kind": "body", "size": 2_000},
    {"name": "walk.csv", "kind": "signals", "size": 3_000_000},
]


class BandConfig(ShirtConfig):
    """Two bands of stretch sensors on a serial line."""

    model_config = page_texts("Chest bands", in_use="Chest bands on {device}, {baud} baud")

    kind: Literal["band"]
    device: SerialLine = Field(default="/dev/ttyACM0", title="Serial line", description="As the system names it.")
    gain: Annotated[float, Field(ge=0.5, le=4)] = Field(default=1.0, title="Gain", json_schema_extra={"unit": "dB"})
    offset: Annotated[int, Field(ge=-5, le=5)] | None = Field(default=None, title="Offset")
    baud: Literal[115_200, 1_000_000] = Field(default=115_200, title="Speed", json_schema_extra={"unit": "baud"})
    mirrored: bool = Field(default=False, title="Worn the other way round")
    bands: Annotated[int, Field(ge=1, le=4)] = Field(default=2, title="Bands", json_schema_extra={"format": "stepper"})
    layout: LayoutFile = Field(default_factory=standard_layout)
    key_file: ShirtKey = None
    file: SignalFile
    secret: int = Field(default=7, json_schema_extra={"format": "hidden"})


@pytest.fixture
def drawn(answered: Callable[..., Any]) -> Callable[..., Any]:
    """Return what draws the form of a kind of shirt, fills it in, and reads what it holds."""

    def draw(kind: ShirtKind[Any], around: dict[str, Any], **entries: Any) -> Any:
        form = shirt_kind_view(kind).model_dump(mode="json")["form"]
        return answered("pages/config_fields.mjs", {"form": form, "around": NOTHING | around, "entries": entries})

    return draw


def test_a_new_kind_of_shirt_has_a_form_with_its_words_and_bounds(drawn: Callable[..., Any]) -> None:
    entries = {
        "Serial line": " /dev/ttyUSB3 ",
        "Gain (dB)": "2.5",
        "Offset": "-3",
        "Speed": "1000000",
        "Worn the other way round": True,
        "Bands": "+",
        "Layout from a file": small_layout().model_dump(mode="json"),
        "Key": "shirt-2.key",
        "File": "walk.csv",
    }
    around = {"files": FILES, "keys": ["shirt-1.key", "shirt-2.key"]}
    page = drawn(ShirtKind(BandConfig, UdpShirt), around, **entries)
    shown = {field.pop("label"): field for field in page["shown"]}
    assert set(shown) == set(entries)
    assert shown["Serial line"]["hint"] == "As the system names it."
    assert shown["Serial line"]["limits"] == {"type": "text", "minlength": "1", "maxlength": "255", "required": ""}
    assert shown["Gain (dB)"]["limits"] == {"type": "number", "min": "0.5", "max": "4", "required": ""}
    assert shown["Offset"]["limits"] == {"type": "number", "min": "-5", "max": "5"}
    assert shown["Speed"]["options"] == ["115200 baud", "1000000 baud"]
    assert shown["Layout from a file"]["hint"].startswith("A JSON file that names the sensors.")
    assert shown["Key"]["options"] == ["None", "shirt-1.key", "shirt-2.key"]
    assert [option.split(" ")[0] for option in shown["File"]["options"]] == ["knit.csv", "walk.csv"]
    assert BandConfig.model_validate(page["before"]) == BandConfig(kind="band", file="knit.csv")
    assert BandConfig.model_validate(page["after"]) == BandConfig(
        kind="band",
        device="/dev/ttyUSB3",
        gain=2.5,
        offset=-3,
        baud=1_000_000,
        mirrored=True,
        bands=3,
        layout=small_layout(),
        key_file="shirt-2.key",
        file="walk.csv",
    )
    assert page["in_use"] == "Chest bands on /dev/ttyUSB3, 1000000 baud"


def test_a_form_shows_the_configuration_in_use_and_keeps_what_is_not_shown(drawn: Callable[..., Any]) -> None:
    now = BandConfig(kind="band", file="walk.csv", gain=3.0, offset=2, secret=9, layout=small_layout())
    around = {"now": now.model_dump(mode="json"), "files": FILES, "layout": small_layout().model_dump(mode="json")}
    page = drawn(ShirtKind(BandConfig, UdpShirt), around, Offset="")
    assert BandConfig.model_validate(page["before"]) == now
    assert BandConfig.model_validate(page["after"]) == now.model_copy(update={"offset": None})


def test_a_device_that_describes_its_channels_needs_no_layout_and_keeps_one_that_was_brought(
    drawn: Callable[..., Any],
) -> None:
    lsl, layout = SHIRTS["lsl"], standard_layout().model_dump(mode="json")
    new = drawn(lsl, {"layout": layout}, **{"Source ID": "arm-1, arm-2"})  # another shirt is in use
    assert [field["label"] for field in new["shown"]][:2] == ["Name of the stream", "Source ID"]
    assert lsl.config.model_validate(new["before"]) == lsl.config(kind="lsl")
    assert lsl.config.model_validate(new["after"]) == lsl.config(kind="lsl", source_id="arm-1, arm-2")
    now = lsl.config(kind="lsl", name="Arm", layout=small_layout())
    page = drawn(lsl, {"layout": layout, "now": now.model_dump(mode="json")})
    assert lsl.config.model_validate(page["before"]) == now
    assert page["in_use"] == "LSL streams"


def test_a_layout_that_was_saved_is_chosen_by_its_name(drawn: Callable[..., Any]) -> None:
    udp, standard = SHIRTS["udp"], standard_layout()
    saved = [small_layout().model_dump(mode="json")]
    around = {"layout": standard.model_dump(mode="json"), "layouts": saved}
    page = drawn(udp, around, **{"Saved layout": "small"})
    shown = {field["label"]: field for field in page["shown"]}
    assert shown["Saved layout"]["options"] == ["As it is now", "small"]
    assert udp.config.model_validate(page["before"]).layout == standard
    assert udp.config.model_validate(page["after"]).layout == small_layout()
    replay = SHIRTS["replay"]
    files = {"files": [{"name": "walk.csv", "kind": "signals", "size": 2_000}]}
    played = drawn(replay, around | files, **{"Saved layout": "small"})
    assert replay.config.model_validate(played["before"]) == replay.config(kind="replay", file="walk.csv")
    assert replay.config.model_validate(played["after"]).layout == small_layout()


def test_of_a_saved_layout_and_one_of_a_file_the_last_is_used(drawn: Callable[..., Any]) -> None:
    udp, saved = SHIRTS["udp"], {"Saved layout": "small"}
    of_file = {"Layout from a file": small_layout().model_copy(update={"name": "of a file"}).model_dump(mode="json")}
    around = {"layouts": [small_layout().model_dump(mode="json")]}
    for entries, name in ((saved | of_file, "of a file"), (of_file | saved, "small")):
        assert udp.config.model_validate(drawn(udp, around, **entries)["after"]).layout.name == name


def test_two_sensors_of_the_simulated_shirt_can_be_dead(drawn: Callable[..., Any]) -> None:
    simulator = SHIRTS["simulator"]
    layout = standard_layout().model_dump(mode="json")
    others = drawn(simulator, {"layout": layout})  # another shirt is in use
    assert [field["label"] for field in others["shown"]] == ["Frames a second", "Which simulated shirt"]
    now = simulator.config(kind="simulator").model_dump(mode="json")
    page = drawn(simulator, {"layout": layout, "now": now})
    assert page["shown"][-1]["segments"] == ["All work", "Two are dead"]
    assert page["shown"][0]["options"] == ["50 Hz", "100 Hz", "200 Hz", "500 Hz", "1000 Hz"]
    assert page["in_use"] == "Simulated shirt, 100 frames a second"


def test_a_choice_is_shown_by_its_words_and_sent_by_its_name(drawn: Callable[..., Any]) -> None:
    serial = SHIRTS["serial"]
    page = drawn(serial, {}, **{"Serial line": "/dev/ttyUSB0", "Baud rate": "2000000", "Format": "lines"})
    shown = {field["label"]: field for field in page["shown"]}
    assert list(shown) == ["Serial line", "Baud rate", "Format", "Frames a second", "Layout from a file"]
    assert shown["Format"]["options"] == ["Frames with a checksum", "Plain lines of numbers"]
    assert shown["Baud rate"]["options"][0] == "115200"
    assert serial.config.model_validate(page["before"]) == serial.config(kind="serial")
    after = serial.config.model_validate(page["after"])
    assert after == serial.config(kind="serial", device="/dev/ttyUSB0", baud=2_000_000, format="lines")
    assert page["in_use"] == "Shirt on the cable at /dev/ttyUSB0"


def test_a_board_is_told_by_what_it_needs_and_its_stream_by_words(drawn: Callable[..., Any]) -> None:
    brainflow = SHIRTS["brainflow"]
    page = drawn(brainflow, {}, **{"Data": "emg, accel", "Stream": "auxiliary", "Serial line": "/dev/ttyUSB0"})
    shown = {field["label"]: field for field in page["shown"]}
    assert list(shown)[:4] == ["Board", "Data", "Stream", "Serial line"]
    assert shown["Stream"]["options"] == ["Main stream", "Second stream (auxiliary)", "Third stream (ancillary)"]
    assert brainflow.config.model_validate(page["before"]) == brainflow.config(kind="brainflow")
    after = brainflow.config.model_validate(page["after"])
    assert after == brainflow.config(
        kind="brainflow", data="emg, accel", preset="auxiliary", serial_port="/dev/ttyUSB0"
    )
    assert page["in_use"] == "Board CYTON_BOARD"


def test_sensors_that_are_found_are_offered_beside_each_part_of_the_body(drawn: Callable[..., Any]) -> None:
    slimevr, mine, other = SHIRTS["slimevr"], "A1:B2:C3:D4:E5:F6", "00:00:00:00:00:0A/1"
    now = slimevr.config(kind="slimevr", trunk=mine)
    around = {"now": now.model_dump(mode="json"), "found": [other]}
    page = drawn(slimevr, around, **{"Left forearm": other})
    shown = {field["label"]: field for field in page["shown"]}
    assert shown["Trunk"]["options"] == ["None", mine, other]
    assert shown["Left forearm"]["options"] == ["None", other]
    assert slimevr.config.model_validate(page["before"]) == now
    assert slimevr.config.model_validate(page["after"]) == now.model_copy(update={"left_forearm": other})
    assert page["in_use"] == "Trackers on port 6969"

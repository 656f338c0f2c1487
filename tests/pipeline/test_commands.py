"""What is asked of the control process, done or refused, with a clock of its own and no process."""

import math
import shutil
import socket
from types import SimpleNamespace

import numpy as np
import pytest
from hardware.chair.chair_stand_in import StandInChair
from office import Office

from app.calibration.vocabulary import Binding
from app.faults import Fault, State
from app.geometry import Twist
from app.hardware.shirt.packet import encode
from app.pipeline.runs import LEAST_FREE, require_room
from app.pipeline.setup import CommandRefused
from app.session.equipment.pairing import pair_shirt, shirt_key_file
from app.speeds import HIGHEST_SPEEDS, Speeds

ONE_WAY = (Binding(control="u2+", gestures=("left_shoulder",)),)


@pytest.fixture
def office():
    made = Office()
    yield made
    made.close()


@pytest.fixture
def chair(tmp_path):
    made = StandInChair(tmp_path)
    yield made
    made.close()


def limits(**changes):
    return HIGHEST_SPEEDS.model_copy(update=changes).model_dump()


def test_lower_limits_hold_at_once_and_higher_ones_only_at_rest(office):
    office.live(0.1)
    office.done("limits", clinic=limits(forward=0.5))
    assert office.setup.chain.limits.forward == 0.5
    gate = office.setup.chain.gate
    gate.last = Twist(0.4, 0.0)  # as if it drove
    office.done("limits", clinic=limits(forward=0.3))
    assert office.setup.chain.limits.forward == 0.3
    assert "raised only while" in office.refused("limits", clinic=limits(forward=0.4))
    assert office.setup.chain.limits.forward == 0.3
    gate.stand()
    office.done("limits", clinic=limits(forward=0.4))
    assert office.setup.chain.limits.forward == 0.4
    assert "clinic" in office.refused("limits", clinic=limits(forward=9.0))


def test_the_dial_turns_down_at_once_and_up_only_at_rest(office):
    office.live(0.1)
    full = office.setup.chain.limits
    assert office.done("dial", share=0.5)["share"] == 0.5
    assert office.setup.chain.limits.turn == 0.5 * full.turn
    office.setup.chain.gate.last = Twist(0.2, 0.0)
    office.done("dial", share=0.4)
    assert "turned up only" in office.refused("dial", share=0.5)
    office.setup.chain.gate.stand()
    assert office.done("status")["dial"] == 0.4
    for share in (0.0, 0.09, 1.01, None, "1"):
        assert "share" in office.refused("dial", share=share)


@pytest.mark.parametrize(
    ("said", "fault"),
    [
        ({"screen_age": 0.1}, Fault.NONE),
        ({"screen_age": 0.1, "screen": "in view"}, Fault.NONE),
        ({"screen_age": 0.1, "screen": "hidden"}, Fault.SCREEN_HIDDEN),
        ({"screen_age": 0.1, "screen": "slow"}, Fault.SCREEN_SLOW),
        ({"screen_age": 0.31}, Fault.SCREEN_LOST),
        ({"screen_age": None}, Fault.SCREEN_LOST),
    ],
)
def test_the_heartbeat_says_which_of_three_is_wrong_with_the_screen(office, said, fault):
    office.live(0.1)
    office.tell("heartbeat", screen_age=0.0, screen="hidden")  # of the drive before
    office.done("arm", hash=office.parameters.hash)
    office.loop.turn()
    gate = office.setup.chain.gate
    assert (gate.state, gate.fault) == (State.CHECKING, Fault.NONE)
    office.tell("heartbeat", **said)
    office.loop.turn()
    assert gate.fault is fault
    assert "screen" in office.refused("heartbeat", screen_age=0.0, screen="away")


def test_limits_dial_and_the_count_of_stops_outlive_other_parameters(office):
    office.live(0.1)
    office.done("limits", clinic=limits(forward=0.5))
    office.done("dial", share=0.5)
    office.done("stop", by="tablet")
    office.done("stop", by="tablet")
    slower = office.parameters.model_copy(update={"speeds": Speeds(turn=1.0)})
    office.done("parameters", parameters=slower.model_dump(mode="json"))
    chain = office.setup.chain
    assert (chain.limits.forward, chain.limits.turn, chain.dial) == (0.25, 0.5, 0.5)
    assert (chain.gate.state, chain.gate.fault) == (State.FAULT, Fault.STOP_TABLET)
    assert chain.gate.stops >= 2


def test_only_the_stop_that_was_seen_is_cleared(office):
    office.live(0.1)
    office.done("stop", by="tablet")
    office.live(0.05)
    seen = int(office.ring.newest()["stops"])
    office.done("stop", by="key")
    assert "another stop" in office.refused("clear", stops=seen)
    assert office.setup.chain.gate.fault is Fault.STOP_TABLET
    office.live(0.05)
    office.done("clear", stops=int(office.ring.newest()["stops"]))
    assert office.setup.chain.gate.state is State.DISARMED
    office.done("clear", stops=0)  # nothing to clear is no fault
    assert "stops" in office.refused("clear")


def test_a_chair_that_cannot_be_had_leaves_the_one_before(office, chair):
    before = office.setup.chair
    chair.key_file.chmod(0o644)
    assert "can be read by others" in office.refused("chair", config=chair.document)
    assert "no chair of the kind 'sofa'" in office.refused("chair", config={"kind": "sofa"})
    assert office.setup.chair is before
    assert office.done("status")["chair"]["kind"] == "virtual"


def test_the_caps_of_a_real_chair_hold_and_go_with_it(office, chair):
    office.live(0.1)
    slow = {**chair.document, "speeds": limits(forward=0.25)}
    assert office.done("chair", config=slow)["kind"] == "udp"
    assert office.setup.chain.limits.forward == 0.25
    assert office.setup.chair._digest == bytes.fromhex(office.parameters.hash)[:8]
    assert office.done("chair", config={"kind": "virtual", "dynamics": "wheelchair"})["kind"] == "virtual"
    assert office.setup.chain.limits.forward == office.parameters.speeds.forward
    assert "wheelchair" in office.done("status")["chair"]["words"]


def test_a_real_chair_is_armed_only_when_it_is_recorded_heard_and_its_switch_is_known(office, chair, tmp_path):
    office.live(0.1)
    office.done("chair", config=chair.document)
    digest = office.parameters.hash
    assert "recorded" in office.refused("arm", hash=digest)
    office.done("run", run_id="r", folder=str(tmp_path / "r"), kind="drive", cues=[], meta={})
    assert "does not answer" in office.refused("arm", hash=digest)

    def hear(**changes):
        office.live(0.01)
        chair.commands()
        chair.say(**changes)
        office.live(0.01)

    hear()
    assert "needs its stop switch" in office.refused("arm", hash=digest)
    hear(stop_input=1, state=3, fault=4)
    assert "stop switch pressed" in office.refused("arm", hash=digest)
    hear()
    office.done("arm", hash=digest)
    assert office.setup.chain.gate.state is State.CHECKING


@pytest.mark.parametrize("free", [LEAST_FREE - 1, LEAST_FREE])
def test_no_run_begins_on_a_disk_that_could_fill(office, tmp_path, monkeypatch, free):
    monkeypatch.setattr(shutil, "disk_usage", lambda _place: SimpleNamespace(free=free))
    run = {"run_id": "r", "folder": str(tmp_path / "deep" / "r"), "kind": "rest", "cues": [], "meta": {}}
    if free < LEAST_FREE:
        assert "500 MB are free" in office.refused("run", **run)
        assert not (tmp_path / "deep").exists()
    else:
        office.done("run", **run)


def test_room_is_looked_for_where_the_folder_will_be(tmp_path, monkeypatch):
    asked = []
    monkeypatch.setattr(shutil, "disk_usage", lambda place: asked.append(place) or SimpleNamespace(free=0))
    with pytest.raises(CommandRefused, match=r"Only 0 MB are free"):
        require_room(tmp_path / "not" / "yet" / "there")
    assert asked == [tmp_path]


def test_a_shirt_too_slow_for_the_tremor_damping_takes_no_controls_and_ends_nothing(office):
    layout = office.parameters.profile.layout.model_dump(mode="json")
    quick = office.parameters.model_copy(update={"cutoff": 8.0})
    office.done("parameters", parameters=quick.model_dump(mode="json"))
    answer = office.done("shirt", config={"kind": "simulator", "layout": layout, "sample_rate": 16.0})
    assert answer["hash"] is None
    assert "Tremor damping of 8 Hz" in office.refused("parameters", parameters=quick.model_dump(mode="json"))
    office.done("parameters", parameters=office.parameters.model_dump(mode="json"))


def test_a_defect_of_a_command_is_a_sentence_and_ends_nothing(office, monkeypatch):
    def fails(_speeds):
        raise KeyError("nobody\nforesaw this")

    monkeypatch.setattr(office.setup, "use_clinic", fails)
    assert "report it" in office.refused("limits", clinic=limits())
    office.done("status")


def test_a_defect_after_a_device_was_opened_is_a_sentence_and_ends_nothing(office, monkeypatch):
    def fails():
        raise KeyError("nobody foresaw this")

    monkeypatch.setattr(office.loop, "begin_anew", fails)
    assert "report it" in office.refused("chair", config={"kind": "virtual"})
    office.done("status")


def test_what_nobody_could_stop_is_not_armed(office):
    parameters = office.parameters.model_copy(update={"mode_u2": "acceleration", "bindings": ONE_WAY})
    office.done("parameters", parameters=parameters.model_dump(mode="json"))
    assert "bind a movement" in office.refused("arm", hash=parameters.hash)


def test_a_set_without_a_time_out_of_turning_is_not_driven(office):
    before = office.parameters.model_copy(update={"turn_cruise_time": None})
    assert "save them anew" in office.refused("parameters", parameters=before.model_dump(mode="json"))


def test_a_head_tracker_is_chosen_asked_and_given_back(office, tmp_path):
    nobody = office.done("status")["head"]
    assert nobody["kind"] == ""
    office.done("head", config={"kind": "tablet"})
    assert office.done("status")["head"]["kind"] == "tablet"
    assert "first pose" in office.refused("head_ahead")
    office.tell("look", yaw=0.5, pitch=0.1, roll=0.0)
    office.live(0.05)
    assert float(office.ring.newest()["head_yaw"]) == 0.5
    office.done("head_ahead")
    office.live(0.05)
    assert float(office.ring.newest()["head_yaw"]) == 0.0
    assert "yaw" in office.refused("look", yaw="left", pitch=0.0, roll=0.0)
    assert "kind" in office.refused("head", config={"kind": "owl"})
    assert office.done("status")["head"]["kind"] == "tablet", "what cannot be read changes nothing"
    office.done("head", config=None)
    assert office.done("status")["head"] == nobody
    office.tell("look", yaw=0.5, pitch=0.1, roll=0.0)
    office.live(0.05)
    assert math.isnan(office.ring.newest()["head_yaw"])
    office.done("run", run_id="r", folder=str(tmp_path / "r"), kind="drive")
    assert "recorded already" in office.refused("head", config={"kind": "tablet"})
    office.done("arm", hash=office.parameters.hash)
    assert "is armed" in office.refused("head", config=None)


def network_shirt(office, **more):
    """Choose a shirt over the network, and return the office's device that sends to it."""
    layout = office.parameters.profile.layout
    config = {"kind": "udp", "port": 0, "layout": layout.model_dump(mode="json"), **more}
    office.done("shirt", config=config)
    office.setup.use_parameters(office.parameters)
    return office.setup.shirt.address


def test_another_sender_is_named_and_taken_only_while_disarmed(office):
    values = np.zeros(52, np.float32)
    assert office.done("status")["shirt"]["senders"] is None
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as own,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other,
    ):
        address = network_shirt(office)
        for device in (own, other):
            device.sendto(encode(1, 0.0, values), address)
            office.setup.shirt.read(1.0)
        senders = office.done("status")["shirt"]["senders"]
        name = f"127.0.0.1:{other.getsockname()[1]}"
        assert senders == {"shirt": f"127.0.0.1:{own.getsockname()[1]}", "other": name, "others": 1}
        office.setup.chain.gate.state = State.CHECKING
        assert "armed" in office.refused("sender", sender=name)
        office.setup.chain.gate.state = State.DISARMED
        assert "look again" in office.refused("sender", sender="127.0.0.1:1")
        office.done("sender", sender=name)
        assert office.done("status")["shirt"]["senders"] == {"shirt": name, "other": "", "others": 0}
    office.setup.close()


def test_a_source_without_trust_arms_no_real_chair(office, chair, tmp_path):
    """Safety S29."""
    office.done("chair", config=chair.document)
    digest = office.parameters.hash
    network_shirt(office)
    assert "a shirt without a key arms no real chair" in office.refused("arm", hash=digest).lower()
    office.done(
        "shirt", config={"kind": "simulator", "layout": office.parameters.profile.layout.model_dump(mode="json")}
    )
    office.setup.use_parameters(office.parameters)
    assert "nobody wears it" in office.refused("arm", hash=digest)
    network_shirt(office, key_file=str(shirt_key_file(tmp_path, pair_shirt(tmp_path).id)))
    assert "begin a drive" in office.refused("arm", hash=digest)
    office.setup.close()

"""Commands of the control process, executed or refused, on a fake clock without a process."""

import math
import shutil
import socket
from types import SimpleNamespace

import numpy as np
import pytest
from hardware.shirt.camera_page import CHANNELS, message_of

from app.arrivals import arrivals_from
from app.calibration.vocabulary import Binding
from app.disk_room import ROOM_TO_RECORD
from app.faults import Fault, State
from app.geometry import Twist
from app.hardware.chair.key import new_key, read_key, write_key
from app.hardware.shirt.kind import NO_CABLE
from app.hardware.shirt.packet import encode
from app.pipeline.runs import require_room
from app.pipeline.setup import CommandRefused, Setup
from app.session.equipment.pairing import pair_shirt, shirt_key_file
from app.speed_limits import HIGHEST_SPEEDS, Speeds
from app.world.clearance import Clearance
from app.world.floorplan import MAX_WALLS

ONE_WAY = (Binding(control="u2+", gestures=("left_shoulder",)),)


def limits(**changes):
    return HIGHEST_SPEEDS.model_copy(update=changes).model_dump()


def test_lower_limits_hold_at_once_and_higher_ones_only_at_rest(control):
    control.live(0.1)
    control.done("limits", clinic=limits(forward=0.5))
    assert control.setup.chain.limits.forward == 0.5
    gate = control.setup.chain.gate
    gate.last = Twist(0.4, 0.0)  # as while driving
    control.done("limits", clinic=limits(forward=0.3))
    assert control.setup.chain.limits.forward == 0.3
    assert "raised only while" in control.refused("limits", clinic=limits(forward=0.4))
    assert control.setup.chain.limits.forward == 0.3
    gate.stand()
    control.done("limits", clinic=limits(forward=0.4))
    assert control.setup.chain.limits.forward == 0.4
    assert "clinic" in control.refused("limits", clinic=limits(forward=9.0))


def test_the_dial_turns_down_at_once_and_up_only_at_rest(control):
    control.live(0.1)
    full = control.setup.chain.limits
    assert control.done("dial", share=0.5)["share"] == 0.5
    assert control.setup.chain.limits.turn == 0.5 * full.turn
    control.setup.chain.gate.last = Twist(0.2, 0.0)
    control.done("dial", share=0.4)
    assert "turned up only" in control.refused("dial", share=0.5)
    control.setup.chain.gate.stand()
    assert control.done("status")["dial"] == 0.4
    for share in (0.0, 0.09, 1.01, None, "1"):
        assert "share" in control.refused("dial", share=share)


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
def test_the_heartbeat_says_which_of_three_is_wrong_with_the_screen(control, said, fault):
    control.live(0.1)
    control.notify("heartbeat", screen_age=0.0, screen="hidden")  # of the drive before
    control.done("arm", hash=control.parameters.hash)
    control.loop.turn()
    gate = control.setup.chain.gate
    assert (gate.state, gate.fault) == (State.CHECKING, Fault.NONE)
    control.notify("heartbeat", **said)
    control.loop.turn()
    assert gate.fault is fault
    assert "screen" in control.refused("heartbeat", screen_age=0.0, screen="away")


def test_limits_dial_and_the_count_of_stops_outlive_other_parameters(control):
    control.live(0.1)
    control.done("limits", clinic=limits(forward=0.5))
    control.done("dial", share=0.5)
    control.done("stop", by="tablet")
    control.done("stop", by="tablet")
    slower = control.parameters.model_copy(update={"speeds": Speeds(turn=1.0)})
    control.done("parameters", parameters=slower.model_dump(mode="json"))
    chain = control.setup.chain
    assert (chain.limits.forward, chain.limits.turn, chain.dial) == (0.25, 0.5, 0.5)
    assert (chain.gate.state, chain.gate.fault) == (State.FAULT, Fault.STOP_TABLET)
    assert chain.gate.stops == 2  # other parameters are no further stop


def test_only_the_stop_that_was_seen_is_cleared(control):
    control.live(0.1)
    control.done("stop", by="tablet")
    control.live(0.05)
    seen = int(control.ring.newest()["stops"])
    control.done("stop", by="key")
    assert "another stop" in control.refused("clear", stops=seen)
    assert control.setup.chain.gate.fault is Fault.STOP_TABLET
    control.live(0.05)
    control.done("clear", stops=int(control.ring.newest()["stops"]))
    assert control.setup.chain.gate.state is State.DISARMED
    control.done("clear", stops=0)  # clearing without a fault is accepted
    assert "stops" in control.refused("clear")


def test_a_chair_that_cannot_be_had_leaves_the_one_before(control, chair):
    before = control.setup.chair
    chair.key_file.chmod(0o644)
    assert "can be read by others" in control.refused("chair", config=chair.document)
    assert "no chair of the kind 'sofa'" in control.refused("chair", config={"kind": "sofa"})
    assert control.setup.chair is before
    assert control.done("status")["chair"]["kind"] == "virtual"


def test_the_caps_of_a_real_chair_hold_and_go_with_it(control, chair):
    control.live(0.1)
    slow = {**chair.document, "speeds": limits(forward=0.25)}
    assert control.done("chair", config=slow)["kind"] == "udp"
    assert control.setup.chain.limits.forward == 0.25
    assert control.setup.chair._digest == bytes.fromhex(control.parameters.hash)[:8]
    assert control.done("chair", config={"kind": "virtual", "dynamics": "wheelchair"})["kind"] == "virtual"
    assert control.setup.chain.limits.forward == control.parameters.speeds.forward
    words = control.done("status")["chair"]["words"]
    assert words == {"text": "drives-virtual-chair", "values": {"dynamics": "wheelchair"}}


def test_a_real_chair_is_armed_only_when_it_is_recorded_heard_and_its_switch_is_known(control, chair, tmp_path):
    control.live(0.1)
    control.done("chair", config=chair.document)
    digest = control.parameters.hash
    assert "recorded" in control.refused("arm", hash=digest)
    control.done("run", run_id="r", folder=str(tmp_path / "r"), kind="drive", cues=[], meta={})
    assert "does not answer" in control.refused("arm", hash=digest)

    def hear(**changes):
        control.live(0.01)
        chair.commands()
        chair.say(**changes)
        control.live(0.01)

    hear()
    assert "needs its stop switch" in control.refused("arm", hash=digest)
    hear(stop_input=1, state=3, fault=4)
    assert "stop switch pressed" in control.refused("arm", hash=digest)
    hear()
    control.done("arm", hash=digest)
    assert control.setup.chain.gate.state is State.CHECKING


@pytest.mark.parametrize("free", [ROOM_TO_RECORD - 1, ROOM_TO_RECORD])
def test_no_run_begins_on_a_disk_that_could_fill(control, tmp_path, monkeypatch, free):
    monkeypatch.setattr(shutil, "disk_usage", lambda _place: SimpleNamespace(free=free))
    run = {"run_id": "r", "folder": str(tmp_path / "deep" / "r"), "kind": "rest", "cues": [], "meta": {}}
    if free < ROOM_TO_RECORD:
        assert "500 MB are free" in control.refused("run", **run)
        assert not (tmp_path / "deep").exists()
    else:
        control.done("run", **run)


def test_room_is_looked_for_where_the_folder_will_be(tmp_path, monkeypatch):
    asked = []
    monkeypatch.setattr(shutil, "disk_usage", lambda place: asked.append(place) or SimpleNamespace(free=0))
    with pytest.raises(CommandRefused, match=r"Only 0 MB are free"):
        require_room(tmp_path / "not" / "yet" / "there")
    assert asked == [tmp_path]


def test_a_shirt_too_slow_for_the_tremor_damping_takes_no_controls_and_ends_nothing(control):
    layout = control.parameters.profile.layout.model_dump(mode="json")
    quick = control.parameters.model_copy(update={"cutoff": 8.0})
    control.done("parameters", parameters=quick.model_dump(mode="json"))
    answer = control.done("shirt", config={"kind": "simulator", "layout": layout, "sample_rate": 16.0})
    assert answer["hash"] is None
    assert "Tremor damping of 8 Hz" in control.refused("parameters", parameters=quick.model_dump(mode="json"))
    control.done("parameters", parameters=control.parameters.model_dump(mode="json"))


def test_a_defect_of_a_command_or_after_a_device_was_opened_is_a_sentence_and_ends_nothing(control, monkeypatch):
    def fails(*_):
        raise KeyError("nobody\nforesaw this")

    for part, name, do, fields in (
        (control.setup, "use_clinic", "limits", {"clinic": limits()}),
        (control.loop, "begin_anew", "chair", {"config": {"kind": "virtual"}}),
    ):
        with monkeypatch.context() as broken:
            broken.setattr(part, name, fails)
            assert "report it" in control.refused(do, **fields)
        control.done("status")


def test_what_nobody_could_stop_is_not_armed(control):
    parameters = control.parameters.model_copy(update={"mode_u2": "acceleration", "bindings": ONE_WAY})
    control.done("parameters", parameters=parameters.model_dump(mode="json"))
    assert "bind a movement" in control.refused("arm", hash=parameters.hash)


def test_a_head_tracker_is_chosen_asked_and_given_back(control, tmp_path):
    nobody = control.done("status")["head"]
    assert nobody["kind"] == ""
    control.done("head", config={"kind": "tablet"})
    assert control.done("status")["head"]["kind"] == "tablet"
    assert "first pose" in control.refused("head_ahead")
    control.notify("look", yaw=0.5, pitch=0.1, roll=0.0)
    control.live(0.05)
    assert float(control.ring.newest()["head_yaw"]) == 0.5
    control.done("head_ahead")
    control.live(0.05)
    assert float(control.ring.newest()["head_yaw"]) == 0.0
    assert "yaw" in control.refused("look", yaw="left", pitch=0.0, roll=0.0)
    assert "kind" in control.refused("head", config={"kind": "owl"})
    assert control.done("status")["head"]["kind"] == "tablet", "what cannot be read changes nothing"
    control.done("head", config=None)
    assert control.done("status")["head"] == nobody
    control.notify("look", yaw=0.5, pitch=0.1, roll=0.0)
    control.live(0.05)
    assert math.isnan(control.ring.newest()["head_yaw"])
    control.done("run", run_id="r", folder=str(tmp_path / "r"), kind="drive")
    assert "recorded already" in control.refused("head", config={"kind": "tablet"})
    control.done("arm", hash=control.parameters.hash)
    assert "is armed" in control.refused("head", config=None)


def test_the_camera_takes_samples_which_any_other_shirt_refuses(control):
    message = message_of(0, 1.0, 1.02, np.linspace(0.0, 1.0, CHANNELS, dtype=np.float32))
    sample = {"page": 1, "message": message.hex(), "received": control.clock.now()}
    assert "The camera is not the shirt in use" in control.refused("sample", **sample)
    control.done("shirt", config={"kind": "camera"})
    control.notify("sample", **sample)
    for wrong in ({"message": "0"}, {"message": "zz"}, {"message": "00" * 513}, {"received": math.inf}, {"page": -1}):
        assert control.refused("sample", **sample | wrong)
    frame = control.setup.shirt.read(0.1)
    np.testing.assert_allclose(frame.values, np.linspace(0.0, 1.0, CHANNELS), atol=1e-6)


def test_controls_of_sensors_that_may_stay_constant_drive_no_shirt_whose_sensors_have_to_tremble(control):
    """Safety S5: with them, a broken line of that shirt would not be found."""
    profile = control.parameters.profile
    channels = tuple(channel.model_copy(update={"liveness": "arrival"}) for channel in profile.layout.channels)
    layout = profile.layout.model_copy(update={"channels": channels})
    others = control.parameters.model_copy(update={"profile": profile.model_copy(update={"layout": layout})})
    assert "a shirt with other sensors" in control.refused("parameters", parameters=others.model_dump(mode="json"))


def network_shirt(control, **more):
    """Choose a shirt over the network, and return the control's device that sends to it."""
    layout = control.parameters.profile.layout
    config = {"kind": "udp", "port": 0, "layout": layout.model_dump(mode="json"), **more}
    control.done("shirt", config=config)
    control.setup.use_parameters(control.parameters)
    return control.setup.shirt.address


def test_another_sender_is_named_and_taken_only_while_disarmed(control):
    values = np.zeros(52, np.float32)
    assert control.done("status")["shirt"]["senders"] is None
    with (
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as own,
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as other,
    ):
        address = network_shirt(control)
        for device in (own, other):
            device.sendto(encode(1, 0.0, values), address)
            control.setup.shirt.read(1.0)
        senders = control.done("status")["shirt"]["senders"]
        name = f"127.0.0.1:{other.getsockname()[1]}"
        assert senders == {"shirt": f"127.0.0.1:{own.getsockname()[1]}", "other": name, "others": 1}
        control.setup.chain.gate.state = State.CHECKING
        assert "armed" in control.refused("sender", sender=name)
        control.setup.chain.gate.state = State.DISARMED
        assert "look at the Shirt page" in control.refused("sender", sender="127.0.0.1:1")
        control.done("sender", sender=name)
        assert control.done("status")["shirt"]["senders"] == {"shirt": name, "other": "", "others": 0}
    control.setup.close()


def test_the_status_says_what_arrives_where_the_shirt_says_it(control):
    assert control.done("status")["shirt"]["arrivals"] is None
    network_shirt(control)
    arrivals = arrivals_from(control.done("status")["shirt"]["arrivals"])
    assert (arrivals.verdict, str(arrivals.message)) == ("waiting", "Waiting for signals.")
    control.setup.close()


def test_a_source_without_trust_arms_no_real_chair(control, chair, tmp_path):
    """Safety S29."""
    control.done("chair", config=chair.document)
    digest = control.parameters.hash
    network_shirt(control)
    assert "a shirt without a key arms no real chair" in control.refused("arm", hash=digest).lower()
    layout = control.parameters.profile.layout.model_dump(mode="json")
    control.done("shirt", config={"kind": "simulator", "layout": layout})
    control.setup.use_parameters(control.parameters)
    assert "nobody wears it" in control.refused("arm", hash=digest)
    network_shirt(control, key_file=str(shirt_key_file(tmp_path, pair_shirt(tmp_path).id)))
    assert "begin a drive" in control.refused("arm", hash=digest)
    control.setup.close()


def test_a_line_that_becomes_a_cable_while_it_is_asked_arms_no_real_chair(control, chair, monkeypatch):
    """Safety S29."""
    control.done("chair", config=chair.document)
    answers = iter([NO_CABLE, None])
    monkeypatch.setattr(Setup, "mistrust", property(lambda _setup: next(answers)))
    assert control.refused("arm", hash=control.parameters.hash) == str(NO_CABLE)


@pytest.mark.parametrize("happens", ["deleted", "replaced", "readable"])
def test_without_the_key_of_its_shirt_neither_chair_is_armed(control, chair, tmp_path, happens):
    """After its key was deleted, which unpairs it, the shirt armed and drove."""
    file = shirt_key_file(tmp_path, pair_shirt(tmp_path).id)
    network_shirt(control, key_file=str(file))
    digest = control.parameters.hash
    control.done("arm", hash=digest)
    control.done("disarm")
    key = read_key(file)
    change_key(file, happens)
    for config in ({"kind": "virtual"}, chair.document):
        control.done("chair", config=config)
        assert control.refused("arm", hash=digest).startswith(f"The shirt is no longer paired: the key file {file} ")
    file.unlink(missing_ok=True)
    write_key(file, key)
    assert "begin a drive" in control.refused("arm", hash=digest)
    control.setup.close()


@pytest.mark.parametrize("happens", ["deleted", "replaced", "readable"])
def test_without_its_key_a_real_chair_is_not_armed_and_a_halted_drive_does_not_go_on(control, chair, tmp_path, happens):
    control.live(0.1)
    control.done("chair", config=chair.document)
    control.done("run", run_id="r", folder=str(tmp_path / "r"), kind="drive", cues=[], meta={})
    for changes in ({}, {"stop_input": 1, "state": 3}, {}):
        control.live(0.01)
        chair.commands()
        chair.say(**changes)
        control.live(0.01)
    control.done("arm", hash=control.parameters.hash)
    change_key(chair.key_file, happens)
    control.done("stop", by="tablet")
    words = "The chair is no longer paired: the key file"
    assert control.refused("clear", stops=1).startswith(words)
    control.done("end_run")
    assert control.setup.chain.gate.clear(1)
    assert control.refused("arm", hash=control.parameters.hash).startswith(words)


def change_key(file, how):
    if how == "readable":
        file.chmod(0o644)
        return
    file.unlink()
    if how == "replaced":
        write_key(file, new_key(7))


def test_a_floor_plan_is_not_measured_anew_between_two_ticks(control, monkeypatch):
    """It was when it was saved; the largest one took so long that the process counted as hung, and Stop waited."""

    def never(*_):
        raise AssertionError("the paths were compared with the walls")

    monkeypatch.setattr(Clearance, "along", never)
    wall, line = [[5.0, 0.0], [5.0, 3.0]], [[0.0, 0.0], [3.0, 0.0]]
    path = {"name": "main", "title": "Main", "points": line, "instruction": "Go."}
    plan = {"name": "room", "title": "Room", "walls": [wall], "paths": [path]}
    control.done("world", floorplan=plan, path="main")
    assert control.setup.floorplan.name == "room"
    assert "at most" in control.refused("world", floorplan=plan | {"walls": [wall * (MAX_WALLS // 2 + 1)]}, path="main")


def test_only_the_set_whose_hash_is_given_is_armed(control):
    control.live(0.1)
    for digest in ("0" * 64, control.parameters.hash[::-1]):
        assert "changed meanwhile" in control.refused("arm", hash=digest)
    assert control.setup.chain.gate.state is State.DISARMED
    control.done("arm", hash=control.parameters.hash)

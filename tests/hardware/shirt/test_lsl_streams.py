"""Which LSL streams are meant, and the layout that they describe."""

import re

import pytest
from fake_clock import FakeClock
from hardware.shirt.fake_lsl import FakeLsl
from hardware.shirt.shirts import small_layout
from hypothesis import given
from hypothesis import strategies as st
from pydantic import ValidationError

from app.hardware.base import HardwareError
from app.hardware.shirt.lsl import LslConfig
from app.hardware.shirt.lsl_streams import (
    ChannelFacts,
    StreamFacts,
    channels_of,
    chosen_streams,
    layout_of,
    sought_of,
    streams_in,
)
from app.layout import MAX_CHANNELS
from app.lsl_library import OWN_SOURCE
from app.texts import LANGUAGES, reader_language


def facts(name="Arm", source_id="arm-1", *, kind="MoCap", host="lab", channels=3, rate=100.0, uid="1"):
    return StreamFacts(source_id, name, kind, host, channels, 1, rate, uid)


ARM, OTHER, GLOVE = facts(), facts(source_id="arm-2", host="desk", uid="2"), facts("Glove", "glove", kind="Stretch")
VISIBLE = [ARM, OTHER, GLOVE]


def choose(**fields):
    none = dict.fromkeys(("source_id", "name", "type", "host"))
    return chosen_streams(VISIBLE, sought_of(none | fields))


@pytest.mark.parametrize(
    ("fields", "chosen"),
    [
        ({"name": "Glove"}, (GLOVE,)),
        ({"type": "Stretch"}, (GLOVE,)),
        ({"source_id": "arm-2"}, (OTHER,)),
        ({"name": "Arm", "host": "desk"}, (OTHER,)),
        ({"name": "Arm", "host": " desk , "}, (OTHER,)),
        ({"source_id": "glove, arm-1"}, (GLOVE, ARM)),
        ({"name": "Arm", "host": "lab,desk"}, (ARM, OTHER)),
        ({"name": "Glove,Arm", "source_id": "arm-2,glove"}, (OTHER, GLOVE)),
    ],
)
def test_a_stream_is_chosen_by_what_is_known_of_it_and_several_in_the_order_in_which_they_are_named(fields, chosen):
    assert choose(**fields) == chosen


def test_two_streams_of_one_name_are_listed_with_how_to_choose():
    with pytest.raises(HardwareError) as refused:
        choose(name="Arm")
    assert str(refused.value) == (
        "2 LSL streams fit, such as Arm (source ID arm-1, type MoCap, computer lab) and Arm (source ID arm-2, type "
        "MoCap, computer desk): enter the source ID or the computer of one, or several source IDs with commas between "
        "them to join these streams"
    )


@pytest.mark.parametrize("fields", [{}, {"name": "Arm,Glove"}, {"type": "MoCap"}])
def test_what_is_not_clear_is_refused(fields):
    with pytest.raises(HardwareError, match="LSL streams fit"):
        choose(**fields)


@pytest.mark.parametrize(("fields", "sought"), [({"name": "arm"}, "arm"), ({"source_id": "arm-1,arm-3"}, "arm-3")])
def test_a_stream_that_is_not_there_is_named_with_those_that_are(fields, sought):
    with pytest.raises(HardwareError, match=f"no LSL stream fits {sought}, the network has Arm .* and Glove"):
        choose(**fields)


def test_a_network_without_a_stream_says_what_may_hold_it_up():
    with pytest.raises(HardwareError, match=r"no LSL stream of numbers is on this network: .* 16571 to 16604"):
        chosen_streams([], {"name": ("Arm",)})


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_sentence_is_written_in_each_language(language):
    with reader_language(language):
        for refused in ({"name": "Arm"}, {"name": "x"}):
            with pytest.raises(HardwareError) as error:
                choose(**refused)
            assert "arm-1" in str(error.value)
            assert not re.search(r"[{}$]|shirtdev", str(error.value))


def test_names_of_the_network_are_shortened_and_hold_nothing_invisible():
    odd = facts("A\u202e\nB" + "x" * 500, "s" * 500, kind="")
    assert len(str(odd.text)) < 200
    assert str(odd.text).startswith("A Bxxx")
    assert "type" not in str(odd.text)
    assert str(odd.text).isprintable()


def test_markers_and_the_programs_own_streams_are_no_shirt():
    lsl = FakeLsl(FakeClock())
    arm = lsl.add_sender()
    lsl.add_sender("Events", 1, 0.0, form=lsl.cf_string)
    lsl.add_sender("ticks", source_id=f"{OWN_SOURCE}ticks.lab")
    broken = lsl.add_sender(rate=float("nan"), source_id="nan")
    found = streams_in(lsl, lsl.resolve_streams(1.0))
    assert list(found.values()) == [arm.info, broken.info]
    assert [stream.rate for stream in found] == [100.0, 0.0]


def test_a_restart_is_the_same_stream_of_the_same_machine():
    assert facts(uid="9").is_restart_of(ARM)
    assert not ARM.is_restart_of(ARM)
    assert not facts(uid="9", host="elsewhere").is_restart_of(ARM)
    assert not facts(uid="9", channels=4).is_restart_of(ARM)


def test_labels_units_and_joints_of_the_description_become_the_layout():
    lsl = FakeLsl(FakeClock())
    sender = lsl.add_sender(
        "Arm, left",
        4,
        labels=("right_elbow_1", "right_elbow_2", "EMG 1 (µV)", "Füße"),
        units=("kOhm", "", "µV", "none"),
        joints=("", "", "forearm", ""),
    )
    (stream,) = streams_in(lsl, [sender.info])
    layout = layout_of([(stream, channels_of(sender.info))])
    assert layout.name == "Arm, left"
    assert [(channel.name, channel.joint, channel.unit) for channel in layout.channels] == [
        ("right_elbow_1", "right_elbow", "kOhm"),
        ("right_elbow_2", "right_elbow", None),
        ("EMG_1_V", "forearm", "µV"),
        ("Fue", "Fue", None),
    ]
    assert str(layout.joint_titles["right_elbow"]) == "Right elbow"


def test_channels_without_labels_are_numbered_and_equal_names_differ():
    plain = [ChannelFacts()] * 2
    layout = layout_of([(ARM, plain), (OTHER, plain), (GLOVE, [ChannelFacts("Arm_1")] * 2)])
    assert layout.channel_names == ["Arm_1", "Arm_2", "Arm_1_2", "Arm_2_2", "Arm_1_3", "Arm_1_4"]
    assert layout.joint_names == ["Arm"]


def test_more_joints_than_a_layout_may_have_are_one_for_each_stream():
    names = [ChannelFacts(f"{letter}{letter}") for letter in "abcdefghijklmnopqrs"]
    layout = layout_of([(ARM, names), (GLOVE, [ChannelFacts("left.x"), ChannelFacts("left.y")])])
    assert layout.joint_names == ["Arm", "Glove"]
    assert layout_of([(GLOVE, [ChannelFacts("left.x"), ChannelFacts("left.y")])]).joint_names == ["left"]
    many = [(facts(f"S{i}q", channels=1), [ChannelFacts(f"q{i}w")]) for i in range(20)]
    assert layout_of(many).joint_names == ["body"]


def test_too_many_channels_are_refused():
    with pytest.raises(HardwareError, match=f"have {MAX_CHANNELS + 1} channels together, at most {MAX_CHANNELS}"):
        layout_of([(ARM, [ChannelFacts()] * (MAX_CHANNELS + 1))])


@given(st.lists(st.tuples(st.text(), st.text(max_size=30), st.text()), min_size=1, max_size=20), st.text())
def test_any_description_makes_a_layout(described, name):
    layout = layout_of([(facts(name), [ChannelFacts(*channel) for channel in described])])
    assert len(layout.channels) == len(described)


def test_a_layout_keeps_its_hash_without_units():
    layout = small_layout()
    assert "unit" not in layout.model_dump_json()
    assert "unit" not in layout.channels[0].model_dump()


@pytest.mark.parametrize("field", ["name", "source_id", "type", "host"])
@pytest.mark.parametrize("text", ["", "x" * 201, "a\u202eb", "a\nb", 7])
def test_odd_texts_are_refused(field, text):
    with pytest.raises(ValidationError):
        LslConfig.model_validate({"kind": "lsl", field: text})
    assert LslConfig(kind="lsl").layout is None

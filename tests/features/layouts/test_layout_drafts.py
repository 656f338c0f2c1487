"""The first layout of a file of signals, and the same file replayed in a layout that a person has made of it."""

from pathlib import Path

import numpy as np
import pytest
from fake_clock import FakeClock
from features.layouts.test_joint_groups import RATE, channels

from app.features.layouts.drafts import draft_of_file
from app.hardware.base import HardwareError
from app.hardware.shirt.replay import ReplayConfig, ReplayedShirt
from app.layout import ShirtLayout


@pytest.fixture
def signals(tmp_path: Path) -> Path:
    """Return the folder of a file of signals."""
    return tmp_path / "walk 3.csv"


def write(file: Path, names: list[str], joints: list[int]) -> np.ndarray:
    """Write the signals of channels, of each of which `joints` has its joint; return them."""
    values = channels(joints, np.random.default_rng(1))
    rows = [",".join([f"{i / RATE:.3f}", *(f"{value:.6f}" for value in row)]) for i, row in enumerate(values)]
    file.write_text("\n".join([",".join(["t", *names]), *rows]) + "\n", encoding="utf-8")
    return values


def opened(file: Path, layout: ShirtLayout) -> ReplayedShirt:
    shirt = ReplayedShirt(ReplayConfig(kind="replay", file=str(file), layout=layout), FakeClock())
    shirt.open()
    return shirt


def test_names_are_those_of_the_columns_as_far_as_a_layout_takes_them(signals: Path) -> None:
    write(signals, ["Strain A [mV]", "Strain  A [V]", "größe", "µ"], [0, 0, 1, 1])
    draft = draft_of_file(signals)
    assert draft.layout.name == "walk_3"
    assert draft.layout.channel_names == ["Strain_A", "Strain_A_2", "groe", "channel_4"]
    assert draft.layout.joint_names == ["body"]
    assert draft.groups is not None
    assert draft.groups.groups == ((0, 1), (2, 3))


@pytest.mark.parametrize(
    ("names", "joints"),
    [
        (["right_elbow_1", "right_elbow_2", "left_elbow_1", "left_elbow_2"], ["right_elbow", "left_elbow"]),
        (["hand.x", "hand.y", "head.x", "head.y"], ["hand", "head"]),
        (["hand.x", "hand.y", "head.x", "trunk"], None),  # one says none
        (["ch1", "ch2", "ch3", "ch4"], None),  # numbers alone say no joints
        (["A", "B", "C", "D"], None),
    ],
)
def test_joints_are_those_that_the_names_say(signals: Path, names: list[str], joints: list[str] | None) -> None:
    write(signals, names, [0, 0, 1, 1])
    draft = draft_of_file(signals)
    assert draft.layout.joint_names == (joints or ["body"])
    assert (draft.groups is None) == (joints is not None)


def test_a_file_that_cannot_be_read_is_one_sentence(signals: Path) -> None:
    signals.write_text("t,a\n0,1\n")
    with pytest.raises(ValueError, match="too few") as refused:
        draft_of_file(signals)
    assert "\n" not in str(refused.value)


def test_a_file_is_replayed_in_its_draft_also_when_channels_got_other_names(signals: Path) -> None:
    values = write(signals, ["Strain A [mV]", "Strain B [mV]", "größe", "µ"], [0, 0, 1, 1])
    draft = draft_of_file(signals).layout
    named = draft.channels[0].model_copy(update={"name": "left_elbow_front"})
    renamed = draft.model_copy(update={"channels": (named, *draft.channels[1:])})
    for layout in (draft, renamed):
        shirt = opened(signals, layout)
        frame = shirt.read(1.0)
        assert frame is not None
        assert shirt.layout == layout
        np.testing.assert_allclose(frame.values, values[0], atol=1e-5)


def test_columns_are_found_by_the_names_of_the_layout_before_they_are_taken_in_their_order(signals: Path) -> None:
    values = write(signals, ["a", "b", "c", "d"], [0, 0, 1, 1])
    draft = draft_of_file(signals).layout
    shirt = opened(signals, draft.model_copy(update={"channels": draft.channels[:0:-1]}))
    frame = shirt.read(1.0)
    assert frame is not None
    np.testing.assert_allclose(frame.values, values[0][:0:-1], atol=1e-5)


def test_a_layout_of_another_number_of_channels_is_refused_in_a_sentence(signals: Path) -> None:
    write(signals, ["a", "b", "c", "d"], [0, 0, 1, 1])
    draft = draft_of_file(signals).layout
    other = [channel.model_copy(update={"name": f"x{i}"}) for i, channel in enumerate(draft.channels[:3])]
    with pytest.raises(HardwareError, match="4 columns were named for the 3 channels"):
        opened(signals, draft.model_copy(update={"channels": tuple(other)}))

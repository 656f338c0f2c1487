import json

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.shirts import RATE, small_layout, write_signals

from app.hardware.base import HardwareError
from app.hardware.shirt.playback import FramePlayer, read_frames
from app.hardware.shirt.replay import ReplayConfig, ReplayedShirt
from app.messages import Tick
from app.recording.writer import RunWriter
from building import make_ring
from folders import SHARED

KNIT = SHARED / "data" / "knit_shirt" / "signals.csv"


def open_replay(file, clock, loop=False):
    shirt = ReplayedShirt(ReplayConfig(kind="replay", file=str(file), loop=loop), clock)
    shirt.open()
    return shirt


def test_every_sample_comes_at_its_own_time_and_then_the_words_say_that_it_is_over(tmp_path):
    clock = FakeClock(3.0)
    shirt = open_replay(write_signals(tmp_path / "signals.csv", count=30), clock)
    frames = [shirt.read(1.0) for _ in range(30)]
    assert [frame.values[0] for frame in frames] == list(range(30))
    np.testing.assert_allclose([frame.t for frame in frames], 3.0 + np.arange(30) / RATE, atol=1e-9)
    assert shirt.read(0.5) is None
    assert not shirt.pending()
    assert "has ended" in str(shirt.description())


def test_a_gap_in_the_file_is_a_gap_in_the_replay(tmp_path):
    file = write_signals(tmp_path / "signals.csv", count=50)
    lines = file.read_text().splitlines()
    del lines[21:26]
    file.write_text("\n".join(lines) + "\n")
    clock = FakeClock()
    shirt = open_replay(file, clock)
    frames = [shirt.read(1.0) for _ in range(45)]
    assert shirt.lost == 5
    assert frames[20].seq - frames[19].seq == 6
    assert frames[20].t - frames[19].t == pytest.approx(0.06)


def test_a_looped_file_goes_on_without_a_jump_in_time_or_values(tmp_path):
    t = np.arange(300) / RATE
    rows = ["t,right_elbow_1"] + [f"{when:.2f},{value:.6f}" for when, value in zip(t, t**2, strict=True)]
    file = tmp_path / "signals.csv"
    file.write_text("\n".join(rows) + "\n")
    shirt = open_replay(file, FakeClock(), loop=True)
    frames = [shirt.read(1.0) for _ in range(1000)]
    assert [frame.seq for frame in frames] == list(range(1000))
    np.testing.assert_allclose(np.diff([frame.t_device for frame in frames]), 1 / RATE, atol=1e-9)
    values = np.array([frame.values[0] for frame in frames])
    np.testing.assert_allclose(values[:250], t[:250] ** 2, atol=1e-5)
    assert np.abs(np.diff(values)).max() < 0.4, "from 6.2 back to 0 within half a second, and not at once"
    assert values[250:].max() > 6.0
    assert shirt.lost == 0


def test_a_long_hold_up_makes_the_file_wait(tmp_path):
    clock = FakeClock()
    shirt = open_replay(write_signals(tmp_path / "signals.csv"), clock)
    shirt.read(1.0)
    clock.time += 60.0
    frames = [shirt.read(1.0) for _ in range(5)]
    assert [frame.values[0] for frame in frames] == [1, 2, 3, 4, 5]
    assert shirt.lost == 0


def test_the_layout_comes_from_beside_the_file_before_it_comes_from_the_names(tmp_path):
    file = write_signals(tmp_path / "signals.csv")
    assert read_frames(file).layout.name == "signals"
    other = small_layout().model_dump(mode="json") | {"name": "of the folder"}
    (tmp_path / "layout.json").write_text(json.dumps(other))
    assert read_frames(file).layout.name == "of the folder"
    (tmp_path / "signals.layout.json").write_text(json.dumps(other | {"name": "of the file"}))
    assert read_frames(file).layout.name == "of the file"


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("t,a_1,b\n" + "".join(f"{i / 100},1,2\n" for i in range(20)), "nothing says which joint the column 'b'"),
        ("t,a_1\n0,1\n", "too few"),
        ("t,a_1\n" + "".join(f"{i / 100},x\n" for i in range(20)), "line 2, column 'a_1'"),
        ("", "empty"),
    ],
)
def test_a_file_that_cannot_be_played_is_one_sentence(tmp_path, content, words):
    file = tmp_path / "signals.csv"
    file.write_text(content)
    with pytest.raises(HardwareError, match=words) as refused:
        open_replay(file, FakeClock())
    assert "\n" not in str(refused.value)


def test_a_recorded_run_is_replayed_in_the_layout_that_a_person_gives(tmp_path):
    folder = write_run(tmp_path / "run", range(20), small_layout().model_dump(mode="json"))
    other = small_layout().model_copy(update={"name": "other"})
    assert read_frames(folder, layout=other).layout == other
    with pytest.raises(HardwareError, match="3 channels and its layout 2"):
        read_frames(folder, layout=other.model_copy(update={"channels": other.channels[:2]}))


def test_a_folder_without_a_recording_is_one_sentence(tmp_path):
    with pytest.raises(HardwareError, match="there is no recording in this folder"):
        open_replay(tmp_path, FakeClock())


def test_a_broken_layout_beside_the_file_is_one_sentence(tmp_path):
    file = write_signals(tmp_path / "signals.csv")
    (tmp_path / "layout.json").write_text("{}")
    with pytest.raises(HardwareError, match=r"layout\.json"):
        open_replay(file, FakeClock())


def test_a_layout_beside_the_file_cannot_say_that_values_may_stay_constant(tmp_path):
    """Safety S5: only a driver can, which watches over its sensors."""
    file, layout = write_signals(tmp_path / "signals.csv"), small_layout().model_dump(mode="json")
    for channel in layout["channels"]:
        channel["liveness"] = "arrival"
    (tmp_path / "layout.json").write_text(json.dumps(layout))
    assert read_frames(file).layout == small_layout()


def test_a_player_hands_out_what_was_read(tmp_path):
    played = read_frames(write_signals(tmp_path / "signals.csv", count=40))
    player = FramePlayer(played, loop=False)
    taken = []
    while np.isfinite(player.due):
        taken.append(player.next_frame())
    assert [seq for seq, _t, _values in taken] == list(range(40))
    np.testing.assert_array_equal([values for _seq, _t, values in taken], played.values)


def write_run(folder, seqs, layout):
    """Record ticks whose frames carry `seqs`, and a last turn of the loop without a frame."""
    ring = make_ring()
    meta = {"run_id": "r", "kind": "drive", "layout": layout, "sample_rate": RATE, "gestures": []}
    writer = RunWriter(folder, meta, 3, 0)
    writer.start(ring, 0, 1)
    for i, seq in enumerate(seqs):
        values = np.array([seq, 1, 2], dtype=np.float32)
        ring.write(Tick(t=70 + i / RATE, t_device=seq / RATE, frame_seq=seq, values=values), 1, i / RATE, -1, 0, 0)
    ring.write(Tick(t=80.0), 1, 10.0, -1, 0, 0)
    writer.close(ring.number)
    ring.close()
    return folder


def test_a_recorded_run_is_a_shirt_with_its_own_layout_and_its_own_losses(tmp_path):
    folder = write_run(tmp_path / "run", [*range(5, 20), *range(23, 40)], small_layout().model_dump(mode="json"))
    shirt = open_replay(folder, FakeClock())
    assert shirt.layout == small_layout()
    assert shirt.sample_rate == RATE
    frames = [shirt.read(1.0) for _ in range(32)]
    assert [frame.values[0] for frame in frames] == [*range(5, 20), *range(23, 40)]
    assert shirt.lost == 3
    assert frames[15].t - frames[14].t == pytest.approx(0.04)
    assert shirt.read(1.0) is None


def test_a_device_that_began_anew_while_it_was_recorded_is_played_on_our_own_time(tmp_path):
    folder = write_run(tmp_path / "run", [*range(5000, 5020), *range(20)], small_layout().model_dump(mode="json"))
    played = read_frames(folder)
    np.testing.assert_allclose(np.diff(played.t), 1 / RATE, atol=1e-9)
    assert played.seq.tolist() == list(range(40))


def test_a_recording_whose_layout_is_broken_is_one_sentence(tmp_path):
    folder = write_run(tmp_path / "run", range(20), {"name": "x"})
    with pytest.raises(HardwareError, match="the shirt's layout in this recording") as refused:
        read_frames(folder)
    assert "\n" not in str(refused.value)


def test_a_real_knit_is_a_shirt():
    if not KNIT.exists():
        pytest.skip("The recording of a real knit is not here.")
    shirt = open_replay(KNIT, FakeClock())
    assert shirt.layout.joint_names == ["right_elbow", "left_elbow", "right_shoulder", "left_shoulder"]
    assert shirt.layout.joints[0].label == "Right elbow"
    assert shirt.sample_rate == 100.0
    assert shirt.read(1.0).values.shape == (20,)

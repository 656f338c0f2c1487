import json
import socket

import numpy as np
import pytest
from cli.answers import invoke
from fake_clock import FakeClock

from app.cli.errors import InputError
from app.cli.replay import parse_address, play
from app.hardware.shirt.packet import decode
from app.hardware.shirt.playback import read_frames


@pytest.fixture
def signals(tmp_path):
    file = tmp_path / "signals.csv"
    rows = ["t,right_elbow_1,right_elbow_2"] + [f"{i / 100},{i},{-i}" for i in range(20)]
    file.write_text("\n".join(rows) + "\n")
    return file


def test_what_is_played_are_the_frames_at_their_own_times(signals):
    clock, sent = FakeClock(7.0), []
    play(read_frames(signals), lambda packet: sent.append((clock.now(), packet)) or "", clock, loop=False, speed=2.0)
    np.testing.assert_allclose([when for when, _ in sent], 7.0 + np.arange(20) / 200, atol=1e-9)
    frames = [decode(packet, len(packet), 2) for _, packet in sent]
    assert [seq for seq, _, _ in frames] == list(range(20))
    assert [microseconds for _, microseconds, _ in frames] == [10_000 * i for i in range(20)]
    np.testing.assert_array_equal([values for _, _, values in frames], [[i, -i] for i in range(20)])


def test_a_loop_goes_on_until_ctrl_c(signals):
    sent = []

    def send(packet):
        sent.append(decode(packet, len(packet), 2)[0])
        if len(sent) == 100:
            raise KeyboardInterrupt
        return ""

    assert play(read_frames(signals), send, FakeClock(), loop=True, speed=1.0) == (99, True, "")
    assert sent == list(range(100))


def test_the_command_sends_datagrams_and_says_what_it_does(signals):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as shirt:
        shirt.bind(("127.0.0.1", 0))
        shirt.settimeout(5)
        to = f"127.0.0.1:{shirt.getsockname()[1]}"
        result = invoke("replay", signals, "--to", to, "--speed", "50")
        seqs = [decode(packet, len(packet), 2)[0] for packet in (shirt.recv(1000) for _ in range(20))]
    assert result.exit_code == 0
    assert seqs == list(range(20))
    assert f"Sending signals.csv to {to}: 2 channels" in result.stdout
    assert "The recording has ended: 20 frames sent." in result.stdout


def test_json_is_one_object_and_nothing_else(signals):
    result = invoke("replay", signals, "--to", "127.0.0.1:9", "--speed", "100", "--json")
    assert json.loads(result.stdout) == {"frames": 20, "to": "127.0.0.1:9", "stopped": False}


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (["nothing.csv"], "there is no such file"),
        (["SIGNALS", "--to", "here"], "write a host and a port"),
        (["SIGNALS", "--to", "127.0.0.1:0"], "write a host and a port"),
        (["SIGNALS", "--to", "127.0.0.1:x"], "write a host and a port"),
        (["SIGNALS", "--to", "no.such.host.invalid:5252"], "there is no host of this name"),
        (["SIGNALS", "--speed", "0"], "between 0.01 and 100"),
        (["SIGNALS", "--speed", "nan"], "between 0.01 and 100"),
    ],
)
def test_bad_input_is_one_sentence(signals, words, sentence):
    result = invoke("replay", *[signals if word == "SIGNALS" else word for word in words])
    assert isinstance(result.exception, InputError)
    assert sentence in str(result.exception)
    assert "\n" not in str(result.exception)


def test_addresses():
    assert parse_address("127.0.0.1:5252") == (socket.AF_INET, ("127.0.0.1", 5252))
    assert parse_address("[::1]:80") == (socket.AF_INET6, ("::1", 80))

"""The analog output: its bytes, one by one, and what it does with the board at the far end."""

import hashlib
import hmac
import json
import struct
from binascii import crc_hqx

import pytest
from hardware.chair.driven_output import DrivenOutput
from hardware.chair.far_ends import Board, MemoryPort
from hypothesis import given
from hypothesis import strategies as st

from app.hardware.chair import analog
from app.hardware.chair.analog import BoardStatus, command_bytes, statuses
from app.hardware.chair.key import Key, write_key
from app.hardware.chair.outputs import OutputRefused
from app.hardware.chair.receiver import ReceiverState

SECRET = bytes(range(32))
KEY = Key(7, SECRET)
TABLE = {"version": 1, "dead_band": 10, "forward": [[100, 1.0]], "back": [[100, 0.5]], "turn": [[100, 2.0]]}

u8, u32 = st.integers(0, 255), st.integers(0, 2**32 - 1)


@pytest.fixture
def key_file(tmp_path):
    file = tmp_path / "7.key"
    write_key(file, KEY)
    return file


@pytest.fixture
def document(tmp_path):
    file = tmp_path / "chair.json"
    file.write_text(json.dumps(TABLE))
    return file


@pytest.fixture
def board():
    return Board(SECRET)


@pytest.fixture
def port(board, monkeypatch):
    made = MemoryPort(board, "/dev/board")
    monkeypatch.setattr("app.hardware.chair.analog.SerialPort", lambda *_: made)
    return made


@pytest.fixture
def driven(port, key_file, document):
    return DrivenOutput(analog.AnalogBoard("/dev/board", key_file, document))


def test_a_command_has_exactly_these_bytes():
    body = b"BMIC" + bytes([1, 1]) + struct.pack("<h", 500) + struct.pack("<h", -250)
    body += (77).to_bytes(4, "little") + (123_456).to_bytes(4, "little") + (9).to_bytes(4, "little")
    tag = hmac.new(SECRET, body, hashlib.sha256).digest()[:16]
    assert command_bytes(KEY, True, 500, -250, 77, BoardStatus(2, 76, 123_456, 9)) == body + tag
    assert len(body + tag) == 38


def status_bytes(state, number, time, boot):
    body = b"BMIB" + bytes([1, state]) + b"".join(value.to_bytes(4, "little") for value in (number, time, boot))
    return body + crc_hqx(body, 0xFFFF).to_bytes(2, "little")


@given(st.lists(st.one_of(st.binary(max_size=30), st.tuples(u8, u32, u32, u32)), max_size=10), st.integers(1, 40))
def test_statuses_are_found_in_any_junk_in_pieces_of_any_size(parts, size):
    told = [part for part in parts if isinstance(part, tuple)]
    content = b"".join(status_bytes(*part) if isinstance(part, tuple) else part.replace(b"B", b"b") for part in parts)
    received, found = bytearray(), []
    for start in range(0, len(content), size):
        received += content[start : start + size]
        found += statuses(received)
        assert len(received) < 20
    assert found == told


def test_a_damaged_status_is_none():
    whole = status_bytes(2, 3, 4, 5)
    for bit in range(8 * len(whole)):
        damaged = bytearray(whole)
        damaged[bit // 8] ^= 1 << bit % 8
        assert statuses(damaged) == []


def test_it_drives_by_the_chair_s_document(driven, board):
    driven.drive(0.5, -1.0)
    assert (board.deflection, board.relay_closed) == ((550, 550), True)
    driven.run(0.3, -0.25, 0.5, 1)
    assert board.deflection == (-550, -325)
    assert driven.output.most == (1.0, 2.0)


def test_while_nothing_is_armed_the_relay_is_open_and_the_board_hears_of_it(driven, board):
    driven.run(0.5)
    assert driven.state is ReceiverState.DISARMED
    assert set(board.commands) == {(0, 0, 0)}
    assert len(board.commands) == pytest.approx(25, abs=3)
    assert (board.state, board.relay_closed) == (1, False)


def test_after_silence_of_the_sender_the_chair_s_inputs_are_at_their_centre(driven, board):
    driven.drive(0.5, 0.0)
    driven.run(0.6)
    assert (board.deflection, board.relay_closed) == ((0, 0), False)


def test_a_board_for_another_key_obeys_nothing_and_that_is_a_fault(driven, board):
    board.secret = bytes(32)
    driven.run(0.5)
    assert board.commands == []
    assert driven.state is ReceiverState.FAULT


def test_it_says_what_it_found(driven, board):
    assert "nothing comes from it, load examples/firmware/chair_output into it" in driven.output.description()
    driven.run(0.2)
    assert "A board on /dev/board: its relay is open; start 1 of the board" in driven.output.description()
    assert "chair.json" in driven.output.description()


def test_without_a_document_it_says_at_most_how_fast(port, key_file):
    output = analog.AnalogBoard("/dev/board", key_file)
    assert output.most == (0.3, 0.5)
    assert "No chair document is given" in output.description()


def test_a_key_file_that_is_none_is_refused(port, tmp_path):
    with pytest.raises(OutputRefused, match="the key file"):
        analog.AnalogBoard("/dev/board", tmp_path / "none")


def test_closing_opens_the_relay_where_anything_was_commanded(driven, board, port):
    driven.output.close()
    assert (board.commands, port.closed) == ([], True)
    port.closed = False
    driven.drive(0.5, 0.0)
    driven.output.close()
    assert (board.commands[-1], board.relay_closed, port.closed) == ((0, 0, 0), False, True)

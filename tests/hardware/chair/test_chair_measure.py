"""The guided drive as a program: its board, its terminal, and what it writes."""

import os
import pty
import select

import pytest
from fake_clock import FakeClock
from hardware.chair.far_ends import Board, MemoryPort

from app.geometry import Twist
from app.hardware.chair import analog, chair_measure
from app.hardware.chair.chair_document import joystick_table
from app.hardware.chair.chair_measure import Terminal, _write, guide, main, moment_of
from app.hardware.chair.inputs import Inputs
from app.hardware.chair.joystick_drive import QUIT, DrivePhase, GuidedDrive
from app.hardware.chair.key import new_key, write_key
from app.hardware.chair.receive import CannotStart

DOCUMENT = {"version": 1, "dead_band": 5, "forward": [[10, 0.2]], "back": [[10, 0.2]], "turn": [[10, 0.4]]}


class ScriptedKeys:
    """A person who drives for three seconds, and then says what was measured."""

    def __init__(self, clock, results):
        self.clock, self.results = clock, list(results)
        self.any_key = False
        self.at = clock.now() + 1.0  # s, of the next word

    def expect(self, *, any_key):
        self.any_key = any_key

    def read(self):
        if self.clock.now() < self.at:
            return None
        self.at = self.clock.now() + 3.0
        if self.any_key:
            return " "
        if self.drive.phase is DrivePhase.ASKS:
            return "\n"
        return self.results.pop(0) if self.results else QUIT


@pytest.fixture
def board_and_output(tmp_path, monkeypatch):
    key, file = new_key(7), tmp_path / "7.key"
    write_key(file, key)
    board = Board(key.secret)
    port = MemoryPort(board)
    monkeypatch.setattr(analog, "SerialPort", lambda *_: port)
    return board, port, analog.AnalogBoard("/dev/far", file)


def guided(output, results, inputs=None, page=None):
    clock, told = FakeClock(100.0), []
    drive = GuidedDrive(Twist(0.5, 0.8))
    keys = ScriptedKeys(clock, results)
    keys.drive = drive
    guide(drive, output, keys, inputs or Inputs(None, None), clock, told.append, page)
    output.close()
    return drive, told


def test_the_board_gets_the_percents_and_the_document_is_made(board_and_output):
    board, _, output = board_and_output
    drive, told = guided(output, ["0", "1 10", "4 8", "2 5", "90 2"])
    assert drive.document is not None, told
    driven = {(forwards, right) for flags, forwards, right in board.commands if flags}
    assert {(50, 0), (100, 0), (200, 0), (-50, 0), (0, 50)} <= driven
    assert max(abs(forwards) + abs(right) for forwards, right in driven) == 200
    assert (board.deflection, board.relay_closed) == ((0, 0), False)


def test_a_pressed_switch_or_a_silent_board_lets_nothing_begin(board_and_output, tmp_path):
    board, port, output = board_and_output
    (tmp_path / "switch").write_text("1")

    class Impatient(Inputs):
        """A switch that is pressed; it is asked only so often."""

        asked = 0

        @property
        def stop_pressed(self):
            self.asked += 1
            if self.asked == 500:
                raise KeyboardInterrupt
            return super().stop_pressed

    with pytest.raises(KeyboardInterrupt):
        guided(output, [], Impatient(tmp_path / "switch", None))
    assert not any(flags for flags, *_ in board.commands)
    port.pulled = True
    with pytest.raises(KeyboardInterrupt):
        guided(output, [], Impatient(None, None))
    assert not any(flags for flags, *_ in board.commands)


# What begins while the chair drives.
FAULTS = {
    "cable pulled": lambda _, port: setattr(port, "pulled", True),
    "port hangs": lambda _, port: setattr(port, "hung", True),
    "far end starts again": lambda board, _: board.reboot(),
    "far end hangs": lambda board, _: setattr(board, "dead", True),
    "error": lambda board, _: setattr(board, "state", 4),
    "commands refused": lambda board, _: setattr(board, "secret", bytes(32)),
}


class KeysOfOneDrive:
    """A person who begins one drive after 1 s; after 2 s something happens, and after 4 s the person quits."""

    def __init__(self, clock, happens):
        self.clock, self.happens = clock, happens
        self.began, self.has_begun = clock.now(), False

    def expect(self, *, any_key):
        self.any_key = any_key

    def read(self):
        since = self.clock.now() - self.began
        if self.happens is not None and since > 2.0:
            self.happens()
            self.happens, self.happened_at = None, self.clock.now()
        if since > 4.0:
            return QUIT
        if since < 1.0 or self.has_begun:
            return None
        self.has_begun = True
        return "\n"


@pytest.mark.parametrize("fault", [*FAULTS, "switch", "page"])
def test_whatever_happens_while_it_drives_the_joystick_is_let_go(board_and_output, tmp_path, fault):
    board, port, output = board_and_output
    switch, clock, told, page = tmp_path / "switch", FakeClock(100.0), [], PageInMemory()
    switch.write_text("0")
    happens = {"switch": lambda: switch.write_text("1"), "page": page.press}
    drive, moved = GuidedDrive(Twist(0.5, 0.8)), []
    keys = KeysOfOneDrive(clock, happens.get(fault) or (lambda: FAULTS[fault](board, port)))
    sleep = clock.sleep_until

    def sleep_and_look(deadline):
        sleep(deadline)
        board.watch(clock.now())
        if board.deflection != (0, 0) or board.relay_closed:
            moved.append(clock.now())

    clock.sleep_until = sleep_and_look
    guide(drive, output, keys, Inputs(switch, None), clock, told.append, page)
    assert moved, "it drove"
    assert moved[-1] - keys.happened_at < 0.2
    assert any(sentence.startswith("ENDED.") for sentence in told), told
    assert page.moment.headline == "OVER"


class PageInMemory:
    """In place of the page."""

    def __init__(self):
        self.moment, self.pressed = None, False

    def press(self):
        self.pressed = True

    def take_stop(self):
        was_pressed, self.pressed = self.pressed, False
        return was_pressed


@pytest.mark.parametrize("phase", DrivePhase)
def test_who_walks_beside_it_reads_what_it_waits_for(phase):
    drive = GuidedDrive(Twist(0.5, 0.8))
    drive.phase = phase
    moment = moment_of(drive)
    assert moment.headline == moment.headline.upper()
    assert "{" not in moment.instruction
    assert "FORWARDS, 5 percent" in moment.instruction or phase in (DrivePhase.COUNTS, DrivePhase.ENDED)


def arrive(near):
    """Wait until what was typed has come through the pseudo-terminal."""
    assert select.select([near], [], [], 30.0)[0]


def test_a_terminal_gives_lines_or_each_key_and_quits_when_it_is_closed():
    far, near = pty.openpty()
    try:
        terminal = Terminal(near)
        assert terminal.read() is None
        os.write(far, b"2.5 6\n")
        arrive(near)
        assert terminal.read() == "2.5 6\n"
        terminal.expect(any_key=True)
        os.write(far, b"x")
        arrive(near)
        assert terminal.read() == "x"
        os.write(far, b"y")
        arrive(near)
        terminal.expect(any_key=False)
        assert terminal.read() is None
    finally:
        os.close(far)
    assert terminal.read() == QUIT
    os.close(near)


def test_what_is_no_terminal_is_refused():
    reading, writing = os.pipe()
    try:
        with pytest.raises(CannotStart, match="terminal"):
            Terminal(reading)
    finally:
        os.close(reading)
        os.close(writing)


def test_a_document_is_written_once_and_read_as_it_is(tmp_path, capsys):
    out = tmp_path / "chair.json"
    assert _write(out, DOCUMENT, "measure") == 0
    assert joystick_table(out).most == Twist(0.2, 0.4)
    assert joystick_table(out).note in capsys.readouterr().out
    assert _write(out, {**DOCUMENT, "dead_band": 7}, "measure") == 2
    assert '"dead_band": 7' in capsys.readouterr().err
    assert '"dead_band": 5' in out.read_text()


@pytest.mark.parametrize(
    ("options", "why"),
    [
        (("--output", "whill", "--out", "new.json"), "whill"),
        (("--output", "sim", "--out", "new.json"), "sim"),
        (("--output", "analog"), "--out"),
        (("--output", "analog", "--out", "there.json"), "already"),
        (("--output", "analog", "--out", "none/new.json"), "no folder"),
        (("--output", "analog", "--out", "new.json", "--name", "x" * 81), "too long"),
        (("--output", "analog", "--out", "new.json", "--v-max", "nan"), "out of range"),
        (("--output", "analog", "--out", "x" * 300), "cannot be made"),
        (("--output", "analog", "--out", "new.json", "--page", "here"), "no address"),
        (("--output", "analog", "--out", "new.json"), "terminal"),
    ],
)
def test_bad_input_is_one_sentence_and_writes_nothing(tmp_path, monkeypatch, capsys, options, why):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "there.json").touch()
    reading, writing = os.pipe()
    monkeypatch.setattr(chair_measure, "STDIN", reading)
    try:
        code = main(options)
    except SystemExit as end:
        code = end.code
    finally:
        os.close(reading)
        os.close(writing)
    assert code == 2
    said = capsys.readouterr().err
    assert why in said
    assert said.count("\n") == 1
    assert not (tmp_path / "new.json").exists()

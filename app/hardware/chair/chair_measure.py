"""Measures a chair's joystick by a guided drive: `bodydrive chair measure --output NAME --out FILE`, on the chair.

Standard library only, so that it runs on a chair's small board. `app.hardware.chair.joystick_drive` decides what is
driven.
"""

import argparse
import json
import os
import select
import signal
import sys
import termios
import tty
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Protocol, cast

from app.clock import Clock, MonotonicClock
from app.geometry import Twist
from app.hardware.chair.chair_document import MOST_LETTERS, table_of
from app.hardware.chair.inputs import Inputs
from app.hardware.chair.joystick_drive import QUIT, DrivePhase, GuidedDrive
from app.hardware.chair.outputs import JOYSTICK_OUTPUTS, JoystickOutput, OutputRefused, open_output
from app.hardware.chair.readings import NO_READINGS
from app.hardware.chair.reasons import DESCRIPTIONS, Reason
from app.hardware.chair.receive import STEP, CannotStart, ProgramParser, complain, host_and_port, up_to, why_of
from app.hardware.chair.walker_page import WalkerMoment, WalkerPage
from app.speed_ceiling import HIGHEST_SPEED, HIGHEST_TURN_RATE

DESCRIPTION = "Drives the chair a few metres at a time, slowest first, and writes down which speed a deflection gives."
STDIN = 0
MOST_BYTES = 1024  # of one reading of the keys
STANDARD_MOST = Twist(0.5, 0.8)  # m/s, rad/s: an indoor walking pace
BEFORE = (
    "NOBODY SITS IN THE CHAIR; a weight is in its seat. The floor is free for six metres. Somebody walks beside it, "
    "with a hand at its switch.",
    "Put two marks on the floor, the first one metre after the start. Press the stop watch when the same point of the "
    "chair passes the first mark, and the second. For a turn, choose two headings, the first a quarter turn after the "
    "start.",
    "While it moves, ANY KEY ENDS IT.",
)

# For who walks beside the chair, by what the guided drive waits for: in big words, and what to do.
BESIDE = {
    DrivePhase.ASKS: ("IT STANDS", "Next: {drive}. Is the floor free? Then say so to who has the keys."),
    DrivePhase.STANDS: ("IT MOVES NOW", "{drive}. A hand at its switch, and eyes on the way."),
    DrivePhase.DRIVES: ("IT MOVES", "{drive}. Walk beside it. Press the stop watch at both marks."),
    DrivePhase.COUNTS: ("IT STOPS", "Say metres and seconds between the marks; for a turn degrees and seconds."),
    DrivePhase.ENDED: ("OVER", "Nothing drives any more."),
}


class Keys(Protocol):
    """What a person types."""

    def expect(self, *, any_key: bool) -> None:
        """Return each key at once from now on, or whole lines."""
        ...

    def read(self) -> str | None:
        """Return what was typed since, None when nothing was; never waits."""
        ...


class Terminal:
    """The terminal that this program was started in."""

    def __init__(self, handle: int) -> None:
        """Raise CannotStart when `handle` is no terminal: then no key could end a drive."""
        try:
            self._as_found = termios.tcgetattr(handle)
        except termios.error as error:
            raise CannotStart("the keys must be those of a terminal, start it in one: any key ends a drive") from error
        self._handle = handle
        self._any_key = False

    def expect(self, *, any_key: bool) -> None:
        """Return each key at once from now on, or whole lines; keys that ended a drive are forgotten."""
        if any_key is self._any_key:
            return
        self._any_key = any_key
        with suppress(termios.error):  # the terminal was closed, which `read` says
            if any_key:
                tty.setcbreak(self._handle, termios.TCSANOW)
            else:
                termios.tcsetattr(self._handle, termios.TCSAFLUSH, self._as_found)

    def read(self) -> str | None:
        """Return what was typed since, None when nothing was; the word to quit when the terminal is closed."""
        if not select.select([self._handle], [], [], 0)[0]:
            return None
        try:
            content = os.read(self._handle, MOST_BYTES)
        except OSError:
            return QUIT
        return content.decode(errors="replace") if content else QUIT


def moment_of(drive: GuidedDrive) -> WalkerMoment:
    """Return what who walks beside the chair reads."""
    headline, instruction = BESIDE[drive.phase]
    return WalkerMoment(headline, instruction.format(drive=drive.next_drive))


def guide(
    drive: GuidedDrive,
    output: JoystickOutput,
    keys: Keys,
    inputs: Inputs,
    clock: Clock,
    tell: Callable[[str], None],
    page: WalkerPage | None = None,
) -> None:
    """Step the guided drive every 10 ms until it has ended; the chair is let go then."""
    refusal = ""
    while True:
        t = clock.now()
        if page is not None and page.take_stop():
            drive.stop()
        readings = NO_READINGS
        obstacle = refusal
        try:
            readings = output.poll(t)
        except OSError as error:
            obstacle = f"Output: {why_of(error)}."
        reason = Reason.STOP_INPUT if inputs.stop_pressed else readings.obstacle
        deflection = drive.step(t, readings, DESCRIPTIONS[reason] if reason else obstacle)
        try:
            output.deflect(t, *deflection)
            refusal = ""
        except OSError as error:
            refusal = f"Output: {why_of(error)}."
        if page is not None:
            page.moment = moment_of(drive)
        for sentence in drive.told:  # after the output, because a terminal may hold a line back
            tell(sentence)
        drive.told.clear()
        if drive.phase is DrivePhase.ENDED:
            return
        keys.expect(any_key=drive.is_moving)
        text = keys.read()
        if text is not None:
            drive.hear(text)
        clock.sleep_until(t + STEP)


def main(arguments: Sequence[str] | None = None, program: str = "python -m app.hardware.chair.chair_measure") -> int:
    """Measure until all is measured or the person ends it; return the exit code."""
    given = _parser(program).parse_args(arguments)
    try:
        _check_out(given.out)
        terminal = Terminal(STDIN)
        output = cast(JoystickOutput, open_output(given.output, {"device": given.device, "key_file": given.key_file}))
        page = _page_at(given.page, output)
    except (OutputRefused, CannotStart) as error:
        complain(f"{program}: {error}")
        return 2
    drive = GuidedDrive(Twist(given.v_max, given.omega_max))
    for which in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(which, lambda *_: drive.end())
    for sentence in BEFORE:
        _tell(sentence)
    if page is not None:
        _tell(f"For who walks beside the chair, big words and Stop: {page.address}")
    try:
        guide(drive, output, terminal, Inputs(given.stop_input, None), MonotonicClock(), _tell, page)
    finally:
        with suppress(OSError):  # the output may be broken
            output.close()
        terminal.expect(any_key=False)
        if page is not None:
            page.close()
    document = drive.document
    if document is None:
        _tell("Not everything was measured, so nothing was written.")
        return 1
    if given.name:
        document["name"] = given.name
    return _write(given.out, document, program)


def _check_out(out: Path) -> None:
    """Raise CannotStart when a new file `out` cannot be made."""
    try:
        if out.exists():
            raise CannotStart(f"there is a file {out} already: give --out another name")
        if not out.parent.is_dir():
            raise CannotStart(f"there is no folder {out.parent}: make it, or correct --out")
    except OSError as error:
        raise CannotStart(f"--out {out} cannot be made ({why_of(error)}): give another name") from error


def _page_at(place: tuple[str, int] | None, output: JoystickOutput) -> WalkerPage | None:
    """Return the page where it is asked for; release the output, which has driven nothing yet, when there is none."""
    if place is None:
        return None
    try:
        return WalkerPage(*place)
    except (OSError, UnicodeError) as error:
        with suppress(OSError):
            output.close()
        why = getattr(error, "strerror", None) or "no such host name"
        raise CannotStart(f"no page on {place[0]}:{place[1]} ({why}), choose another --page") from error


def _write(out: Path, document: dict[str, object], program: str) -> int:
    """Write a new document that its reader accepts; say its content where that fails, so that no drive was in vain."""
    text = json.dumps(document) + "\n"
    try:
        note = table_of(text, out).note
        with out.open("x", encoding="utf-8", newline="") as opened:
            opened.write(text)
            opened.flush()
            os.fsync(opened.fileno())
    except (OSError, OutputRefused) as error:
        why = why_of(error) if isinstance(error, OSError) else str(error)
        complain(f"{program}: {out} cannot be written ({why}), its content would be: {text}")
        return 2
    _tell(f"{note} Give it as --chair-document to the receiver.")
    return 0


def _tell(sentence: str) -> None:
    with suppress(OSError):  # nobody reads it
        sys.stdout.write(f"{sentence}\n")
        sys.stdout.flush()


def _parser(program: str) -> ProgramParser:
    parser = ProgramParser(prog=program, description=DESCRIPTION, allow_abbrev=False)
    add = parser.add_argument
    add("--output", choices=JOYSTICK_OUTPUTS, required=True, help="what drives the chair: one that sets a joystick")
    add("--out", type=Path, required=True, metavar="FILE", help="the new chair document")
    add("--name", type=_name, default="", metavar="TEXT", help="what people call the chair")
    add("--device", metavar="FILE", help="analog: the serial line, such as one in /dev/serial/by-id")
    add("--key-file", type=Path, metavar="FILE", help="analog: what pairing made")
    add("--stop-input", type=Path, metavar="FILE", help="begins with 0: not pressed; anything else, or none: pressed")
    add("--page", type=host_and_port, metavar="HOST:PORT", help="a page with big words and Stop, in plain http")
    add(
        "--v-max",
        type=up_to(HIGHEST_SPEED),
        default=STANDARD_MOST.v,
        metavar="M_PER_S",
        help=f"no drive that is expected to be faster (default {STANDARD_MOST.v:g})",
    )
    add(
        "--omega-max",
        type=up_to(HIGHEST_TURN_RATE),
        default=STANDARD_MOST.omega,
        metavar="RAD_PER_S",
        help=f"no turn that is expected to be faster (default {STANDARD_MOST.omega:g})",
    )
    return parser


def _name(text: str) -> str:
    if len(text) > MOST_LETTERS:
        raise argparse.ArgumentTypeError(f"the name is too long, give one of at most {MOST_LETTERS} letters")
    return text


if __name__ == "__main__":
    sys.exit(main())

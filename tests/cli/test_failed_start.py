"""A clinic that cannot start says why, in one sentence; the help of every command is in plain words."""

import subprocess
import sys

import pytest

from app.cli.server import why_not_started
from app.process.command_channel import LinkLost
from app.refusals import Refusal
from folders import ROOT

# The real program, whose control process cannot be started.
PROGRAM = """
from app.process.supervisor import ControlProcess
async def after(_): raise {error}
ControlProcess.after = after
from app.cli.main import main
main()
"""


def started(error: str, folder: str) -> tuple[int, str]:
    """Return exit code and stderr of a clinic whose control process ends with an error."""
    words = [sys.executable, "-c", PROGRAM.format(error=error), "serve", "--port", "0", "--state", folder]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False, timeout=120)
    return done.returncode, done.stderr


def test_the_cause_of_a_failed_start_is_in_the_sentence(tmp_path) -> None:
    code, words = started("PermissionError(13, 'no memory to share')", str(tmp_path / "clinic"))
    assert code == 2
    (line,) = words.splitlines()
    assert line.startswith("bodydrive: The program did not start, because of PermissionError: ")
    assert "no memory to share" in line
    assert "messages above" not in line  # there are none


@pytest.mark.parametrize("lost", [None, LinkLost("The control process did not start.")])
def test_a_control_process_that_wrote_its_own_message_is_named(lost) -> None:
    assert "look at the messages above" in str(why_not_started(lost))


def test_a_refusal_is_a_sentence_already() -> None:
    assert why_not_started(Refusal("The disk is full: make room.")) == "The disk is full: make room."

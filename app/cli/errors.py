"""The error of bad input on the command line: one sentence on stderr, exit code 2."""

import sys
from typing import NoReturn


class InputError(Exception):
    """Bad input, as one sentence that names the fault, the place and the remedy."""


def refuse(sentence: str) -> NoReturn:
    """End with `sentence` on stderr and exit code 2."""
    line = "".join(letter if letter.isprintable() else " " for letter in sentence)  # file names may not be printable
    sys.stderr.write(f"bodydrive: {line}\n")
    sys.exit(2)

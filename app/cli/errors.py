"""The error of bad input on the command line: one sentence on stderr, exit code 2."""


class InputError(Exception):
    """Bad input, as one sentence that names the fault, the place and the remedy."""

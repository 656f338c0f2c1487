"""How the command line refuses: one sentence on stderr, exit code 2."""


class InputError(Exception):
    """Bad input, as one sentence that says what, where and what to do."""

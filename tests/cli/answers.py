"""Runs commands, and reads what they say."""

from typer.testing import CliRunner

from app.cli.main import build


def invoke(command, *words):
    """Return the result of a command line, with the exception that ended it."""
    return CliRunner().invoke(build([command]), [command, *map(str, words)])


def output_of(said):
    """Return what a command wrote to stdout, which ended well and complained of nothing."""
    code, out, err = said
    assert (code, err) == (0, "")
    return out


def assert_refused(said, *words):
    """Assert that a command ended with code 2 and one sentence on stderr, which has these words."""
    code, out, err = said
    assert (code, out) == (2, ""), (words, err)
    assert err.count("\n") == 1, err
    for word in words:
        assert word in err

"""The help of every command is in plain words: it names options, and no symbol of a publication."""

import pytest
from cli.symbols import symbols_in
from typer.testing import CliRunner

from app.cli.main import COMMANDS, build


@pytest.mark.parametrize("command", COMMANDS)
def test_the_help_has_no_symbols(command):
    shown = CliRunner().invoke(build(list(COMMANDS)), [command, "--help"])
    assert shown.exit_code == 0, shown.output
    assert symbols_in(shown.output) == []

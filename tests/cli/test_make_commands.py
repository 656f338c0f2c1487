"""Every command of the Makefile can be started: what it runs, and all that this imports, can be imported."""

import os
import re
import subprocess
import sys

import pytest

from folders import ROOT

MAKEFILE = (ROOT / "Makefile").read_text()
OWN = sorted({name for name in re.findall(r"python -m (\S+)", MAKEFILE) if name not in {"pip", "pytest"}})
# A package is run by its `__main__`; importing that runs nothing.
IMPORT = """
import importlib, importlib.util, sys
name = sys.argv[1]
is_package = importlib.util.find_spec(name).submodule_search_locations is not None
importlib.import_module(f"{name}.__main__" if is_package else name)
"""


@pytest.mark.parametrize("name", OWN)
def test_a_command_can_be_started(name):
    environment = {**os.environ, "PYTHONPATH": f"{ROOT / 'tests'}{os.pathsep}{ROOT}"}
    found = subprocess.run(
        [sys.executable, "-c", IMPORT, name], cwd=ROOT, env=environment, capture_output=True, text=True, check=False
    )
    assert found.returncode == 0, found.stderr


def test_the_makefile_has_the_commands():
    assert {"pictures", "soak.people", "bench.prior"} <= set(OWN)

"""Every command of the Makefile can be started: what it runs, and all that this imports, can be imported."""

import json
import os
import re
import subprocess
import sys

import pytest

from folders import ROOT

MAKEFILE = (ROOT / "Makefile").read_text()
OWN = sorted({name for name in re.findall(r"python -m (\S+)", MAKEFILE) if name not in {"pip", "pytest"}})
# To load these anew for each command would take seconds. Of this project it is the web application alone: each command
# has to import its own.
LOADED_ONCE = (
    *("fastapi", "httpx", "hypothesis", "matplotlib.pyplot", "numpy", "playwright.sync_api", "psutil"),
    *("pyarrow.parquet", "pydantic", "pytest", "scipy.signal", "sqlalchemy.orm", "starlette.testclient", "typer"),
    *("uvicorn", "viser", "websockets.sync.client", "app.api.app"),
)
# A package is run by its `__main__`; importing that runs nothing.
IMPORT = """
import importlib, importlib.util, json, os, sys, traceback
for name in json.loads(sys.argv[1]):
    importlib.import_module(name)
def start(name):
    is_package = importlib.util.find_spec(name).submodule_search_locations is not None
    importlib.import_module(f"{name}.__main__" if is_package else name)
def problem_of(name):
    ours, its = os.pipe()
    if os.fork() == 0:
        try:
            start(name)
        except BaseException:
            os.write(its, traceback.format_exc().encode()[-60_000:])
        finally:
            os._exit(0)
    os.close(its)
    with os.fdopen(ours) as opened:
        problem = opened.read()
    _, status = os.wait()
    return problem or (f"ended with {status}" if status else "")
print(json.dumps({name: problem_of(name) for name in json.loads(sys.argv[2])}))
"""


@pytest.fixture(scope="module")
def problems():
    """Return what is wrong with each command, each in a process of its own."""
    environment = {**os.environ, "PYTHONPATH": f"{ROOT / 'tests'}{os.pathsep}{ROOT}"}
    words = [sys.executable, "-W", "ignore", "-c", IMPORT, json.dumps(LOADED_ONCE), json.dumps(OWN)]
    found = subprocess.run(words, cwd=ROOT, env=environment, capture_output=True, text=True, check=False)
    assert found.returncode == 0, found.stderr
    return json.loads(found.stdout.splitlines()[-1])


@pytest.mark.parametrize("name", OWN)
def test_a_command_can_be_started(problems, name):
    assert problems[name] == ""


def test_the_makefile_has_the_commands():
    assert {"pictures", "soak.people", "bench.prior"} <= set(OWN)

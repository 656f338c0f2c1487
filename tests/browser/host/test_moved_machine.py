"""A machine that gets another address while it serves tablets, in a network of its own; with a real browser."""

import json
import os
import subprocess
import sys
from pathlib import Path
from urllib.parse import unquote

import pytest
from browser.host.moving_machine import ADDRESSES

from app.api.qr import qr_picture
from app.cli.host.lan import MOVED, SCAN
from app.cli.qr import terminal_code
from folders import ROOT
from needed import lacks, need

pytestmark = [pytest.mark.browser]

OWN_NETWORK = ("unshare", "--map-root-user", "--net")
SCRIPT = Path(__file__).with_name("moving_machine.py")


@pytest.fixture
def own_network() -> tuple[str, ...]:
    """The words that start a program in a network of its own."""
    need("chromium", "chromium")
    if subprocess.run([*OWN_NETWORK, "true"], capture_output=True, check=False).returncode:
        lacks("no program may have a network of its own here (unshare --map-root-user --net)")
    return OWN_NETWORK


def test_code_settings_and_certificate_follow_the_address(own_network: tuple[str, ...], tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    words = [*own_network, sys.executable, str(SCRIPT), str(tmp_path / "clinic")]
    done = subprocess.run(words, capture_output=True, text=True, env=environment, timeout=170, check=False)
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    for address, lead, printed, shown in zip(ADDRESSES, (SCAN, MOVED), found["printed"], found["shown"], strict=True):
        link = f"http://{address}/"
        assert printed.endswith(f"{lead}\n{terminal_code(link).rstrip()}\n{link}\n")
        assert shown["link"] == f"https://{address}:8443/"
        assert unquote(shown["code"].partition(",")[2]) == qr_picture(link)
        assert shown["under it"] == 1
        assert shown["status"] == 200

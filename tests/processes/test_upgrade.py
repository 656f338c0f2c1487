"""Upgrade and roll back, with the installed wheel of this tree, and with one of a program with a further migration."""

import os
import re
import shutil
import signal
import sqlite3
import subprocess
import sys
from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
from typing import Any

import pytest
from processes.served_demo import COMMAND, OWNER, SessionClient, printed_link
from store.later_schema import LATER, add_later_migration

from app.store.schema import NEWEST
from folders import ROOT

PAGE = ROOT / "docs" / "administrators.md"
STATE_OF_PAGE = "/var/lib/bodydrive"


def run(*words: str | Path, **more: Any) -> str:
    ended = subprocess.run([*map(str, words)], capture_output=True, text=True, check=False, **more)
    assert ended.returncode == 0, ended.stderr
    return ended.stdout


class Installed:
    """A wheel of bodydrive that is installed into `packages`."""

    def __init__(self, packages: Path) -> None:
        self.packages, self._folder = packages, packages.parent
        self._environment = {**os.environ, "PYTHONPATH": str(packages)}
        place = self.python("import app; print(app.__file__)").strip()
        assert Path(place).is_relative_to(packages), place

    def python(self, code: str, *words: str | Path) -> str:
        """Run Python code with this wheel, and return what it prints."""
        return run(sys.executable, "-c", code, *words, cwd=self._folder, env=self._environment)

    def bodydrive(self, *words: str | Path) -> "subprocess.Popen[str]":
        return subprocess.Popen(
            (*COMMAND, *map(str, words)),
            text=True,
            cwd=self._folder,
            env=self._environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )

    @contextmanager
    def serving(self, state: Path) -> Iterator[SessionClient]:
        """Serve a clinic, and yield a browser in which its owner is signed in; the first start makes the owner."""
        process = self.bodydrive("serve", "--port", "0", "--state", state)
        try:
            base, _, code = printed_link(process).partition("/#setup=")
            with SessionClient(base.rstrip("/")) as client:
                way, body = ("setup", {"code": code, **OWNER}) if code else ("sign-in", OWNER)
                assert client.post(f"/auth/{way}", json=body).json()["role"] == "owner"
                yield client
            process.send_signal(signal.SIGTERM)
            assert process.wait(30) == 0
        finally:
            process.kill()
            process.communicate()


@pytest.fixture
def old(tmp_path: Path) -> Installed:
    """Build the wheel of this tree, plain Python, and install it."""
    folder = tmp_path / "old"
    folder.mkdir()
    build = (sys.executable, "-m", "hatchling", "build", "--target", "wheel", "--directory", folder / "wheel")
    run(*build, cwd=ROOT, env={**os.environ, "BODYDRIVE_COMPILE": "no"})
    (wheel,) = (folder / "wheel").glob("bodydrive-*-py3-none-any.whl")
    pip = (sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check")
    run(*pip, "--no-deps", "--no-index", "--no-compile", "--target", folder / "packages", wheel)
    return Installed(folder / "packages")


def later_program(old: Installed, folder: Path) -> Installed:
    """Install into `folder` what a later wheel would hold: the same, and a further migration.

    What Python has compiled of it comes along.
    """
    packages = Path(shutil.copytree(old.packages, folder / "packages"))
    add_later_migration(packages / "app" / "store" / "migrations")
    schema = packages / "app" / "store" / "schema.py"
    code, newest = schema.read_text(encoding="utf-8"), f'NEWEST = "{NEWEST}"'
    assert newest in code
    schema.write_text(code.replace(newest, f'NEWEST = "{LATER}"'), encoding="utf-8")
    return Installed(packages)


def add_patient(client: SessionClient, code: str) -> None:
    assert client.post("/patients", json={"code": code, "pseudonym": "Heron"}).status_code == 201


def patients(client: SessionClient) -> set[str]:
    return {patient["code"] for patient in client.get("/patients").json()}


def schema_of(file: Path) -> str:
    with closing(sqlite3.connect(file)) as connection:
        return str(connection.execute("SELECT version_num FROM alembic_version").fetchone()[0])


def roll_back_as_the_page_says(state: Path, copy: Path) -> None:
    """Run the commands of the section "Roll back" on this clinic."""
    section = PAGE.read_text(encoding="utf-8").partition("### Roll back")[2].partition("\n#")[0]
    (commands,) = re.findall(r"```sh\n(.*?)```", section, flags=re.DOTALL)
    (name,) = re.findall(r"\S+\.backup(?= )", commands)
    assert STATE_OF_PAGE in commands
    run("sh", "-e", "-c", commands.replace(STATE_OF_PAGE, str(state)).replace(name, copy.name))


def test_a_clinic_is_upgraded_and_rolled_back(old: Installed, tmp_path: Path) -> None:
    state = tmp_path / "clinic"
    database = state / "bodydrive.sqlite"
    with old.serving(state) as client:
        add_patient(client, "before")
    assert schema_of(database) == NEWEST

    new = later_program(old, tmp_path / "new")
    with new.serving(state) as client:
        assert patients(client) == {"before"}
        add_patient(client, "after")
    assert schema_of(database) == LATER
    (copy,) = state.glob("*.backup")
    assert (schema_of(copy), copy.stat().st_mode & 0o077) == (NEWEST, 0)

    refused = old.bodydrive("serve", "--port", "0", "--state", state)
    out, errors = refused.communicate(timeout=30)
    assert (refused.returncode, out, errors.count("\n")) == (2, "", 1)
    assert "newer bodydrive" in errors

    kept = shutil.copytree(state, tmp_path / "as it was")
    roll_back_as_the_page_says(state, copy)
    with old.serving(state) as client:
        assert patients(client) == {"before"}
        assert client.get("/log/check").json()["whole"]
    verified = old.bodydrive("log", "verify", "--state", state)
    assert "The log is whole" in verified.communicate(timeout=30)[0]
    # nothing of the newer database was lost: it lies where the page puts it
    newer = tmp_path / "bodydrive-newer"
    assert newer.stat().st_mode & 0o077 == 0
    for file in newer.iterdir():
        assert file.read_bytes() == (kept / file.name).read_bytes()
    assert {"bodydrive.sqlite", "bodydrive.sqlite.log-head"} <= {file.name for file in newer.iterdir()}

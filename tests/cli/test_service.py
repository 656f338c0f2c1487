"""`bodydrive service install`: the unit, and what is done with it."""

import configparser
import os
import shlex
import sys
from pathlib import Path

import pytest
from cli.answers import assert_refused, output_of
from hypothesis import given
from hypothesis import strategies as st

from app.host.systemd_unit import unit


def parsed(text):
    reader = configparser.RawConfigParser(strict=False)
    reader.optionxform = str
    reader.read_string(text)
    return reader


@pytest.fixture
def systemctl(tmp_path, monkeypatch):
    """A systemctl that writes down how it is called, and fails when it is told to."""
    folder, calls = tmp_path / "bin", tmp_path / "calls"
    folder.mkdir()
    calls.touch()
    script = folder / "systemctl"
    script.write_text(
        f'#!/bin/sh\necho "$@" >> {calls}\n[ ! -e {tmp_path}/fail ] || {{ echo "no bus" >&2; exit 1; }}\n'
    )
    script.chmod(0o755)
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    return calls


def test_print_changes_nothing(bodydrive, systemctl, tmp_path):
    out = output_of(bodydrive("service", "install", "--print", "--state", tmp_path / "my clinic"))
    service = parsed(out)["Service"]
    assert service["LimitNOFILE"] == "16384"
    assert shlex.split(service["ExecStart"]) == [
        *(sys.executable, "-m", "app.cli.main", "serve", "--lan", "--state"),
        str(tmp_path / "my clinic"),
    ]
    assert "User" not in service
    assert parsed(out)["Install"]["WantedBy"] == "default.target"
    assert systemctl.read_text() == ""
    assert not (tmp_path / "config").exists()


def test_a_unit_of_ones_own_is_installed_and_started(bodydrive, systemctl, tmp_path):
    printed = bodydrive("service", "install", "--print", "--state", tmp_path)[1]
    code, out, _ = bodydrive("service", "install", "--state", tmp_path)
    file = tmp_path / "config" / "systemd" / "user" / "bodydrive.service"
    assert code == 0
    assert str(file) in out
    assert "enable-linger" in out
    assert file.read_text() == printed
    assert systemctl.read_text().splitlines() == ["--user daemon-reload", "--user enable --now bodydrive.service"]


def test_a_refusal_of_systemd_is_one_sentence(bodydrive, systemctl, tmp_path):
    (tmp_path / "fail").touch()
    assert_refused(bodydrive("service", "install", "--state", tmp_path), "did not take it (no bus)")


def test_a_machine_without_systemd_is_told(bodydrive, monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    assert_refused(bodydrive("service", "install", "--state", tmp_path), "has no systemd")


def test_a_unit_of_the_system_runs_as_an_account_with_real_time_rights(bodydrive, tmp_path):
    words = ("service", "install", "--print", "--system")
    out = bodydrive(*words, "--account", "clinic", "--state", tmp_path)[1]
    service = parsed(out)["Service"]
    assert (service["User"], service["LimitRTPRIO"], service["LimitMEMLOCK"]) == ("clinic", "10", "infinity")
    assert parsed(out)["Install"]["WantedBy"] == "multi-user.target"
    refused = [
        ((*words, "--account", "root", "--state", tmp_path), "must not run as root"),
        ((*words, "--account", "clinic"), "Name the folder"),
        (("service", "install", "--account", "clinic"), "leave --account out"),
        ((*words, "--account", "a b", "--state", tmp_path), "cannot carry"),
        ((*words, "--account", "clinic", "--state", "a\nExecStart=b"), "cannot carry"),
    ]
    for given_words, sentence in refused:
        assert_refused(bodydrive(*given_words), sentence)


@given(st.text(st.characters(exclude_categories=["C", "Z"]), min_size=1))
def test_any_folder_stays_one_word_of_the_command(folder):
    line = next(
        line for line in unit(["x", f"/{folder}"], Path("/"), None).splitlines() if line.startswith("ExecStart=")
    )
    words = line.removeprefix("ExecStart=").replace("%%", "%").replace("$$", "$")
    assert words.count("%") + words.count("$") == folder.count("%") + folder.count("$")
    assert shlex.split(words) == ["x", f"/{folder}"]

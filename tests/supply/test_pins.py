"""requirements/: what pyproject.toml asks for has one version with digests, and nothing else is there."""

import re
import tomllib
from importlib.metadata import PackageNotFoundError, requires

import pytest
from packaging.markers import default_environment
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from folders import ROOT
from supply.pins import FOLDER, LINUX, LISTS, MACHINES, PYTHONS, Machine, lists_before, pin, required

PIN = re.compile(r"^([a-z0-9-]+)==(\S+)(?: ; (.+))?$")
DIGEST = re.compile(r"^--hash=sha256:[0-9a-f]{64}$")
NOT_INSTALLED_FOR_TESTS = {"ros2", "safety", "pins"}  # what these distributions need cannot be looked up


def pins_of(name: str) -> dict[str, Requirement]:
    """Return the pins of one file; fails on a line without a digest."""
    found = {}
    for line in (FOLDER / f"{name}.txt").read_text().replace(" \\\n    ", "\n").splitlines():
        if match := PIN.fullmatch(line):
            found[match[1]] = Requirement(line)
        else:
            assert line.startswith(("# ", "-r ", "--only-binary :all:")) or DIGEST.fullmatch(line), line
    return found


PINS = {name: pins_of(name) for name in LISTS}


def reached_from(name: str) -> dict[str, Requirement]:
    """Return the pins that an installation of one file takes."""
    return {pinned: pin for each in lists_before(name) for pinned, pin in PINS[each].items()}


def test_the_folder_holds_these_lists_and_no_address() -> None:
    assert {file.name for file in FOLDER.iterdir()} == {f"{name}.txt" for name in LISTS}
    for name, (_, before) in LISTS.items():
        text = (FOLDER / f"{name}.txt").read_text()
        assert "://" not in text
        assert text.count("\n-r ") == (before is not None)
        assert before is None or f"\n-r {before}.txt\n" in text
    assert "\n--only-binary :all:\n" in (FOLDER / "run.txt").read_text()


@pytest.mark.parametrize("name", LISTS)
def test_a_pin_has_a_digest(name: str) -> None:
    lines = (FOLDER / f"{name}.txt").read_text().splitlines()
    pins = [place for place, line in enumerate(lines) if "==" in line and not line.startswith("#")]
    assert pins
    for place in pins:
        assert lines[place].endswith(" \\")
        assert DIGEST.fullmatch(lines[place + 1].strip().removesuffix(" \\"))


@pytest.mark.parametrize("name", LISTS)
def test_what_pyproject_asks_for_is_pinned(name: str) -> None:
    pins = reached_from(name)
    for line in required(name):
        asked = Requirement(line)
        pinned = pins[canonicalize_name(asked.name)]
        (version,) = [specifier.version for specifier in pinned.specifier]
        assert asked.specifier.contains(version), line


@pytest.mark.parametrize("name", sorted(set(LISTS) - NOT_INSTALLED_FOR_TESTS))
def test_what_is_pinned_is_needed(name: str) -> None:
    waiting = [(Requirement(line), "") for each in lists_before(name) for line in required(each)]
    needed: set[tuple[str, str]] = set()
    while waiting:
        requirement, asked_by = waiting.pop()
        if requirement.marker and not requirement.marker.evaluate({"extra": asked_by}):
            continue
        for extra in ("", *requirement.extras):
            key = (canonicalize_name(requirement.name), extra)
            if key not in needed:
                needed.add(key)
                waiting += [(Requirement(line), extra) for line in requires(requirement.name) or []]
    here = {pinned for pinned, pin in PINS[name].items() if pin.marker is None or pin.marker.evaluate()}
    assert here - {distribution for distribution, _ in needed} == set()
    assert {distribution for distribution, _ in needed} - set(reached_from(name)) == set()


@pytest.mark.parametrize("name", sorted(NOT_INSTALLED_FOR_TESTS))
def test_the_other_lists_have_what_their_distributions_need(name: str) -> None:
    for line in required(name):
        try:
            needed = [Requirement(each) for each in requires(Requirement(line).name) or []]
        except PackageNotFoundError:
            continue
        here = {key: str(value) for key, value in default_environment().items()} | {"extra": ""}
        names = {canonicalize_name(each.name) for each in needed if not each.marker or each.marker.evaluate(here)}
        assert names <= set(reached_from(name))


def wheel(name: str, digest: str) -> dict[str, object]:
    return {"url": f"somewhere/{name}", "hashes": {"sha256": digest}}


def test_a_pin_has_the_wheels_of_the_machines_it_is_for_and_no_others() -> None:
    package = {
        "name": "one",
        "version": "1",
        "wheels": [
            wheel("one-1-cp311-cp311-manylinux_2_17_x86_64.manylinux2014_x86_64.whl", "a"),
            wheel("one-1-cp311-abi3-manylinux_2_28_aarch64.whl", "b"),
            wheel("one-1-cp311-abi3-musllinux_1_2_x86_64.whl", "c"),
            wheel("one-1-cp311-abi3-win_amd64.whl", "d"),
            wheel("one-1-cp310-cp310-manylinux_2_17_x86_64.whl", "e"),
            wheel("one-1-cp312-abi3-manylinux_2_39_x86_64.whl", "f"),  # newer than Debian 12
            wheel("one-1-cp314-cp314t-manylinux_2_17_x86_64.whl", "g"),
        ],
    }
    text, without = pin(package, LINUX)
    assert text == "one==1 \\\n    --hash=sha256:a \\\n    --hash=sha256:b"
    assert [str(machine) for machine in without] == [f"Linux x86_64, Python 3.{minor}" for minor in (12, 13, 14)]


def test_a_pin_that_not_every_machine_needs_says_which() -> None:
    package = {
        "name": "two",
        "version": "2",
        "marker": "platform_machine != 'aarch64'",
        "wheels": [wheel("two-2-py3-none-any.whl", "a")],
    }
    assert pin(package, LINUX) == ("two==2 ; platform_machine != 'aarch64' \\\n    --hash=sha256:a", [])
    everywhere = {**package, "marker": "sys_platform != 'win32'"}
    assert pin(everywhere, MACHINES) == ("two==2 \\\n    --hash=sha256:a", [])


def test_fonttools_is_the_wheel_of_plain_python() -> None:
    wheels = [
        wheel("fonttools-1-cp311-cp311-manylinux_2_17_x86_64.whl", "a"),
        wheel("fonttools-1-py3-none-any.whl", "b"),
    ]
    text, without = pin({"name": "fonttools", "version": "1", "wheels": wheels}, LINUX)
    assert (text, without) == ("fonttools==1 \\\n    --hash=sha256:b", [])


def test_linux_on_both_processors_lacks_no_wheel_of_what_runs_and_tests_the_program() -> None:
    assert {(machine.processor, machine.python) for machine in MACHINES if machine.system == "Linux"} >= {
        (processor, (3, minor)) for processor in ("x86_64", "aarch64") for minor in (11, 12, 13)
    }
    lacking = {name for name in LISTS if " has no wheel for " in (FOLDER / f"{name}.txt").read_text()}
    assert lacking <= {"ros2"}
    assert Machine("Linux", "x86_64", (3, 11)) in MACHINES


def test_the_oldest_python_is_that_of_an_installation() -> None:
    document = tomllib.loads((ROOT / "pyproject.toml").read_text())
    oldest = "{}.{}".format(*PYTHONS[0])
    assert document["project"]["requires-python"] == f">={oldest}"
    assert document["tool"]["mypy"]["python_version"] == oldest

"""Makes the files of requirements/ anew from pyproject.toml: each distribution with the digests of its wheels.

`make pins` keeps the versions that are pinned, `make pins NEWEST=1` takes the newest that fit together. uv finds out
which distributions each list needs, on which systems; only wheels count, so that an installation builds nothing.
"""

import argparse
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Final, NamedTuple
from urllib.parse import unquote

from packaging.markers import Marker
from packaging.tags import Tag, compatible_tags, cpython_tags, mac_platforms
from packaging.utils import parse_wheel_filename

from folders import ROOT

FOLDER: Final = ROOT / "requirements"
PYTHONS: Final = ((3, 11), (3, 12), (3, 13), (3, 14))
NEWEST_GLIBC: Final = 36  # of the oldest Linux that it is tried on, Debian 12: 2.36
OLD_NAMES: Final = ("manylinux2014", "manylinux2010", "manylinux1")
PLAIN: Final = {"fonttools"}  # only the wheel of plain Python: 11 MB less, and ezdxf asks it for names of fonts only
HEAD: Final = "# Made by `make pins` from pyproject.toml ({what}). Install with: pip install --require-hashes -r FILE\n"


class PinList(NamedTuple):
    """A file of requirements/: what it is for, and the list that it adds to."""

    what: str
    after: str | None = None


LISTS: Final = {
    "run": PinList("what the program needs"),
    "bags": PinList("the extra bags", "run"),
    "bluetooth": PinList("the extra bluetooth", "run"),
    "brainflow": PinList("the extra brainflow", "run"),
    "figures": PinList("the extra figures", "run"),
    "files": PinList("the extra files", "run"),
    "ros2": PinList("the extra ros2", "run"),
    "build": PinList("what builds it", "run"),
    "compile": PinList("what builds a compiled wheel", "build"),
    "test": PinList("the extra test", "compile"),
    "safety": PinList("the extra safety", "test"),
    "pins": PinList("the extra pins", "run"),
}


class Machine(NamedTuple):
    """A system that wheels are pinned for."""

    system: str
    processor: str
    python: tuple[int, int]

    def __str__(self) -> str:
        return f"{self.system} {self.processor}, Python {self.python[0]}.{self.python[1]}"

    @property
    def tags(self) -> frozenset[Tag]:
        """The tags of the wheels that it can install."""
        if self.system == "Darwin":
            names = list(mac_platforms((15, 0), self.processor))
        else:
            glibc = [f"manylinux_2_{minor}" for minor in range(NEWEST_GLIBC, 4, -1)]
            names = [f"{name}_{self.processor}" for name in (*glibc, *OLD_NAMES, "linux")]
        version = f"cp{self.python[0]}{self.python[1]}"
        return frozenset([*cpython_tags(self.python, platforms=names), *compatible_tags(self.python, version, names)])

    @property
    def markers(self) -> dict[str, str]:
        """What a marker can ask of it."""
        version = f"{self.python[0]}.{self.python[1]}"
        return {
            "platform_machine": self.processor,
            "platform_python_implementation": "CPython",
            "platform_system": self.system,
            "implementation_name": "cpython",
            "os_name": "posix",
            "python_version": version,
            "python_full_version": f"{version}.0",
            "sys_platform": self.system.lower(),
        }


ANY: Final = frozenset([Tag("py3", "none", "any")])
LINUX: Final = [Machine("Linux", processor, python) for processor in ("x86_64", "aarch64") for python in PYTHONS]
MACHINES: Final = [*LINUX, *(Machine("Darwin", "arm64", python) for python in PYTHONS)]


def required(name: str) -> list[str]:
    """Return the requirements of pyproject.toml that a list adds to those of the list before it."""
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    project, wheel = settings["project"], settings["tool"]["hatch"]["build"]["targets"]["wheel"]
    own: Mapping[str, list[str]] = {
        "run": project["dependencies"],
        "build": settings["build-system"]["requires"],
        "compile": wheel["hooks"]["custom"]["dependencies"],
        **project["optional-dependencies"],
    }
    return own[name]


def lists_before(name: str) -> list[str]:
    """Return a list and those that it adds to, the first one first."""
    before = LISTS[name].after
    return [*(lists_before(before) if before else []), name]


def resolved(requirements: Iterable[str], versions: Iterable[str]) -> dict[str, dict[str, Any]]:
    """Return what uv finds for requirements on all systems, by name; `versions` are kept."""
    with tempfile.TemporaryDirectory() as folder:
        asked, kept, found = (Path(folder) / name for name in ("asked.in", "kept.txt", "pylock.toml"))
        asked.write_text("\n".join(requirements))
        kept.write_text("\n".join(versions))
        words = [sys.executable, "-m", "uv", "pip", "compile", "--quiet", "--no-config", "--universal"]
        words += ["--python-version", "{}.{}".format(*PYTHONS[0]), "--only-binary", ":all:", "--constraint", str(kept)]
        words += ["--fork-strategy", "fewest"]  # one version for all Pythons
        subprocess.run([*words, "--format", "pylock.toml", "--output-file", str(found), str(asked)], check=True)
        return {package["name"]: package for package in tomllib.loads(found.read_text())["packages"]}


def pinned() -> dict[str, str]:
    """Return the version of every distribution that the present files pin."""
    lines = [line for file in FOLDER.glob("*.txt") for line in file.read_text().splitlines() if "==" in line]
    return dict(line.partition(" ")[0].split("==") for line in lines if line[0].isalnum())


def pin(package: Mapping[str, Any], machines: Sequence[Machine]) -> tuple[str, list[Machine]]:
    """Return the lines that pin a package to its wheels for these machines, and the machines that none is for."""
    wheels = {wheel["hashes"]["sha256"]: _tags_of(wheel) for wheel in package["wheels"]}
    if package["name"] in PLAIN:
        wheels = {digest: tags for digest, tags in wheels.items() if tags >= ANY}
    marker = package.get("marker")
    asked = [machine for machine in machines if marker is None or Marker(marker).evaluate(machine.markers)]
    fitting = {machine: {digest for digest, tags in wheels.items() if tags & machine.tags} for machine in asked}
    condition = "" if len(asked) == len(machines) else f" ; {marker}"
    digests = sorted(set().union(*fitting.values()))
    lines = [f"{package['name']}=={package['version']}{condition}", *(f"--hash=sha256:{each}" for each in digests)]
    return " \\\n    ".join(lines), [machine for machine, found in fitting.items() if not found]


def _tags_of(wheel: Mapping[str, Any]) -> frozenset[Tag]:
    name = wheel.get("name") or unquote(wheel["url"].rpartition("/")[2])
    return parse_wheel_filename(name)[3]


def write_lists(kept: Mapping[str, str]) -> None:
    """Write all files; the versions of `kept` stay."""
    everything = [requirement for name in LISTS for requirement in required(name)]
    all_of_them = resolved(everything, [f"{name}=={version}" for name, version in kept.items()])
    versions = [f"{name}=={package['version']}" for name, package in all_of_them.items()]
    needed = {
        name: resolved([one for each in lists_before(name) for one in required(each)], versions) for name in LISTS
    }
    for name, (what, before) in LISTS.items():
        earlier = needed[before] if before else {}
        lines = [f"-r {before}.txt"] if before else ["--only-binary :all:"]
        notes = []
        for each, package in needed[name].items():
            if each in earlier and earlier[each].get("marker") == package.get("marker"):
                continue
            text, without = pin(package, MACHINES)
            notes += [f"# {each} has no wheel for {machine}." for machine in without]
            lines += [text] if "--hash" in text else []  # what only other systems need has none
        file = FOLDER / f"{name}.txt"
        file.write_text(HEAD.format(what=what) + "\n".join([*notes, *lines]) + "\n", encoding="utf-8")


if __name__ == "__main__":
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--newest", action="store_true", help="take the newest versions instead of those pinned")
    write_lists({} if options.parse_args().newest else pinned())

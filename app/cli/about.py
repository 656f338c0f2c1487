"""`bodydrive about`: the version, how it was built, the installed packages and others' work in it, with licences."""

import json
import platform
import re
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import typer

from app import __version__
from app.cli.common_options import AsJson
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.texts import Text

if TYPE_CHECKING:
    from packaging.requirements import Requirement

NAME = "bodydrive"
OPTIONAL = ("figures", "ros2")  # the extras of the program itself; the others are for development
NO_LICENCE = Text("cli-about-no-licence")
NOT_INSTALLED = Text("cli-about-missing")
LONGEST_NAME = 200  # characters; a longer License field holds the text of the licence instead of its name
CLASSIFIER = "License :: "
NOTHING_STATED = {"", "UNKNOWN"}
NOTICES = "app/THIRD_PARTY_NOTICES.txt"  # beside the installed modules; hatch_build.py writes it
NOTICE = re.compile(r"^Name: (.+)\nVersion: (.+)\nLicence: (.+)\n", re.MULTILINE)
HELD = Text("cli-about-held")


class Package(NamedTuple):
    """A package that the program needs, or the work of others that its files hold."""

    name: str
    version: str | None  # None: it is required, and not installed
    licence: str | None  # as its author wrote it; None: not stated


def about(
    licences: Annotated[bool, typer.Option("--licences", help=help_text("cli-help-about-licences"))] = False,
    as_json: AsJson = False,
) -> None:
    """Say which version this is, how it was built, and which packages it uses."""
    from app.pipeline.compiled import IS_COMPILED

    python = f"{platform.python_implementation()} {platform.python_version()}"
    packages = packages_of(NAME) if licences else []
    held = held_works(NAME) if licences else []
    if as_json:
        facts = {"version": __version__, "compiled": IS_COMPILED, "python": python, "system": platform.platform()}
        lists = {"packages": packages, "included": held} if licences else {}
        typer.echo(json.dumps(facts | {name: [one._asdict() for one in list_] for name, list_ in lists.items()}))
        return
    typer.echo(Text("cli-about-compiled" if IS_COMPILED else "cli-about-plain", version=__version__))
    typer.echo(f"{python}, {platform.platform()}")
    if packages:
        typer.echo("\n".join(["", *_table(packages)]))
    if held:
        typer.echo("\n".join(["", str(HELD), *_table(held)]))


def packages_of(name: str) -> list[Package]:
    """Return a package and everything that it requires, directly and indirectly, sorted by name.

    A package of the extras `OPTIONAL` is listed only if it is installed. Raises InputError when `name` itself is not
    installed, because nothing is known about its requirements then.
    """
    from packaging.requirements import Requirement
    from packaging.utils import canonicalize_name

    if _installed(name) is None:
        raise InputError(Text("cli-about-not-installed"))
    packages: dict[str, Package] = {}
    visited: set[tuple[str, str]] = set()  # packages and their extras
    waiting = [(Requirement(f"{name}[{','.join(OPTIONAL)}]"), False)]
    while waiting:
        requirement, optional = waiting.pop()
        key = canonicalize_name(requirement.name)
        installed = _installed(key)
        if installed is None:
            if not optional:
                packages[key] = Package(requirement.name, None, None)
            continue
        packages[key] = Package(installed.metadata["Name"], installed.version, licence_of(installed))
        for extra in {"", *requirement.extras}:
            if (key, extra) not in visited:
                visited.add((key, extra))
                waiting += [(required, key == name and extra in OPTIONAL) for required in _required(installed, extra)]
    return sorted(packages.values(), key=lambda package: canonicalize_name(package.name))


def held_works(name: str) -> list[Package]:
    """Return the work of others that the files of an installed package hold, as its notices have it."""
    installed = _installed(name)
    file = Path(str(installed.locate_file(NOTICES))) if installed else None
    return [Package(*found) for found in NOTICE.findall(file.read_text("utf-8"))] if file and file.is_file() else []


def _required(installed: Distribution, extra: str) -> "list[Requirement]":
    """Return what a package requires on this machine: of itself, or for one of its extras."""
    from packaging.requirements import Requirement

    requirements = [Requirement(line) for line in installed.requires or []]
    if not extra:
        return [
            requirement
            for requirement in requirements
            if requirement.marker is None or requirement.marker.evaluate({"extra": ""})
        ]
    return [
        requirement
        for requirement in requirements
        if requirement.marker is not None
        and requirement.marker.evaluate({"extra": extra})
        and not requirement.marker.evaluate({"extra": ""})
    ]


def licence_of(installed: Distribution) -> str | None:
    """Return the licence that a package states: its expression, else its name, else its classifiers."""

    def stated(field: str) -> list[str]:
        lines = [" ".join(line.split()) for line in installed.metadata.get_all(field) or []]
        return [line for line in lines if line not in NOTHING_STATED]

    for name in (*stated("License-Expression"), *stated("License")):
        if len(name) <= LONGEST_NAME:
            return name
    classifiers = [line.rpartition(" :: ")[2] for line in stated("Classifier") if line.startswith(CLASSIFIER)]
    return " and ".join(classifiers) or None


def _installed(name: str) -> Distribution | None:
    try:
        return distribution(name)
    except PackageNotFoundError:
        return None


def _table(packages: list[Package]) -> list[str]:
    rows = [(each.name, each.version or str(NOT_INSTALLED), each.licence or str(NO_LICENCE)) for each in packages]
    widths = [max(len(row[column]) for row in rows) for column in range(2)]
    return [f"{name:<{widths[0]}}  {version:<{widths[1]}}  {licence}" for name, version, licence in rows]

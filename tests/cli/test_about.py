"""`bodydrive about`: the packages are those that are installed for it, and each licence is the one that is stated."""

import json
import subprocess
import sys
from email.message import Message
from importlib.metadata import version
from types import SimpleNamespace

import pytest

from app import __version__
from app.cli import about
from folders import ROOT

FULL_TEXT = "Permission is hereby granted, free of charge, to any person\n" * 9


def listed(bodydrive, *more):
    code, out, err = bodydrive("about", *more)
    assert (code, err) == (0, "")
    return out


def test_it_says_version_build_and_python(bodydrive):
    facts = json.loads(listed(bodydrive, "--json"))
    assert facts.keys() == {"version", "compiled", "python", "system"}
    assert (facts["version"], facts["compiled"]) == (__version__, False)
    assert listed(bodydrive).startswith(f"bodydrive {__version__}, built as plain Python")


def test_the_packages_are_those_it_requires_directly_and_indirectly_and_no_others(bodydrive):
    packages = {one["name"].lower(): one for one in json.loads(listed(bodydrive, "--licences", "--json"))["packages"]}
    # starlette comes with fastapi, joblib with scikit-learn
    assert {"bodydrive", "numpy", "starlette", "joblib", "uvicorn"} <= packages.keys()
    assert not {"pytest", "ruff", "mypy", "playwright", "hypothesis"} & packages.keys()
    assert {name: one["version"] for name, one in packages.items() if one["version"] != version(name)} == {}
    assert packages["sqlalchemy"]["licence"] == "MIT"
    table = listed(bodydrive, "--licences")
    assert len(table.splitlines()) == len(packages) + 3
    assert "no licence stated" in next(line for line in table.splitlines() if line.startswith("bodydrive  "))


def package(requires=(), **fields):
    metadata = Message()
    for name, values in fields.items():
        for value in [values] if isinstance(values, str) else values:
            metadata[name.replace("_", "-")] = value
    return SimpleNamespace(metadata=metadata, version="1", requires=list(requires))


@pytest.mark.parametrize(
    ("fields", "licence"),
    [
        ({"License_Expression": "BSD-3-Clause", "License": "BSD"}, "BSD-3-Clause"),
        ({"License": "MIT"}, "MIT"),
        ({"License": FULL_TEXT, "Classifier": "License :: OSI Approved :: MIT License"}, "MIT License"),
        ({"License": "UNKNOWN", "Classifier": ["License :: OSI Approved :: A", "License :: B"]}, "A and B"),
        ({"Classifier": "Topic :: Scientific/Engineering"}, None),
    ],
    ids=["expression", "name", "text", "classifiers", "none"],
)
def test_the_licence_is_the_one_that_the_package_states(fields, licence):
    assert about.licence_of(package(**fields)) == licence


def test_extras_and_markers_are_followed_and_what_is_missing_is_said(monkeypatch):
    here = {
        "bodydrive": package(
            ["web[fast]", "gone", "old; python_version < '3'", "bus; extra == 'ros2'", "plots; extra == 'figures'"],
            Name="bodydrive",
        ),
        "web": package(["quick; extra == 'fast'", "slow; extra == 'all'", "bodydrive"], Name="web", License="MIT"),
        "quick": package(Name="quick", License="MIT"),
        "old": package(Name="old"),
        "slow": package(Name="slow"),
    }
    monkeypatch.setattr(about, "_installed", here.get)
    found = {one.name: one.version for one in about.packages_of("bodydrive")}
    assert found == {"bodydrive": "1", "gone": None, "quick": "1", "web": "1"}
    here |= {name: package(Name=name) for name in ("bus", "plots")}
    assert {"bus", "plots"} <= {one.name for one in about.packages_of("bodydrive")}


def test_without_an_installation_it_is_a_sentence(bodydrive, monkeypatch):
    monkeypatch.setattr(about, "_installed", {}.get)
    code, out, err = bodydrive("about", "--licences")
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert "not installed for this Python" in err


HELP = """
import sys
from app.cli.main import main

sys.argv[1:] = ["about", "--help"]
try:
    main()
finally:
    print({"numpy", "packaging", "fastapi"} & set(sys.modules))
"""


def test_its_help_loads_no_library_of_the_program():
    ended = subprocess.run([sys.executable, "-c", HELP], cwd=ROOT, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr
    assert ended.stdout.endswith("set()\n")

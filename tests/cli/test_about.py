"""`bodydrive about`: the packages are those that are installed for it, and each licence is the one that is stated."""

import json
import subprocess
import sys
from email.message import Message
from importlib.metadata import version
from types import SimpleNamespace

import pytest
from cli.answers import assert_refused, output_of

from app import __version__
from app.cli import about
from folders import ROOT
from hatch_build import Foreign, notice_of_compiled, notices

FULL_TEXT = "Permission is hereby granted, free of charge, to any person\n" * 9


def listed(bodydrive, *more):
    return output_of(bodydrive("about", *more))


def test_it_says_version_build_and_python(bodydrive):
    facts = json.loads(listed(bodydrive, "--json"))
    assert facts.keys() == {"version", "compiled", "python", "system"}
    assert (facts["version"], facts["compiled"]) == (__version__, False)
    assert listed(bodydrive).startswith(f"bodydrive {__version__}, built as plain Python")


def test_the_packages_are_those_it_requires_directly_and_indirectly_and_no_others(bodydrive):
    facts = json.loads(listed(bodydrive, "--licences", "--json"))
    packages = {one["name"].lower(): one for one in facts["packages"]}
    # starlette comes with fastapi, joblib with scikit-learn
    assert {"bodydrive", "numpy", "starlette", "joblib", "uvicorn"} <= packages.keys()
    assert not {"pytest", "ruff", "mypy", "playwright", "hypothesis"} & packages.keys()
    assert {name: one["version"] for name, one in packages.items() if one["version"] != version(name)} == {}
    assert packages["sqlalchemy"]["licence"] == "MIT"
    table, _, held = listed(bodydrive, "--licences").partition(f"\n{about.HELD}\n")
    assert len(table.splitlines()) == len(packages) + 3
    assert len(held.splitlines()) == len(facts["included"])
    assert "no licence stated" in next(line for line in table.splitlines() if line.startswith("bodydrive  "))


def test_the_work_of_others_in_its_files_is_listed_as_the_notices_have_it(bodydrive, monkeypatch, tmp_path):
    works = [
        Foreign("preact", "11.2.0", "MIT", "a/*", "a/text"),
        Foreign("Noto fonts", "of Debian", "OFL-1.1", "b", "c"),
    ]
    for name in ("a/preact.js", "a/text", "b", "c", about.NOTICES):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_text("Permission is granted. Name: of nobody\n")
    (tmp_path / about.NOTICES).write_text(notices(tmp_path, works) + notice_of_compiled())
    installed = package(Name="bodydrive")
    installed.locate_file = tmp_path.joinpath
    monkeypatch.setattr(about, "_installed", {"bodydrive": installed}.get)
    included = json.loads(listed(bodydrive, "--licences", "--json"))["included"]
    expected = [(one.name, one.version, one.licence) for one in works]
    expected.append(("mypyc's run time", f"of mypy {version('mypy')}", "MIT"))
    assert [tuple(one.values()) for one in included] == expected
    table = listed(bodydrive, "--licences").splitlines()
    assert table[table.index(str(about.HELD)) + 1].split() == ["preact", "11.2.0", "MIT"]


def test_an_installation_without_notices_lists_none(monkeypatch, tmp_path):
    installed = package(Name="bodydrive")
    installed.locate_file = tmp_path.joinpath
    monkeypatch.setattr(about, "_installed", {"bodydrive": installed}.get)
    assert about.held_works("bodydrive") == []


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
    assert_refused(bodydrive("about", "--licences"), "not installed for this Python")


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

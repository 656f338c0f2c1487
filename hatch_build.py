"""Compiles the middle of bodydrive (mypyc) when a wheel is built on a machine with a C compiler.

Without a compiler the wheel is plain Python, with equal numbers, bit for bit (`make compiled` compares them). An
editable installation is never compiled: a compiled file that is older than its source would be used without a word.
The environment variable BODYDRIVE_COMPILE decides otherwise: `no` for plain Python, `must` to fail without a compiler.
"""

import os
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path
from shutil import which
from typing import Any

# Each product and sum is rounded by itself, as in plain Python, also where a processor could do both in one step.
SAME_ROUNDING = "-ffp-contract=off"


class CompileError(Exception):
    """Why the modules cannot be compiled."""


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

    class CompiledMiddle(BuildHookInterface):
        """Puts the compiled modules into a wheel."""

        _folder: tempfile.TemporaryDirectory[str] | None = None

        def initialize(self, version: str, build_data: dict[str, Any]) -> None:
            """Compile the modules that pyproject.toml lists."""
            wish = os.environ.get("BODYDRIVE_COMPILE")
            if version == "editable" or wish == "no":
                return
            try:
                require_compiler()
                files = self._compiled()
            except CompileError as reason:
                if wish == "must":
                    raise
                self.app.display_warning(f"This wheel is plain Python, with equal numbers but slower: {reason}.")
                return
            build_data["force_include"].update(files)
            build_data["pure_python"], build_data["infer_tag"] = False, True

        def finalize(self, *_: Any) -> None:
            """Remove the compiled files, which are in the wheel now."""
            if self._folder is not None:
                self._folder.cleanup()

        def _compiled(self) -> dict[str, str]:
            """Return the compiled files, each with its place in the wheel."""
            self._folder = tempfile.TemporaryDirectory()
            folder = Path(self._folder.name)
            words = [sys.executable, __file__, str(folder), *self.config["modules"]]
            ended = subprocess.run(words, cwd=self.root, check=False, capture_output=True, text=True)
            if ended.returncode:
                raise CompileError(f"the compiler ended with\n{ended.stdout}{ended.stderr}")
            return {str(file): str(file.relative_to(folder)) for file in folder.rglob("*") if file.is_file()}

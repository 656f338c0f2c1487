"""Where things lie: what comes with the software, and what this place keeps."""

import os
from pathlib import Path

STATE_VARIABLE = "BODYDRIVE_STATE"


def data_folder() -> Path:
    """Return the folder of layouts, floor plans and scenes that come with the software.

    Raises
    ------
    FileNotFoundError
        When the installation has none.
    """
    return _carried("data")


def static_folder() -> Path:
    """Return the folder of the web pages that come with the software.

    Raises
    ------
    FileNotFoundError
        When the installation has none.
    """
    return _carried("web_static")


def state_folder() -> Path:
    """Return the folder of the database and the recordings: BODYDRIVE_STATE, or `var` where the program was started."""
    return Path(os.environ.get(STATE_VARIABLE) or "var").expanduser().absolute()


def _carried(name: str) -> Path:
    """Find `name` inside the installed package, or beside it in a source checkout."""
    package = Path(__file__).resolve().parent
    for folder in (package / name, package.parent / name):
        if folder.is_dir():
            return folder
    raise FileNotFoundError(f"this installation has no folder '{name}': install bodydrive again")

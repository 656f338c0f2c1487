"""Where things lie, and how this web process was started."""

import ipaddress
import os
import secrets
import sys
from dataclasses import dataclass, field
from pathlib import Path

PACKAGE = Path(__file__).parent
IN_USE = "in-use"  # the file that says, by a lock, that a program has the state open
CODE_BYTES = 16  # 128 bits: a code of this length cannot be guessed


def _packed(name: str) -> Path:
    """Return a folder that a wheel carries inside the package and a checkout beside it."""
    inside = PACKAGE / name
    return inside if inside.is_dir() else PACKAGE.parent / name


def static_folder() -> Path:
    """Return the folder of the pages."""
    return _packed("web_static")


def data_folder() -> Path:
    """Return the folder of the bundled shirts and floor plans."""
    return _packed("data")


def state_folder() -> Path:
    """Return where the database and the recordings of a real clinic live: BODYDRIVE_STATE or the system's own place."""
    chosen = os.environ.get("BODYDRIVE_STATE")
    if chosen:
        return Path(chosen).expanduser().resolve()
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Application Support" / "bodydrive"
    return Path(os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state") / "bodydrive"


def new_code() -> str:
    """Return a fresh random code for a link."""
    return secrets.token_urlsafe(CODE_BYTES)


@dataclass(frozen=True, slots=True)
class Settings:
    """How one web process runs; made once at the start."""

    state: Path = field(default_factory=state_folder)
    host: str = "127.0.0.1"
    port: int = 8080
    demo_code: str | None = field(default=None, repr=False)  # set: this is a demonstration
    setup_code: str | None = field(default=None, repr=False)  # for the first owner only

    @property
    def demo(self) -> bool:
        """Whether this is the throw-away clinic of a demonstration."""
        return self.demo_code is not None

    @property
    def files(self) -> Path:
        """Return the folder of the recorded signals and bodies that people bring."""
        return self.state / "files"

    @property
    def runs(self) -> Path:
        """Return the folder of the recordings."""
        return self.state / "runs"

    @property
    def models(self) -> Path:
        """Return the folder of the 3D objects that people bring."""
        return self.state / "models"

    @property
    def floorplans(self) -> Path:
        """Return the folder of the clinic's own floor plans."""
        return self.state / "floorplans"

    @property
    def replaced(self) -> Path:
        """Return the folder of what uploads have replaced."""
        return self.state / "replaced"

    @property
    def keys(self) -> Path:
        """Return the folder of the keys that are shared with real chairs, one file each."""
        return self.state / "keys"

    @property
    def database(self) -> Path:
        """Return the database's file."""
        return self.state / "bodydrive.sqlite"

    @property
    def state_paths(self) -> list[Path]:
        """Return the files of the program in the state folder, and that folder itself when nothing else lies in it."""
        beside = sorted(self.state.glob(f"*{self.database.name}*"))  # the log's head, the ballast, copies
        folders = [self.files, self.runs, self.models, self.keys, self.floorplans, self.replaced]
        own = [*beside, *folders, self.state / IN_USE]
        foreign = set(self.state.glob("*")) - set(own)
        return own if foreign or not self.state.exists() else [self.state, *own]

    def serves(self, host: str) -> bool:
        """Tell whether a request's Host (without port) can be meant for us.

        A foreign page can point its own name at this machine (DNS rebinding), but it cannot make a browser name us
        by a bare address, by localhost or by the name that we were told to serve.
        """
        if host in {"localhost", self.host}:
            return True
        try:
            ipaddress.ip_address(host.strip("[]"))
        except ValueError:
            return False
        return True

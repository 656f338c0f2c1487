"""The folders of the program, and the settings of this web process."""

import ipaddress
import os
import secrets
import sys
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import urlsplit

from app.network import NetworkService
from app.ports import HTTP_PORT

ProxyNetwork = ipaddress.IPv4Network | ipaddress.IPv6Network
PACKAGE = Path(__file__).parent
IN_USE = "in-use"  # name of the file that is locked while a program uses the state folder
CODE_BYTES = 16  # 128 bits: a code of this length cannot be guessed


def _bundled_folder(name: str) -> Path:
    """Return a folder that lies inside the package in a wheel and beside it in a checkout."""
    inside = PACKAGE / name
    return inside if inside.is_dir() else PACKAGE.parent / name


def static_folder() -> Path:
    """Return the folder of the web pages."""
    return _bundled_folder("web_static")


def data_folder() -> Path:
    """Return the folder of the bundled shirts and floor plans."""
    return _bundled_folder("data")


def docs_folder() -> Path:
    """Return the folder of the pages for people: clinicians, administrators, developers."""
    return _bundled_folder("docs")


def state_folder() -> Path:
    """Return the folder of a clinic's database and recordings: BODYDRIVE_STATE, else the system's usual folder."""
    chosen = os.environ.get("BODYDRIVE_STATE")
    if chosen:
        return Path(chosen).expanduser().resolve()
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Application Support" / "bodydrive"
    return Path(os.environ.get("XDG_STATE_HOME") or Path.home() / ".local" / "state") / "bodydrive"


def new_code() -> str:
    """Return a new random code for a link."""
    return secrets.token_urlsafe(CODE_BYTES)


@dataclass(frozen=True, slots=True)
class Settings:
    """Settings of one web process, made once at its start."""

    state: Path = field(default_factory=state_folder)
    host: str = "127.0.0.1"
    port: int = HTTP_PORT
    demo_code: str | None = field(default=None, repr=False)  # set: this is a demonstration
    setup_code: str | None = field(default=None, repr=False)  # for the first owner only
    proxy: ProxyNetwork | None = None  # set: requests come through a proxy of this network, and in no other way
    public_name: str = ""  # HOST or HOST:PORT by which browsers reach the proxy
    network: NetworkService | None = None  # set: other machines reach the pages, over https
    lsl: bool = False  # whether what is driven is sent over LSL, for everybody on the network

    @property
    def demo(self) -> bool:
        """Whether this is the throw-away clinic of a demonstration."""
        return self.demo_code is not None

    @property
    def files(self) -> Path:
        """Return the folder of uploaded recordings of signals and bodies."""
        return self.state / "files"

    @property
    def runs(self) -> Path:
        """Return the folder of the recordings."""
        return self.state / "runs"

    @property
    def models(self) -> Path:
        """Return the folder of uploaded 3D objects."""
        return self.state / "models"

    @property
    def floorplans(self) -> Path:
        """Return the folder of the clinic's own floor plans."""
        return self.state / "floorplans"

    @property
    def replaced(self) -> Path:
        """Return the folder of files that uploads have replaced."""
        return self.state / "replaced"

    @property
    def keys(self) -> Path:
        """Return the folder of the keys that are shared with real chairs, one file each."""
        return self.state / "keys"

    @property
    def authority(self) -> Path:
        """Return the folder of the clinic's certificate authority, its keys and the machine's certificate."""
        return self.state / "authority"

    @property
    def signing(self) -> Path:
        """Return the folder of the key that signs the clinic's archives."""
        return self.state / "signing"

    @property
    def backup(self) -> Path:
        """Return the folder of a backup that is being made, and of the key of the backups of every night."""
        return self.state / "backup"

    @property
    def erased(self) -> Path:
        """Return the file of the tombstones: which patients were erased."""
        return self.state / "erased-patients.json"

    @property
    def database(self) -> Path:
        """Return the database's file."""
        return self.state / "bodydrive.sqlite"

    @property
    def state_paths(self) -> list[Path]:
        """Return the program's files in the state folder, and that folder itself when it holds nothing else."""
        beside = sorted(self.state.glob(f"*{self.database.name}*"))  # the database, its log head, ballast and copies
        folders = [self.files, self.runs, self.models, self.keys, self.authority, self.floorplans, self.replaced]
        folders += [self.signing, self.backup]
        own_paths = [*beside, *folders, self.erased, self.state / IN_USE]
        foreign = set(self.state.glob("*")) - set(own_paths)
        return own_paths if foreign or not self.state.exists() else [self.state, *own_paths]

    def serves(self, host: str) -> bool:
        """Return whether a request's Host (without port) names this server: its address, localhost, its own name.

        A foreign page can let its own name resolve to this machine (DNS rebinding), but its requests then carry that
        name.
        """
        own_names = {"localhost", self.host, urlsplit(f"//{self.public_name}").hostname}
        if host in own_names or (self.network is not None and self.network.names(host)):
            return True
        try:
            ipaddress.ip_address(host.strip("[]"))
        except ValueError:
            return False
        return True

"""A real `bodydrive serve --lan` for tests, on two addresses of the loopback network that stand for two machines."""

import socket
import ssl
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import urlsplit

import httpx
from processes.served_demo import running_program

HOSTS = ("127.0.0.1", "127.0.0.2")
NAME = socket.gethostname().lower()
OWNER = {"name": "Ada", "password": "correct horse battery"}


class ServedLan:
    """A running program, its three addresses, and a client's trust in its authority."""

    def __init__(self, process: "subprocess.Popen[str]", state: Path) -> None:
        self.process, self.state = process, state
        self.printed: list[str] = []
        assert process.stdout is not None
        for line in process.stdout:
            self.printed.append(line.rstrip("\n"))
            if len(self.links) == 2:
                break
        assert len(self.links) == 2, process.communicate()[1]
        self.local, _, self.code = self.links[0].partition("#setup=")
        self.page = self.links[1]
        self.facts = httpx.get(f"{self.page}facts.json").json()
        self.port = urlsplit(self.facts["link"]).port
        self.root = httpx.get(f"{self.page}bodydrive-authority.crt").text
        self.trust = ssl.create_default_context(cadata=self.root)

    @property
    def links(self) -> list[str]:
        return [line for line in self.printed if line.startswith("http")]

    def client(self, host: str = HOSTS[0]) -> httpx.Client:
        """Return a browser on another machine that trusts the authority."""
        base = f"https://{host}:{self.port}"
        return httpx.Client(base_url=base, headers={"Origin": base}, verify=self.trust, timeout=60)


@contextmanager
def served_lan(state: Path, *words: str) -> Iterator[ServedLan]:
    hosts = [word for host in HOSTS for word in ("--host", host)]
    with running_program("serve", "--lan", *hosts, "--port", "0", "--state", str(state), *words) as process:
        yield ServedLan(process, state)
    assert process.returncode == 0

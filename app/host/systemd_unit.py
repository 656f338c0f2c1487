"""A systemd unit, so that the machine starts the clinic by itself.

Source: systemd.unit(5), systemd.service(5), systemd.exec(5).
"""

import os
import shutil
import subprocess
from pathlib import Path

from app.files import write_atomically
from app.refusals import Refusal

NAME = "bodydrive.service"
SYSTEM_FOLDER = Path("/etc/systemd/system")

UNIT = """\
[Unit]
Description=bodydrive: the clinic in {state}
After=network-online.target
Wants=network-online.target

[Service]
ExecStart={command}
{account}Restart=on-failure
RestartSec=5
KillSignal=SIGTERM
TimeoutStopSec=30
UMask=0077
NoNewPrivileges=yes
LimitNOFILE=16384
{rights}
[Install]
WantedBy={target}
"""
# Real-time scheduling and locked memory for the control loop (app/realtime.py), and port 80 for the page that explains.
RIGHTS = """\
LimitRTPRIO=10
LimitMEMLOCK=infinity
AmbientCapabilities=CAP_NET_BIND_SERVICE
"""


def user_folder() -> Path:
    """Return the folder of this person's own units."""
    return Path(os.environ.get("XDG_CONFIG_HOME") or Path.home() / ".config") / "systemd" / "user"


def unit(command: list[str], state: Path, account: str | None) -> str:
    """Return the text of the unit; with `account` one of the system that runs as this account, else a person's own."""
    return UNIT.format(
        command=" ".join(_quoted(word) for word in command),
        state=_escaped(str(state)),
        account="" if account is None else f"User={account}\n",
        rights="" if account is None else RIGHTS,
        target="default.target" if account is None else "multi-user.target",
    )


def install(text: str, *, system: bool) -> list[str]:
    """Write the unit, enable and start it; return what was done, and what remains to be done by a person.

    Raises
    ------
    Refusal
        The machine has no systemd, or systemd refuses.
    """
    systemctl = shutil.which("systemctl")
    if systemctl is None:
        raise Refusal("This machine has no systemd: let it start the command of --print by its own means.")
    file = (SYSTEM_FOLDER if system else user_folder()) / NAME
    try:
        write_atomically(file, text.encode(), 0o644)
    except OSError as error:
        why = error.strerror or error
        raise Refusal(f"{file} cannot be written ({why}): with --system, run this with sudo.") from error
    systemctl_command = [systemctl] if system else [systemctl, "--user"]
    for command in (["daemon-reload"], ["enable", "--now", NAME]):
        result = subprocess.run([*systemctl_command, *command], capture_output=True, text=True, check=False)
        if result.returncode != 0:
            reason = " ".join(result.stderr.split()) or f"exit code {result.returncode}"
            raise Refusal(f"{file} is written, but systemd did not take it ({reason}): see to it, then try again.")
    remaining = (
        [] if system else ["It starts when you sign in; 'loginctl enable-linger' lets it start with the machine."]
    )
    return [f"{file} is installed and started: 'systemctl {'' if system else '--user '}status {NAME}'.", *remaining]


def _quoted(word: str) -> str:
    """Return a word of ExecStart: percent signs and dollars would be replaced, spaces would divide it."""
    return '"' + _escaped(word).replace("\\", "\\\\").replace('"', '\\"').replace("$", "$$") + '"'


def _escaped(text: str) -> str:
    return text.replace("%", "%%")

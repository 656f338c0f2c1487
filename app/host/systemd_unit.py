"""A systemd unit, so that the machine starts the clinic by itself.

Source: systemd.unit(5), systemd.service(5), systemd.exec(5).
"""

import os
import shutil
import subprocess
from pathlib import Path

from app.files import write_atomically
from app.refusals import Refusal
from app.texts import Text
from app.visible_text import one_line

NAME = "bodydrive.service"
SYSTEM_FOLDER = Path("/etc/systemd/system")

UNIT = """\
[Unit]
Description={description}
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
        description=Text("host-service-description", folder=_escaped(str(state))),
        account="" if account is None else f"User={account}\n",
        rights="" if account is None else RIGHTS,
        target="default.target" if account is None else "multi-user.target",
    )


def install(text: str, *, system: bool) -> list[Text]:
    """Write the unit, enable and start it; return what was done, and what remains to be done by a person.

    Raises
    ------
    Refusal
        The machine has no systemd, or systemd refuses.
    """
    systemctl = shutil.which("systemctl")
    if systemctl is None:
        raise Refusal(Text("host-service-no-systemd"))
    file = (SYSTEM_FOLDER if system else user_folder()) / NAME
    try:
        write_atomically(file, text.encode(), 0o644)
    except OSError as error:
        raise Refusal(Text("host-service-unwritable", file=str(file), why=error.strerror or error)) from error
    systemctl_command = [systemctl] if system else [systemctl, "--user"]
    for command in (["daemon-reload"], ["enable", "--now", NAME]):
        result = subprocess.run([*systemctl_command, *command], capture_output=True, text=True, check=False)
        if result.returncode != 0:
            why = one_line(result.stderr) or Text("host-service-exit-code", code=result.returncode)
            raise Refusal(Text("host-service-refused", file=str(file), why=why))
    if system:
        return [Text("host-service-installed", file=str(file), command=f"systemctl status {NAME}")]
    return [
        Text("host-service-installed", file=str(file), command=f"systemctl --user status {NAME}"),
        Text("host-service-starts-at-sign-in"),
    ]


def _quoted(word: str) -> str:
    """Return a word of ExecStart: percent signs and dollars would be replaced, spaces would divide it."""
    return '"' + _escaped(word).replace("\\", "\\\\").replace('"', '\\"').replace("$", "$$") + '"'


def _escaped(text: str) -> str:
    return text.replace("%", "%%")

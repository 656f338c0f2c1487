"""The process that makes a backup for the web process: `python -m app.backup.backup_process`, at the lowest priority.

It reads one line of JSON from stdin, and prints lines of JSON: `{"step", "done", "total"}` as it goes on, and at the
end `{"made": ...}` or `{"refused": sentence}`.
"""

import json
import signal
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any, Final

from app.backup.age_files import Secret
from app.backup.making import make_backup
from app.backup.quiet_files import take_lowest_priority
from app.clock import monotonic
from app.file_modes import keep_new_files_private
from app.refusals import Refusal
from app.settings import Settings

TELL_EVERY: Final = 0.5  # s


def main() -> None:
    """Make one backup, and say how it goes."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the web process, which then ends this one
    take_lowest_priority()
    keep_new_files_private()
    job = json.loads(sys.stdin.readline())
    secret = None if job["secret"] is None else Secret(**job["secret"])
    last = [monotonic()]

    def progress(step: str, done: int, total: int) -> None:
        if monotonic() - last[0] >= TELL_EVERY:
            last[0] = monotonic()
            _print({"step": step, "done": done, "total": total})

    try:
        report = make_backup(
            Settings(state=Path(job["state"])),
            Path(job["target"]),
            secret,
            with_keys=job["with_keys"],
            progress=progress,
        )
    except Refusal as refusal:
        _print({"refused": str(refusal)})
    except Exception as error:
        _print({"refused": words_of(error)})
    else:
        _print({"made": asdict(report)})


def words_of(error: Exception) -> str:
    """Return in one sentence why a backup failed."""
    why = getattr(error, "strerror", None) or str(error).partition("\n")[0] or type(error).__name__
    place = getattr(error, "filename", None)
    return f"The backup could not be made ({why}{f': {place}' if place else ''}): look at the disks, then try again."


def _print(line: dict[str, Any]) -> None:
    sys.stdout.write(json.dumps(line) + "\n")
    sys.stdout.flush()


if __name__ == "__main__":
    main()

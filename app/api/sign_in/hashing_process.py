"""The process that hashes passwords: `python -m app.api.sign_in.hashing_process --time T --memory KIB --lanes N`.

For each line on stdin, a JSON object, one line on stdout: `{"do": "hash", "password"}` is answered by `{"hash"}`;
`{"do": "verify", "stored": hash or null, "password"}` by `{"matches": bool}`; null takes as long as a hash and gives
false. The process ends with stdin.
"""

import argparse
import json
import os
import signal
import sys
from typing import Any

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

from app.realtime import lower_priority


def main() -> None:
    """Answer until stdin ends."""
    given = _parser().parse_args()
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the web process, which then ends this one
    lower_priority()
    hasher = PasswordHasher(time_cost=given.time, memory_cost=given.memory, parallelism=given.lanes)
    try:
        for line in sys.stdin:
            sys.stdout.write(f"{json.dumps(answer(hasher, json.loads(line)))}\n")
            sys.stdout.flush()
    except BrokenPipeError:  # the web process has ended
        os._exit(0)  # an ordinary end would try to write the answer once more


def answer(hasher: PasswordHasher, request: dict[str, Any]) -> dict[str, Any]:
    """Return the answer to one line."""
    stored, password = request.get("stored"), request["password"]
    if request["do"] == "hash":
        return {"hash": hasher.hash(password)}
    if stored is None:
        hasher.hash(password)  # takes as long as for a known person
        return {"matches": False}
    try:
        return {"matches": hasher.verify(stored, password)}
    except (VerificationError, InvalidHashError):
        return {"matches": False}


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m app.api.sign_in.hashing_process", description="Hashes passwords.")
    parser.add_argument("--time", type=int, required=True, help="passes over the memory")
    parser.add_argument("--memory", type=int, required=True, help="KiB")
    parser.add_argument("--lanes", type=int, required=True, help="threads")
    return parser


if __name__ == "__main__":
    main()

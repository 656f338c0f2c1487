"""The process that hashes passwords: `python -m app.api.sign_in.hashing_process --time T --memory KIB --lanes N`.

For each line on stdin, a JSON object, one line on stdout: `{"do": "hash", "password"}` is answered by `{"hash"}`;
`{"do": "verify", "stored": hash or null, "password"}` by `{"matches": bool}`; null takes as long as a hash and gives
false. The process ends with stdin.
"""

import argparse
from collections.abc import Mapping

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

from app.child_process import prepare_child, questions, respond


def main() -> None:
    """Answer until stdin ends."""
    cost = _parser().parse_args()
    prepare_child()
    hasher = PasswordHasher(time_cost=cost.time, memory_cost=cost.memory, parallelism=cost.lanes)
    for question in questions():
        respond(answer(hasher, question))


def answer(hasher: PasswordHasher, question: Mapping[str, object]) -> dict[str, str | bool]:
    """Return the answer to one line."""
    stored, password = question.get("stored"), str(question["password"])
    if question["do"] == "hash":
        return {"hash": hasher.hash(password)}
    if stored is None:
        hasher.hash(password)  # takes as long as for a known person
        return {"matches": False}
    try:
        return {"matches": hasher.verify(str(stored), password)}
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

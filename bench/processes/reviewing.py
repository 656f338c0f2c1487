"""A reviewer who looks at one trial after the other, for a benchmark.

Arguments: the port of the web process, the token of a sign-in, `timeline` or `picture`, ids of trials. Then, for each
line on stdin, `on` lets the reviewer begin and `off` lets the reviewer end, when the trial under way is over; answers
with a JSON object of how often each status came so far. Ends with stdin.
"""

import http.client
import json
import sys
import threading
from collections import Counter
from contextlib import nullcontext
from itertools import cycle
from typing import Any

from app.api.sign_in.identity import COOKIE

MOMENTS = 20  # of each picture that are shown
BETWEEN = 0.05  # s between two moments, as on the page
LAST = 300.0  # s of the recording
LOOKING = 0.3  # s at a time line before the next trial


class Reviewer:
    """The requests of the page of a trial."""

    def __init__(self, port: int, token: str, kind: str) -> None:
        self.answers = Counter[int]()
        self._connection = http.client.HTTPConnection("127.0.0.1", port)
        self._headers = {"Cookie": f"{COOKIE}={token}", "Content-Type": "application/json", "Accept-Encoding": "gzip"}
        self._headers["Origin"] = f"http://127.0.0.1:{port}"
        self._look = self._picture if kind == "picture" else self._timeline
        self._pause = threading.Event()

    def look(self, trial: int) -> None:
        """Look at one trial."""
        self._look(trial)

    def _timeline(self, trial: int) -> None:
        self._ask("GET", f"/trials/{trial}/timeline")
        self._pause.wait(LOOKING)

    def _picture(self, trial: int) -> None:
        word = json.loads(self._ask("POST", "/replays", {"trial": trial}))["id"]
        for number in range(MOMENTS):
            self._pause.wait(BETWEEN)
            self._ask("POST", f"/replays/{word}/at", {"t": LAST * number / MOMENTS, "view": "chase"})
        self._ask("DELETE", f"/replays/{word}")

    def _ask(self, method: str, path: str, body: Any = None) -> bytes:
        content = None if body is None else json.dumps(body)
        self._connection.request(method, f"/api/v1{path}", content, self._headers)
        answer = self._connection.getresponse()
        self.answers[answer.status] += 1
        return answer.read()


def main(reviewer: Reviewer, trials: list[int]) -> None:
    """Look at trials until stdin ends."""
    is_on, looking = threading.Event(), threading.Lock()
    threading.Thread(target=_review, args=(reviewer, trials, is_on, looking), daemon=True).start()
    while word := sys.stdin.readline().strip():
        (is_on.set if word == "on" else is_on.clear)()
        with looking if word == "off" else nullcontext():
            sys.stdout.write(f"{json.dumps(reviewer.answers)}\n")
            sys.stdout.flush()


def _review(reviewer: Reviewer, trials: list[int], is_on: threading.Event, looking: threading.Lock) -> None:
    for trial in cycle(trials):
        is_on.wait()
        with looking:
            reviewer.look(trial)


if __name__ == "__main__":
    main(Reviewer(int(sys.argv[1]), sys.argv[2], sys.argv[3]), [int(trial) for trial in sys.argv[4:]])

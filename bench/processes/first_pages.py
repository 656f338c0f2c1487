"""Opens pages for which the web process has to start its computing process.

Arguments: the port of the web process, the token of a sign-in, the pages. Then, for each line on stdin, `on` lets it
begin and `off` lets it end, when the page under way is answered; answers with a JSON object of how often each status
came so far. Ends with stdin.
"""

import http.client
import json
import sys
import threading
from collections import Counter
from contextlib import nullcontext

from app.api.sign_in.identity import COOKIE

IDLE = 0.5  # s between two looks at all pages, after which the computing process of the benchmark has ended


def main(port: int, token: str, pages: list[str]) -> None:
    """Open pages until stdin ends."""
    is_on, page_open, answers = threading.Event(), threading.Lock(), Counter[int]()
    threading.Thread(target=_open, args=(port, token, pages, is_on, page_open, answers), daemon=True).start()
    while word := sys.stdin.readline().strip():
        (is_on.set if word == "on" else is_on.clear)()
        with page_open if word == "off" else nullcontext():
            sys.stdout.write(f"{json.dumps(answers)}\n")
            sys.stdout.flush()


def _open(
    port: int, token: str, pages: list[str], is_on: threading.Event, page_open: threading.Lock, answers: Counter[int]
) -> None:
    pause = threading.Event()
    while is_on.wait():
        for page in pages:
            with page_open:
                answers[_status(port, token, page)] += 1
        pause.wait(IDLE)


def _status(port: int, token: str, page: str) -> int:
    connection = http.client.HTTPConnection("127.0.0.1", port)
    connection.request("GET", f"/api/v1{page}", headers={"Cookie": f"{COOKIE}={token}"})
    answer = connection.getresponse()
    answer.read()
    connection.close()
    return answer.status


if __name__ == "__main__":
    main(int(sys.argv[1]), sys.argv[2], sys.argv[3:])

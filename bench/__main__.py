"""`python -m bench`: prints each figure beside its target.

It exits with 0 whether targets are met or not, and with 1 when a part failed.
"""

import argparse
import json
import sys
import traceback
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from app.pipeline.compiled import IS_COMPILED
from bench.row import Row
from bench.tables import here, machine, page, tables


class Part(NamedTuple):
    """A part of the benchmark; its module is imported only when the part is chosen."""

    module: str
    function: str
    words: str


PARTS = {
    "chain": Part("bench.chain", "measure_chain_step", "a step from signals to the chair"),
    "gate": Part("bench.gate", "measure_gate", "a step of the safety gate"),
    "frame": Part("bench.frame", "measure_frame", "a frame to the real chair, encoded and verified"),
    "loop": Part("bench.loop", "measure_loop", "datagram in to datagram out"),
    "backup": Part("bench.beside_backup", "measure_beside_backup", "the loop beside a backup of 10 GB, and without"),
    "turn": Part("bench.turn", "measure_turn", "the parts of a turn of the loop"),
    "stop": Part("bench.web.stop", "measure_stop", "Stop on the tablet to the frame that stops a real chair"),
    "flood": Part("bench.web.busy", "measure_flood", "Stop on the tablet while 40 people sign in"),
    "pages": Part("bench.web.busy", "measure_first_pages", "Stop on the tablet while pages are opened first"),
    "records": Part("bench.web.busy", "measure_records", "Stop on the tablet while records are made and reviewed"),
    "slow": Part("bench.web.slow", "measure_slow_pages", "Stop on the tablet beside 200 pages that hardly read"),
    "review": Part("bench.web.review", "measure_review", "Stop, heartbeat and commands while somebody reviews trials"),
    "period": Part("bench.period", "measure_period", "how evenly a real chair is told, under load and junk"),
    "decode": Part("bench.chain", "measure_decode", "decoding a recording"),
    "fit": Part("bench.fit", "measure_fit", "fitting a calibration"),
    "study": Part("bench.study", "measure_study", "the paper's experiment without a screen"),
    "start": Part("bench.web.start", "measure_start", "from the command to its link or its help"),
    "session": Part("bench.web.session", "measure_session", "the web process's memory after a session, in Chromium"),
    "page": Part("bench.web.page", "measure_page", "from the address to a page that can be used, in Chromium"),
    "viewers": Part("bench.web.viewers", "measure_viewers", "the 3D view for one, four and eight"),
    "eye": Part("bench.web.eye", "measure_eye", "pictures a second of the eye's view, and of a plainer scene"),
    "tls": Part("bench.web.tls", "measure_tls", "what https costs viewers, and a first connection"),
    "report": Part("bench.report", "measure_reports", "a report of a session and of a course, as a file"),
    "exports": Part("bench.exports", "measure_exports", "10 min at 1 kHz x 52 in each format of export"),
    "trajectory": Part("bench.web.long_trajectory", "measure_trajectory", "a long trajectory against a short one"),
}


def main() -> None:
    """Measure how fast this machine does it, beside what is to be reached."""
    words = "; ".join(f"{name}: {part.words}" for name, part in PARTS.items())
    parser = argparse.ArgumentParser(prog="python -m bench", description=main.__doc__)
    parser.add_argument("parts", nargs="*", metavar="PART", help=f"What to measure, all of it when left out: {words}.")
    parser.add_argument("--json", action="store_true", help="Print one JSON object and nothing else.")
    parser.add_argument("--out", type=Path, help="Write the page of all parts here, as docs/speed.md.")
    given = parser.parse_args()
    if given.out and given.parts:
        parser.error("--out writes all parts: name none")
    chosen = given.parts or list(PARTS)
    for part in chosen:
        if part not in PARTS:
            parser.error(f"there is no part '{part}' to measure: use any of {', '.join(PARTS)}")
    measured = here()
    rows: list[Row] = []
    left_out: list[str] = []
    has_failed = False
    for part in chosen:
        module, function, words = PARTS[part]
        if not given.json:
            sys.stderr.write(f"{part}: {words} ...\n")
        try:
            rows += getattr(import_module(module), function)()
        except RuntimeError as error:  # for example without a browser: the other parts are measured all the same
            sys.stderr.write(f"{part} is not measured: {error}\n")
            left_out.append(part)
        except Exception:  # what the other parts have measured, perhaps for an hour, is not lost
            sys.stderr.write(f"{part} is not measured, because it failed:\n{traceback.format_exc()}")
            left_out.append(part)
            has_failed = True
    if given.json:
        sys.stdout.write(json.dumps({"machine": machine(), "rows": [document(row) for row in rows]}) + "\n")
    else:
        sys.stdout.write(f"{tables(rows)}{machine()}\n")
    if given.out:
        old = given.out.read_text(encoding="utf-8") if given.out.exists() else ""
        given.out.write_text(page(old, rows, measured, left_out, compiled=IS_COMPILED), encoding="utf-8")
    sys.exit(1 if has_failed else 0)


def document(row: Row) -> dict[str, Any]:
    """Return the row for JSON."""
    return {
        "what": row.what,
        "figure": row.figure,
        "runs": list(row.runs),
        "unit": row.unit,
        "reach": row.reach,
        "better": row.better,
        "details": row.details,
    }


if __name__ == "__main__":
    main()

"""D5: the program starts with a clock that is a month ahead; what was deleted before is not erased."""

import asyncio
import os
import tempfile
from contextlib import contextmanager
from pathlib import Path

from drills.results import Result
from processes.served_demo import OWNER, Served, printed_link, running_program

from folders import ROOT

FOLDER = Path(__file__).parent / "clock_ahead"
DAY = 86_400.0  # s
PATIENT = {"code": "P-1", "pseudonym": "Blue heron"}


async def clock_ahead(runs, dice):
    """Delete a patient, start the program with a clock that is 31 to 400 days ahead, and undo it."""
    result = Result("the clock is 31 to 400 days ahead at the next start", None)
    for _ in range(runs):
        with tempfile.TemporaryDirectory(prefix="bodydrive-drill-") as folder:
            await asyncio.to_thread(_one, Path(folder), dice.uniform(31.0, 400.0), result)
        result.add(None)
    result.remark = "the undo of a patient deleted before was taken, and the log said that the clock jumped"
    return result


def _one(folder, days, result):
    with _clinic(folder) as (client, code):
        _expect(result, client.post("/auth/setup", json={**OWNER, "code": code}), "the clinic was not made")
        patient = _expect(result, client.post("/patients", json=PATIENT), "the patient was not made").json()
        _expect(result, client.delete(f"/patients/{patient['id']}"), "the patient was not deleted")
    with _clinic(folder, PYTHONPATH=f"{FOLDER}{os.pathsep}{ROOT}", CLOCK_AHEAD=str(days * DAY)) as (client, _):
        _expect(result, client.post("/auth/sign-in", json=OWNER), "nobody could sign in")
        _expect(result, client.post(f"/patients/{patient['id']}/restore"), "the patient was erased")
        told = [row["what"] for row in client.get("/log").json()["entries"]]
        if "clock jumped" not in told:
            result.violated("the log does not say that the clock jumped")


def _expect(result, answer, words):
    """Return an answer; note a violation when it is a refusal."""
    if not answer.is_success:
        result.violated(f"{words}: {answer.status_code} {answer.text[:200]}")
    return answer


@contextmanager
def _clinic(folder, **environment):
    """Yield a client of the program that serves this clinic, and the code with which a new clinic is set up."""
    with running_program("serve", "--port", "0", "--state", str(folder / "clinic"), **environment) as process:
        base, _, code = printed_link(process).partition("/#setup=")
        with Served(process, base.rstrip("/")).client as client:
            yield client, code

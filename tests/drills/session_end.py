"""D3: the disk is full when a session ends; a whole clinic on a small disk that is filled while it records."""

import asyncio
import resource
import sqlite3
import tempfile
from contextlib import closing
from pathlib import Path

import psutil
from drills.results import Result
from processes.served_demo import Demo, until
from store.small_disk import fill, small_disk

from app.clock import monotonic
from app.recording.reader import read_run
from app.store.files.ballast import SIZE
from app.store.log_chain import verify_log

DISK = 640 << 20  # bytes: with less than 500 MB free nothing is recorded
TOLD = 2.0  # s
WHOLE_AGAIN = 5.0  # s for the ballast, once there is room
MOST_PATIENTS = 2000  # that may fit into the free pages of SQLite's files


async def session_end(runs, dice):
    """D3: fill the disk while a step of the calibration is recorded; then end the session and sign out."""
    result = Result("disk full at the end of a session", None)
    told, whole, mounted = [], [], True
    for _ in range(runs):
        with tempfile.TemporaryDirectory(prefix="bodydrive-drill-") as folder:
            mounted = await asyncio.to_thread(_one, Path(folder), dice, result, told, whole) and mounted
        result.add(None)
    result.remark = f"told after at most {1e3 * max(told):.0f} ms (limit {1e3 * TOLD:.0f}), what was written read; "
    if mounted:
        result.remark += f"session ended, signed out and in; the ballast whole {max(whole):.1f} s after there was room"
    else:
        result.remark += "no disk may be mounted here: files could grow no more, and the ballast was not tried"
    return result


def _one(folder, dice, result, told, whole):
    def expect(holds, words):
        if not holds:
            result.violated(f"{words}")

    with small_disk(folder / "disk", DISK) as disk, Demo.running(disk or folder) as demo:
        state = demo.state
        ballast = state / "bodydrive.sqlite.ballast"
        demo.client.post("/calibration/steps/rest/start")
        with demo.socket("live") as live:
            until(live, lambda m: m["run"] is not None and m["run"]["t"] > dice.uniform(0.6, 1.2))
            if disk is None:
                full = _limit(demo)
            else:
                expect(ballast.stat().st_size == SIZE, "there was no ballast")
                filler, full = fill(disk), monotonic()
                until(live, lambda m: m.get("news", {}).get("what") == "disk")
                words = demo.client.get("/equipment").json()["disk"]["message"]
                expect("is full" in words, f"the page was told '{words}'")
                told.append(monotonic() - full)
        refused = _fill_database(demo)
        expect(refused.status_code == 507 and "disk is full" in refused.text, f"a patient was added: {refused.text}")
        if disk is None:
            told.append(monotonic() - full)
        expect(told[-1] <= TOLD, f"told after {told[-1]:.1f} s")
        _read(state, expect)
        if disk is not None:
            _leave(demo, state, expect)
            filler.unlink()
            room = monotonic()
            while ballast.stat().st_size < SIZE and monotonic() - room < WHOLE_AGAIN:
                demo.client.get("/auth/me")
            whole.append(monotonic() - room)
            expect(ballast.stat().st_size == SIZE, "the ballast was not made again")
        return disk is not None


def _fill_database(demo):
    """Add patients until there is no room in SQLite's files either, and return the refusal."""
    session = str(demo.client.get("/session").json()["session"]["id"])  # asked once, because there are many patients
    for number in range(MOST_PATIENTS):
        patient = {"code": f"D-{number}", "pseudonym": "Heron", "note": "n" * 2000}
        answer = demo.client.post("/patients", json=patient, headers={"Patient-Session": session})
        if answer.status_code != 201:
            break
    return answer


def _leave(demo, state, expect):
    """End the step, unless the full disk has ended it, and the session; sign out, and come in again."""
    cancel = demo.client.post("/calibration/steps/rest/cancel")
    expect(cancel.status_code in {200, 409}, f"the step could not be ended: {cancel.text}")
    answers = [demo.client.delete("/session"), demo.client.post("/auth/sign-out")]
    expect(not demo.client.get("/auth/me").json()["signed_in"], "still signed in")
    answers.append(demo.client.post("/auth/demo", json={"code": demo.code}))
    answers.append(demo.client.get("/session"))
    for answer in answers:
        expect(answer.status_code == 200, f"{answer.request.method} {answer.request.url.path}: {answer.text}")
    expect(answers[-1].json()["patient"] is None, "the session goes on")
    with closing(sqlite3.connect(state / "bodydrive.sqlite")) as connection:
        for table in ("session", "run"):
            left = connection.execute(f"SELECT COUNT(*) FROM {table} WHERE ended IS NULL").fetchone()[0]
            expect(left == 0, f"a {table} was left open")


def _read(state, expect):
    with closing(sqlite3.connect(state / "bodydrive.sqlite")) as connection:
        expect(connection.execute("PRAGMA integrity_check").fetchone()[0] == "ok", "the database is damaged")
    expect(verify_log(state / "bodydrive.sqlite").whole, "the log raised an alarm")
    for run in (state / "runs").iterdir():
        expect(read_run(run).rows > 0, "the recording cannot be read")


def _limit(demo):
    """Forbid the clinic's processes to grow files, and return the time."""
    for process in (psutil.Process(demo.process.pid), demo.control_process()):
        process.rlimit(psutil.RLIMIT_FSIZE, (1, resource.RLIM_INFINITY))
    return monotonic()

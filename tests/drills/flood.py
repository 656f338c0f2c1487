"""The drill of a flood of sign-ins: Stop on the tablet, while the chair drives and 40 people sign in."""

import asyncio
import http.client
import subprocess
import sys

from drills.results import Result, waited
from drills.rig import AFTER, rig
from processes.served_demo import environment

from app.clock import monotonic

SIGN_INS = 40
LIMIT = 0.1 + 0.02 + 0.02  # s: S6 of a tablet, a command, a step of the receiver and its line


async def sign_ins(runs, dice):
    """S6, C24: Stop while 40 people sign in at once, again and again."""
    result = Result(f"Stop on the tablet while {SIGN_INS} people sign in", LIMIT, LIMIT)
    answers = ""
    async with rig(controlled=False) as made:
        for _ in range(runs):
            web, port = await made.start_served_web()
            flood = await asyncio.create_subprocess_exec(
                *(sys.executable, "-m", "bench.processes.sign_ins", str(port), str(SIGN_INS)),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                env=environment(),
            )
            await _ask(flood, b"on")
            await asyncio.sleep(dice.uniform(0.5, 0.8))
            answers = (await _ask(flood, b"on")).strip()
            if made.receiver.newest["v"] <= 0:
                result.violated("the chair did not drive")
            stopped, before = monotonic(), waited(web.pid)
            await asyncio.to_thread(_stop, port)
            await asyncio.sleep(AFTER)
            begun, disarmed = made.chair_stopped(stopped)
            # Stop goes through the web process, and then through two others that wait as the watcher does.
            late = made.watcher.late(stopped, stopped + AFTER) + waited(web.pid) - before
            if begun is None or made.went_on(stopped, begun):
                result.violated("the chair went on")
            result.add(begun, disarmed, late)
            for process in (flood, web):
                process.kill()
                await process.wait()
    result.remark = f"from POST /control/stop; answers to the sign-ins before it, by status: {answers}"
    return result


async def _ask(flood, word):
    flood.stdin.write(word + b"\n")
    return (await flood.stdout.readline()).decode()


def _stop(port):
    connection = http.client.HTTPConnection("127.0.0.1", port, timeout=5.0)
    connection.request("POST", "/api/v1/control/stop")
    assert connection.getresponse().status == http.client.OK
    connection.close()

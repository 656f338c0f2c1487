"""Stands in for a web process that is killed: starts a control process, arms a chair, beats until it is dead.

Argument: a JSON object with the shirt's configuration; optional are a real chair's (`chair`), the folder of a recording
(`folder`) and the port of the virtual chair's report (`report`). Prints the number of its control process, then `armed`
when the chair may move.
"""

import asyncio
import json
import sys
from contextlib import suppress

from processes.running_control import beat

from app.faults import State
from app.process.command_channel import LinkRefused
from app.process.supervisor import ControlProcess
from app.refusals import Refusal
from building import make_parameters


def say(what):
    sys.stdout.write(f"{what}\n")
    sys.stdout.flush()


async def arms(control, parameters):
    """Arm the chair, again after a fault on a busy machine."""
    while True:
        tick = control.newest()
        state = None if tick is None else State(int(tick["state"]))
        if state is State.ARMED:
            return
        with suppress(LinkRefused, Refusal):
            if state is State.FAULT:
                await control.call("clear", stops=int(tick["stops"]))
            elif state is State.DISARMED and tick["has_frame"]:
                await control.call("arm", hash=parameters.hash)
        await asyncio.sleep(0.05)


async def main(shirt, chair=None, folder=None, report=None, **_):
    parameters = make_parameters()
    control = await ControlProcess.start(*(["--report", f"127.0.0.1:{report}"] if report else []))
    say(control.pid)
    heart = asyncio.create_task(beat(control))
    await control.call("shirt", config=shirt)
    await control.call("parameters", parameters=parameters.model_dump(mode="json"))
    if chair:
        await control.call("chair", config=chair)
        await control.call("run", run_id="w", folder=folder, kind="drive", cues=[], meta={})
    await arms(control, parameters)
    say("armed")
    await heart


if __name__ == "__main__":
    asyncio.run(main(**json.loads(sys.argv[1])))

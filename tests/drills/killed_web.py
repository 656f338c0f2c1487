"""Stands in for a web process that is killed: starts a control process, arms a real chair, beats until it is dead.

Argument: a JSON object with the shirt's and the chair's configuration and the folder of the recording.
"""

import asyncio
import json
import sys
from contextlib import suppress

from app.faults import State
from app.process.command_channel import LinkRefused
from app.process.supervisor import ControlProcess
from building import make_parameters


async def main(given):
    parameters = make_parameters()
    control = await ControlProcess.start()
    heart = asyncio.create_task(beat(control))
    await control.call("shirt", config=given["shirt"])
    await control.call("parameters", parameters=parameters.model_dump(mode="json"))
    await control.call("chair", config=given["chair"])
    await control.call("run", run_id="w", folder=given["folder"], kind="drive", cues=[], meta={})
    said = False
    while True:
        tick = control.newest()
        if not said and tick is not None:
            with suppress(LinkRefused):
                if tick["state"] == State.FAULT:
                    await control.call("clear", stops=int(tick["stops"]))
                elif tick["state"] == State.DISARMED:
                    await control.call("arm", hash=parameters.hash)
            said = tick["state"] == State.ARMED
            if said:
                sys.stdout.write("armed\n")
                sys.stdout.flush()
        await asyncio.sleep(0.05)
    await heart


async def beat(control):
    while True:
        control.send("heartbeat", screen_age=0.0)
        await asyncio.sleep(0.05)


asyncio.run(main(json.loads(sys.argv[1])))

"""Stands in for the web process, to be killed: starts the control process, arms the chair, sends heartbeats.

Arguments: the folder of the tests, the shirt's port, the report's port. Says its control process's number on stdout,
then `armed` when the chair may move.
"""

import asyncio
import sys

sys.path.insert(0, sys.argv[1])

from processes.udp_shirt import shirt_config

from app.faults import State
from app.process.supervisor import ControlProcess
from building import make_parameters


def say(what):
    sys.stdout.write(f"{what}\n")
    sys.stdout.flush()


async def main():
    shirt_port, report_port = sys.argv[2:4]
    parameters = make_parameters()
    control = await ControlProcess.start("--report", f"127.0.0.1:{report_port}")
    say(control.pid)
    await control.call("shirt", config=shirt_config(parameters, int(shirt_port)))
    answer = await control.call("parameters", parameters=parameters.model_dump(mode="json"))
    said = False
    while True:
        control.send("heartbeat", screen_age=0.0)
        tick = control.newest()
        state = State.DISARMED if tick is None else State(int(tick["state"]))
        if not said and state is State.FAULT:  # a busy machine caused a fault
            await control.call("clear", stops=int(tick["stops"]))
        elif not said and state is State.DISARMED and tick is not None and tick["has_frame"]:
            await control.call("arm", hash=answer["hash"])
        elif not said and state is State.ARMED:
            said = True
            say("armed")
        await asyncio.sleep(0.05)


asyncio.run(main())

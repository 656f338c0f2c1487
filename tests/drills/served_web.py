"""The real web process of a drill: serves the application, whose control process arms a real chair and keeps it armed.

Argument: a JSON object with the shirt's and the chair's configuration, the folder of the recording, and one for the
application's own state. Prints `open PORT` when the chair is open, PORT being the one that it serves, `pressed` when
the chair's stop switch was seen pressed, and, when it was let go of, `armed` as soon as the chair may move.
"""

import asyncio
import json
import sys
from pathlib import Path

import uvicorn
from processes.running_control import tick_with
from processes.web_stand_in import arms, say

from app.api.app import create_app
from app.api.parts import parts_of
from app.cli.port import bind
from app.computing_process import ComputingProcess
from app.process.supervisor import ControlProcess
from app.realtime import collect_garbage
from app.session.control_link import ControlLink, ScreenSign
from app.settings import Settings
from building import make_parameters


async def main(given):
    with bind("127.0.0.1", 0) as listening:
        port = listening.getsockname()[1]
        app = create_app(Settings(state=Path(given["state"]), port=port), ControlProcess.start, ComputingProcess())
        server = uvicorn.Server(uvicorn.Config(app, log_level="error", lifespan="on"))
        serving = asyncio.create_task(server.serve([listening]))
        while not server.started:
            await asyncio.sleep(0.01)
        collect_garbage()
        control = parts_of(app)[ControlLink]
        control.follow_screen(lambda: ScreenSign(0.0))  # a screen that is always in view
        parameters = make_parameters()
        await control.call("shirt", config=given["shirt"])
        await control.call("parameters", parameters=parameters.model_dump(mode="json"))
        await control.call("chair", config=given["chair"])
        say(f"open {port}")
        await tick_with(control, lambda tick: tick["stop_input"] == 1)
        say("pressed")
        await tick_with(control, lambda tick: tick["stop_input"] == 0 and tick["chair_state"] == 0)
        await control.call("run", run_id="w", folder=given["folder"], kind="drive", cues=[], meta={})
        await arms(control, parameters)
        say("armed")
        await serving


asyncio.run(main(json.loads(sys.argv[1])))

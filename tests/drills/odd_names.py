"""The drill of odd names of equipment, typed while the chair drives."""

import asyncio
from contextlib import suppress

from drills.injury import look_whether_it_drives
from drills.results import Result
from drills.rig import PARAMETERS, rig
from odd_values import odd_values
from processes.running_control import tick_with

from app.clock import monotonic
from app.process.command_channel import LinkRefused

WHILE_DRIVING, WHILE_STANDING = 40, 20  # odd values in a run
LONGEST_GAP = 0.04  # s between two commands to the chair (S14)


async def odd_names(runs, dice):
    """S28: somebody types odd addresses, paths and names while the chair drives, and while it stands."""
    result = Result("odd equipment names while the chair drives", None)
    asked, longest = 0, 0.0
    async with rig() as made:
        for _ in range(runs):
            await made.cruise()
            began = monotonic()
            for value in dice.sample(odd_values(), WHILE_DRIVING):
                asked += await _ask_oddly(made, value)
            await asyncio.sleep(0.1)
            late = made.watcher.late(began, monotonic())
            gap = made.relay.longest_gap(began)
            longest = max(longest, gap)
            look_whether_it_drives(made, result, late)
            if gap > LONGEST_GAP + late:
                result.violated(f"{1e3 * gap:.0f} ms between two commands")
            result.add(None, late=late)
            await made.control.call("end_run")
            for value in dice.sample(odd_values(), WHILE_STANDING):
                asked += await _ask_oddly(made, value)
            await made.control.call("shirt", config=made.shirt_config)
            await made.control.call("parameters", parameters=PARAMETERS.model_dump(mode="json"))
            await tick_with(made.control, lambda tick: tick["has_frame"] and tick["chair_age"] < 0.3)
            await made.show_switch()
            await made.begin_run()
        # The control process was not restarted: a new one would have ended the rig's control link with LinkLost.
    result.remark = f"{asked} commands, no restart; longest time between two commands {1e3 * longest:.0f} ms (limit 40)"
    return result


async def _ask_oddly(made, value):
    """Choose equipment with this text in every text field; return the number of commands."""
    layout = made.shirt_config["layout"]
    commands = [
        ("shirt", {"kind": "udp", "host": value, "port": 0, "layout": layout}),
        ("shirt", {"kind": "replay", "file": value}),
        ("shirt", {"kind": "serial", "device": value, "layout": layout}),
        ("shirt", {"kind": "slimevr", "host": value, "port": 0}),
        ("shirt", {"kind": "phones", "trunk": value}),
        ("shirt", {"kind": "bluetooth", "trunk": value}),
        ("shirt", {"kind": "brainflow", "board": value}),
        ("shirt", {"kind": "udp", "port": 0, "layout": {**layout, "name": value}, "key_file": value}),
        ("body", {"kind": "recorded", "file": value}),
        ("head", {"kind": "opentrack", "host": value, "port": 0}),
        ("head", {"kind": "flock_of_birds", "device": value}),
        ("chair", made.receiver.config(host=value)),
        ("chair", made.receiver.config(key_file=value)),
        ("chair", made.receiver.config(port=made.relay.port)),  # the rig's own chair again
    ]
    for do, config in commands:
        with suppress(LinkRefused):
            await made.control.call(do, config=config)
    return len(commands)

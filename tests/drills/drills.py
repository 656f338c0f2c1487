"""The table of the drills: the faults injected while a chair drives, and the number of runs."""

import asyncio
import random

from drills.clock_ahead_start import clock_ahead
from drills.connections import silent_connections, uploads_of_nobody
from drills.flood import sign_ins
from drills.large_plans import large_plan
from drills.machine import disk_full, wall_clock
from drills.network_cuts import cuts
from drills.network_faults import forgeries, recorded_switch, weather
from drills.odd_names import odd_names
from drills.output_faults import output_faults, stop_at_outputs
from drills.processes import hold_control, kill_control, kill_receiver, kill_web, web_silent
from drills.results import Result
from drills.schedules import schedules
from drills.second_sender import second_sender
from drills.second_socket import second_socket
from drills.session_end import session_end
from drills.shirt import loose_connector, sensors_break, sensors_stick, shirt_kept_back, shirt_stalls
from drills.stops import SCREENS, chair_switch, screen_gone, tablet_stop
from drills.uploads import upload_bombs

DRILLS = {
    "cuts": (cuts, 1000, 4),
    "kill-control": (kill_control, 100, 1),
    "hold-control": (hold_control, 100, 1),
    "kill-receiver": (kill_receiver, 100, 1),
    "kill-web": (kill_web, 100, 1),
    "web-silent": (web_silent, 100, 1),
    "screen": (screen_gone, 100, len(SCREENS)),
    "second-socket": (second_socket, 20, 1),
    "stop": (tablet_stop, 100, 1),
    "sign-ins": (sign_ins, 30, 1),
    "switch": (chair_switch, 100, 1),
    "outputs": (output_faults, 500, 4),
    "outputs-stop": (stop_at_outputs, 400, 4),
    "shirt": (shirt_stalls, 50, 1),
    "kept-back": (shirt_kept_back, 20, 1),
    "sensors": (sensors_break, 60, 3),
    "stuck": (sensors_stick, 20, 1),
    "loose": (loose_connector, 20, 1),
    "disk": (disk_full, 20, 1),
    "disk-end": (session_end, 10, 1),
    "weather": (weather, 60, 1),
    "forgeries": (forgeries, 20, 1),
    "recorded-switch": (recorded_switch, 10, 2),
    "schedules": (schedules, 500, 3),
    "clock": (wall_clock, 20, 1),
    "clock-ahead": (clock_ahead, 10, 1),
    "names": (odd_names, 20, 1),
    "second-sender": (second_sender, 20, 1),
    "uploads": (upload_bombs, 34, 2),
    "large-plan": (large_plan, 60, 4),
    "connections": (silent_connections, 15, 3),
    "nobody": (uploads_of_nobody, 5, 1),
}
"""Name of a drill: the drill, its number of runs in full, its number of runs in the short form."""


def run_drill(name, runs, seed):
    """Run one drill in this process; return its result, with a violation when the drill itself fails."""
    drill, *_ = DRILLS[name]
    try:
        return asyncio.run(drill(runs, random.Random(seed)))
    except Exception as error:  # the other drills continue, and their rows are kept
        ended = Result(f"{name}: the drill ended early", None)
        ended.violations.append(f"{type(error).__name__}: {error}")
        return ended

"""The end of the control process on a fake clock: when the web process has gone, the chair is brought to its stop."""

from itertools import pairwise

import pytest
from pipeline.commanded_loop import CommandedLoop
from pipeline.scripted_shirt import ScriptedShirt

from app.faults import Fault, State
from app.pipeline.process import _come_to_a_stop, _run_until_quit
from app.process.command_channel import CommandServer
from building import make_signals

LONGEST_GAP = 0.04  # s between two commands, as promised
SECONDS = 20


@pytest.fixture
def driving():
    """A loop whose chair moves."""
    made = CommandedLoop()
    layout = made.parameters.profile.layout
    signals = make_signals(made.parameters, 100 * SECONDS, strokes=True)
    made.setup.shirt = ScriptedShirt(made.clock, [i / 100 for i in range(100 * SECONDS)], signals, layout=layout)
    made.live(0.1)
    made.done("arm", hash=made.parameters.hash)
    while made.clock.now() < SECONDS / 2 and made.setup.chair.state.v < 0.2:
        made.live(0.01)
    assert made.setup.chair.state.v >= 0.2
    yield made
    made.close()


def test_when_the_web_process_has_gone_the_chair_stands_in_time_and_no_command_is_left_out(driving):
    """Safety S14: each tick tells the chair, and there is one at least every 40 ms until it stands."""
    last, gone = driving.ring.number, driving.clock.now()
    driving._ours.close()
    server = driving.commands._server
    assert isinstance(server, CommandServer)
    _run_until_quit(driving.loop, driving.commands, server, driving.clock)
    _come_to_a_stop(driving.loop, driving.clock)
    ticks, _ = driving.ring.since(last)
    times = [gone, *ticks["t"].tolist()]
    assert max(after - before for before, after in pairwise(times)) <= LONGEST_GAP
    assert (State(int(ticks["state"][-1])), Fault(int(ticks["fault"][-1]))) == (State.FAULT, Fault.WEB_SILENT)
    assert driving.setup.chair.state.v == 0.0
    assert driving.clock.now() - gone <= 0.35

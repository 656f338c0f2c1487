"""The web process is killed or suspended: the virtual chair stops while the simulated body moves on."""

import json
import signal
import socket
import subprocess
import sys
from itertools import pairwise
from typing import NamedTuple

import psutil
import pytest
from processes.served_demo import environment
from processes.udp_shirt import UdpShirtSender, free_port, shirt_config

from app.clock import monotonic
from app.faults import State
from app.hardware.chair.report import REPORT
from building import make_parameters

HEARTBEAT_LIMIT = 0.3  # s
STOP_TIME = 0.25  # s
A_TICK_OR_TWO = 0.05  # s
PATIENCE = 60.0  # s


class Report(NamedTuple):
    """A report of the virtual chair."""

    t: float
    state: State
    v: float


class Reports:
    """Receives the reports of a control process."""

    def __init__(self):
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
        self._socket.bind(("127.0.0.1", 0))
        self.port = self._socket.getsockname()[1]

    def wait_for(self, condition):
        """Return the first report that fulfils the condition."""
        self._socket.settimeout(PATIENCE)
        until = monotonic() + PATIENCE
        while monotonic() < until:
            report = self._parsed(self._socket.recv(100))
            if condition(report):
                return report
        raise AssertionError(f"the chair did not get there within {PATIENCE:g} s")

    def during(self, seconds):
        """Return the waiting reports, and those of the next seconds."""
        found = []
        until = monotonic() + seconds
        while (left := until - monotonic()) > 0:
            self._socket.settimeout(left)
            try:
                found.append(self._parsed(self._socket.recv(100)))
            except TimeoutError:
                break
        return found

    def close(self):
        self._socket.close()

    def _parsed(self, datagram):
        magic, version, state, _, _, ns, _, _, _, v, _, _ = REPORT.unpack(datagram)
        assert (magic, version) == (b"BMIP", 1)
        return Report(ns * 1e-9, State(state), v)


class Drive(NamedTuple):
    """A chair that cruises after a stroke."""

    web: subprocess.Popen
    control: psutil.Process
    reports: Reports


@pytest.fixture
def drive():
    parameters = make_parameters()
    reports = Reports()
    port = free_port()
    given = json.dumps({"shirt": shirt_config(parameters, port), "report": reports.port})
    command = [sys.executable, "-m", "processes.web_stand_in", given]
    web = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment())
    shirt = UdpShirtSender(parameters, port)
    control = None
    try:
        control = psutil.Process(int(web.stdout.readline()))
        assert web.stdout.readline().startswith("armed")
        shirt.stroke()
        reports.wait_for(lambda report: report.state is State.ARMED and report.v > 0.2)
        yield Drive(web, control, reports)
    finally:
        shirt.close()
        web.kill()
        web.communicate()
        if control is not None:
            control.wait(PATIENCE)
        reports.close()


def test_the_web_process_is_killed_and_the_chair_stands_within_350_ms(drive):
    killed = monotonic()
    drive.web.send_signal(signal.SIGKILL)
    reports = [report for report in drive.reports.during(1.0) if report.t > killed]
    late = [report for report in reports if report.t > killed + 0.35]
    assert all(report.v == 0.0 for report in late)
    assert reports[-1].v == 0.0
    assert reports[-1].state is State.FAULT
    speeds = [report.v for report in reports if report.state is State.FAULT]
    assert speeds == sorted(speeds, reverse=True)
    drive.control.wait(PATIENCE)  # the control process ends by itself


def test_the_web_process_is_held_and_the_chair_stands_after_the_heartbeat_s_limit(drive):
    held = monotonic()
    drive.web.send_signal(signal.SIGSTOP)
    try:
        reports = [report for report in drive.reports.during(1.2) if report.t > held]
    finally:
        drive.web.send_signal(signal.SIGCONT)
    moved_on = [report for report in reports if report.state is State.ARMED]
    assert moved_on
    assert moved_on[-1].t <= held + HEARTBEAT_LIMIT + A_TICK_OR_TWO
    assert all(report.v == 0.0 for report in reports if report.t > held + HEARTBEAT_LIMIT + STOP_TIME + A_TICK_OR_TWO)
    # The ring's reader is suspended too, and the loop does not wait for it.
    gaps = [after.t - before.t for before, after in pairwise(reports)]
    assert max(gaps) < HEARTBEAT_LIMIT
    assert len(reports) > 60

"""A recorder that is killed loses no row that it has acknowledged."""

import math
import random
import signal
import subprocess
import sys
import threading

import pytest
from recording.test_recording import assert_rows_begin

from app.recording.reader import read_run
from folders import ROOT

TURNS = 2  # of each seed: 200 in all, most of them in `make drills`
LONGEST = 0.6  # s until the kill: longer than the recorder takes from one fsync to the next

KILLED = """
import sys, uuid
from pathlib import Path
sys.path[:0] = sys.argv[2:]
from recording.test_recording import CHANNELS, GESTURES, META, write_ticks
from app.recording.writer import RunWriter
from app.process.ring import TickRing

ring = TickRing.create(f"bodydrive-test-{uuid.uuid4().hex}")
ring.unlink()
writer = RunWriter(Path(sys.argv[1]), META, CHANNELS, GESTURES)
synced = writer._sync
def sync_and_say():
    synced()
    print(writer.rows, flush=True)
writer._sync = sync_and_say
writer.start(ring, 0, 1)
i = 0
while True:
    write_ticks(ring, 20, first=i)
    i += 20
    writer._wake.wait(0.002)
"""


@pytest.mark.parametrize("seed", [0, *(pytest.param(seed, marks=pytest.mark.long) for seed in range(1, 100))])
def test_killed_while_it_writes_no_acknowledged_row_is_lost(tmp_path, seed):
    moments = random.Random(seed)
    for turn in range(TURNS):
        folder = tmp_path / f"run{turn}"
        paths = [str(ROOT / "tests")]
        process = subprocess.Popen([sys.executable, "-c", KILLED, str(folder), *paths], stdout=subprocess.PIPE)
        try:
            acknowledged = [process.stdout.readline() for _ in range(2)]
            threading.Event().wait(moments.uniform(0.0, LONGEST))
        finally:
            process.send_signal(signal.SIGKILL)
            acknowledged += process.communicate()[0].splitlines(keepends=True)
        last = int([line for line in acknowledged if line.endswith(b"\n")][-1])
        run = read_run(folder)
        assert run.rows >= last
        assert_rows_begin(run, math.inf)
        assert str(run.damage) == "The recording was cut: what had been written by then is here."

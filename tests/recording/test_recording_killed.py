"""A recorder that is killed loses no row that it has acknowledged."""

import math
import signal
import subprocess
import sys

from recording.test_recording import assert_rows_begin

from app.recording.reader import read_run
from folders import ROOT

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
    rows = writer.rows
    synced()
    print(rows, flush=True)
writer._sync = sync_and_say
writer.start(ring, 0, 1)
i = 0
while True:
    write_ticks(ring, 20, first=i)
    i += 20
    writer._wake.wait(0.002)
"""


def test_killed_while_it_writes_no_acknowledged_row_is_lost(tmp_path):
    for turn in range(2):
        folder = tmp_path / f"run{turn}"
        paths = [str(ROOT / "tests")]
        process = subprocess.Popen([sys.executable, "-c", KILLED, str(folder), *paths], stdout=subprocess.PIPE)
        try:
            acknowledged = [int(process.stdout.readline()) for _ in range(3)]
        finally:
            process.send_signal(signal.SIGKILL)
            process.communicate()
        run = read_run(folder)
        assert run.rows >= acknowledged[-1] > 0
        assert_rows_begin(run, math.inf)
        assert run.damage == "The recording was cut: what had been written by then is here."

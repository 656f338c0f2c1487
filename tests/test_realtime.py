"""Requests to the machine: their result is reported, and the other threads keep ordinary scheduling."""

import json
import os
import platform
import subprocess
import sys

import pytest

from app.hardware.chair.receive import REAL_TIME
from app.texts import Text

CODE = """
import gc, json, os, resource, sys, threading
import app.realtime

if "refused" in sys.argv:
    resource.setrlimit(resource.RLIMIT_MEMLOCK, (0, 0))
    os.setuid(65534)
texts = app.realtime.go_real_time()
policies = {}
def note(name):
    policies[name] = os.sched_getscheduler(0) & ~os.SCHED_RESET_ON_FORK
note("loop")
thread = threading.Thread(target=note, args=("thread",))
thread.start()
thread.join()
print(json.dumps({"texts": texts, "gc": gc.isenabled(), "frozen": gc.get_freeze_count(), "policies": policies,
                  "names": {"fifo": os.SCHED_FIFO, "other": os.SCHED_OTHER}}))
"""

# Eight threads take memory at once. Then the areas beside the first one are counted: they begin at multiples of 64 MiB.
AREAS = """
import re, sys, threading
import app.realtime

if "shared" in sys.argv:
    app.realtime.share_memory_areas()
there = threading.Barrier(8)
kept = []
def take():
    there.wait()
    kept.append([bytes(2000) for _ in range(1000)])
    there.wait()
threads = [threading.Thread(target=take) for _ in range(8)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
starts = re.findall(r"^([0-9a-f]+)-[0-9a-f]+ rw-p 0+ 00:00 0 *$", open("/proc/self/maps").read(), re.M)
print(sum(int(start, 16) % 2**26 == 0 for start in starts))
"""


def told(*arguments):
    run = subprocess.run([sys.executable, "-c", CODE, *arguments], capture_output=True, text=True, check=True)
    return json.loads(run.stdout)


@pytest.mark.skipif(sys.platform != "linux", reason="Only Linux is asked for real-time scheduling.")
def test_what_is_granted_is_said_and_only_the_loop_has_it():
    found = told()
    granted = found["policies"]["loop"] == found["names"]["fifo"]
    assert found["texts"][0] == ("realtime-granted" if granted else "realtime-refused")
    assert found["policies"]["thread"] == found["names"]["other"]
    assert not found["gc"]
    assert found["frozen"] > 1000


@pytest.mark.skipif(sys.platform != "linux", reason="Only Linux is asked for real-time scheduling.")
def test_without_the_right_to_it_the_loop_goes_on_and_says_so():
    if os.geteuid() != 0:
        pytest.skip("Only root can give its rights away, and this test does not run as root.")
    found = told("refused")
    assert found["texts"] == ["realtime-refused", "realtime-memory-refused"]
    assert found["policies"]["loop"] == found["names"]["other"]


@pytest.mark.skipif(not platform.libc_ver()[0], reason="Only glibc has areas of memory.")
def test_all_threads_share_two_areas_of_memory():
    beside_the_first = [
        int(subprocess.run([sys.executable, "-c", AREAS, word], capture_output=True, text=True, check=True).stdout)
        for word in ("each", "shared")
    ]
    assert beside_the_first[0] > 1
    assert beside_the_first[1] <= 1


def test_the_receiver_of_a_chair_says_what_the_catalogue_says():
    assert {message: str(Text(message)) for message in REAL_TIME} == REAL_TIME

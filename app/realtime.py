"""Asks the machine for what keeps the loop on time, and says in words what it granted."""

import ctypes
import gc
import os
import resource
import sys

LOOP_PRIORITY = 10  # of SCHED_FIFO: above every ordinary program, below the kernel's own threads
RECORDER_PRIORITY = 5  # below the loop, above what could hold it up while it has the interpreter that the loop wants
NICENESS = 10  # of nice: a tenth of the time of an ordinary process that wants the same core
SWITCH_INTERVAL = 1e-4  # s: how long the recorder may hold the interpreter when the loop wants it
MCL_CURRENT, MCL_FUTURE, MCL_ONFAULT = 1, 2, 4
LOCK = MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT  # what is in use stays; reserved but untouched memory is not filled


def go_real_time() -> list[str]:
    """Take real-time scheduling for this thread, lock the memory, freeze the garbage collector; return sentences.

    What is not granted is done without.
    """
    sys.setswitchinterval(SWITCH_INTERVAL)
    words = [_take_loop_priority(), _lock_memory()]
    gc.collect()
    gc.freeze()
    gc.disable()  # `collect_garbage` collects at moments when nothing moves
    return words


def collect_garbage() -> None:
    """Collect garbage; to be called only while the chair stands."""
    gc.collect()
    gc.freeze()


def take_priority(priority: int) -> bool:
    """Give the calling thread, not those it starts, real-time scheduling of this priority; return whether it was had.

    Priority 0 is ordinary scheduling.
    """
    if not hasattr(os, "SCHED_FIFO"):
        return False
    try:
        if priority:
            os.sched_setscheduler(0, os.SCHED_FIFO | os.SCHED_RESET_ON_FORK, os.sched_param(priority))
        else:
            os.sched_setscheduler(0, os.SCHED_OTHER | os.SCHED_RESET_ON_FORK, os.sched_param(0))
    except OSError:
        return False
    return True


def lower_priority() -> None:
    """Let ordinary processes run before this one."""
    os.nice(NICENESS)


def _take_loop_priority() -> str:
    if take_priority(LOOP_PRIORITY):
        return "The control loop has real-time scheduling."
    return "Real-time scheduling was not granted: close other programs while driving."


def _lock_memory() -> str:
    refused = "Memory is not locked: a machine short of memory may delay the control loop."
    if sys.platform != "linux":
        return refused
    limit, _ = resource.getrlimit(resource.RLIMIT_MEMLOCK)
    if os.geteuid() != 0 and limit != resource.RLIM_INFINITY:
        return refused  # a lock that is granted up to a limit makes later allocations fail
    if ctypes.CDLL(None, use_errno=True).mlockall(LOCK) != 0:
        return refused
    return "The control loop's memory is locked."

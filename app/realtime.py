"""Requests real-time scheduling and locked memory for the control loop, and reports what was granted.

It also keeps a process of many threads small, and frees memory at moments when no chair moves.
"""

import ctypes
import gc
import os
import resource
import sys
from collections.abc import Callable

LOOP_PRIORITY = 10  # of SCHED_FIFO: above every ordinary program, below the kernel's own threads
RECORDER_PRIORITY = 5  # below the loop, above programs that could preempt the recorder while it holds the interpreter
LOWEST_NICENESS = 19
IDLE_DISK_CLASS = 3 << 13  # of ioprio_set: served when nobody else wants the disk
IOPRIO_SET = {"x86_64": 251, "aarch64": 30, "armv7l": 314}  # numbers of the system call
SWITCH_INTERVAL = 1e-4  # s for which the recorder may hold the interpreter when the loop needs it
M_ARENA_MAX = -8  # mallopt(3)
AREAS = 2  # of memory, for all threads
SELDOM = 50_000  # new objects until the interpreter collects garbage, while many are made and few are garbage
USUAL = gc.get_threshold()
MCL_CURRENT, MCL_FUTURE, MCL_ONFAULT = 1, 2, 4
LOCK = MCL_CURRENT | MCL_FUTURE | MCL_ONFAULT  # lock pages when they are first used, not when they are reserved


def go_real_time() -> list[str]:
    """Request real-time scheduling for this thread, lock the memory, freeze the garbage collector.

    Returns the id of a message (app/texts.py) on each request: granted or not. The receiver of a chair, which runs with
    the standard library alone, uses this module, so that it makes no text. The program goes on without what is not
    granted.
    """
    sys.setswitchinterval(SWITCH_INTERVAL)
    sentences = [_take_loop_priority(), _lock_memory()]
    gc.collect()
    gc.freeze()
    gc.disable()  # `collect_garbage` is called at moments when nothing moves
    return sentences


def collect_seldom() -> None:
    """Collect garbage seldom, until `collect_garbage`: a start makes many objects and little garbage."""
    gc.set_threshold(SELDOM)


def collect_garbage() -> None:
    """Collect garbage; call this only while the chair stands."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(*USUAL)


def share_memory_areas() -> None:
    """Let all threads of this process share two areas of memory; call this before there are threads.

    glibc gives up to eight areas to each processor. What is freed in an area is used again only there, so that a web
    process, whose requests run in any of many threads, grew with each session. Other C libraries are left to
    themselves.
    """
    if (mallopt := _of_glibc("mallopt")) is not None:
        mallopt(M_ARENA_MAX, AREAS)


def return_memory() -> None:
    """Free what a session has left, and return it to the system; call this only while the chair stands.

    glibc keeps freed memory for its own use. Other C libraries are left to themselves.
    """
    gc.collect()
    if (trim := _of_glibc("malloc_trim")) is not None:
        trim(0)


def _of_glibc(name: str) -> Callable[..., int] | None:
    return getattr(ctypes.CDLL(None), name, None) if sys.platform == "linux" else None


def take_priority(priority: int) -> bool:
    """Request real-time scheduling of this priority for the calling thread only; return whether it was granted.

    Priority 0 requests ordinary scheduling. Threads started later do not inherit the priority.
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


def take_lowest_priority() -> None:
    """Let this process run, and use the disk, only when no other process wants to."""
    os.nice(LOWEST_NICENESS)
    if hasattr(os, "SCHED_IDLE"):
        os.sched_setscheduler(0, os.SCHED_IDLE, os.sched_param(0))
    number = IOPRIO_SET.get(os.uname().machine)
    if sys.platform == "linux" and number is not None:
        ctypes.CDLL(None, use_errno=True).syscall(number, 1, 0, IDLE_DISK_CLASS)  # 1: a process, 0: this one


def _take_loop_priority() -> str:
    if take_priority(LOOP_PRIORITY):
        return "realtime-granted"
    return "realtime-refused"


def _lock_memory() -> str:
    refused = "realtime-memory-refused"
    if sys.platform != "linux":
        return refused
    limit, _ = resource.getrlimit(resource.RLIMIT_MEMLOCK)
    if os.geteuid() != 0 and limit != resource.RLIM_INFINITY:
        return refused  # with a limit, allocations beyond it would fail later
    if ctypes.CDLL(None, use_errno=True).mlockall(LOCK) != 0:
        return refused
    return "realtime-memory-locked"

"""Drills of the pages' connections: a thousand that do nothing, and files that nobody may send."""

import asyncio
import http.client
import os
import resource
import socket
import threading
from contextlib import ExitStack, closing, contextmanager, suppress
from pathlib import Path

import psutil
from drills.results import Result, Watcher
from processes.served_demo import Demo, running_program

from app.clock import monotonic

DESCRIPTORS = 1024  # of the program
SILENT = 1100  # connections
STOP_LIMIT = 5.0  # s, on a busy machine, too: from the beginning of a new connection to the answer
UPLOADS = 20
LENGTH, SENT = 60_000_000, 4_000_000  # bytes that an upload announces, and that it sends
MOST_KEPT = 1_000_000  # bytes on the disk
HEAD = "POST /api/v1/{} HTTP/1.1\r\nHost: {}\r\nOrigin: http://{}\r\n"
KINDS = {"silent": "", "half a head": HEAD, "without its body": HEAD + "Content-Length: 100\r\n\r\n{{"}


async def silent_connections(runs, _dice):
    """S6: 1,100 connections that do nothing, to a program with 1,024 descriptors; then Stop over a new one."""
    result = Result(f"{SILENT} connections that do nothing, then Stop over a new one", STOP_LIMIT)
    await asyncio.to_thread(_be_silent, runs, result)
    result.remark = f"{DESCRIPTORS} descriptors; {', '.join(KINDS)}; until Stop is answered"
    return result


async def uploads_of_nobody(runs, _dice):
    """C15: files from somebody who is not signed in, whose ends never come."""
    result = Result(f"{UPLOADS} uploads of somebody who is not signed in", None)
    kept = []
    await asyncio.to_thread(_upload, runs, result, kept)
    result.remark = f"{SENT / 1e6:.0f} of {LENGTH / 1e6:.0f} MB each; at most {max(kept)} bytes kept on the disk"
    return result


def _be_silent(runs, result):
    with few_descriptors() as demo, closing(Watcher()) as watcher:
        for run in range(runs):
            with connections(demo, list(KINDS)[run % len(KINDS)]) as used:
                began = monotonic()
                stop(demo)
                ended = monotonic()
                result.add(ended - began, late=watcher.late(began, ended))
                if max(used) > DESCRIPTORS - 100:
                    result.violations.append(f"run {result.runs}: too few descriptors are left")


def _upload(runs, result, kept):
    with few_descriptors() as demo:
        for _ in range(runs):
            kept.append(upload_as_nobody(demo))
            result.add(None)
            if kept[-1] > MOST_KEPT:
                result.violations.append(f"run {result.runs}: {kept[-1] / 1e6:.1f} MB were kept")


@contextmanager
def few_descriptors():
    """Yield a demonstration that may open 1,024 descriptors, while this process may open more."""
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (max(soft, min(2 * SILENT, hard)), hard))
    try:
        with running_program("demo", "--port", "0") as process:
            psutil.Process(process.pid).rlimit(psutil.RLIMIT_NOFILE, (DESCRIPTORS, DESCRIPTORS))
            made = Demo(process)
            yield made
            made.client.close()
    finally:
        resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))


@contextmanager
def connections(demo, kind):
    """Keep many connections of a kind open; yield how many descriptors the program has in use, look by look."""
    program, used, ended = psutil.Process(demo.process.pid), [], threading.Event()

    def look():
        while not ended.wait(0.02):
            used.append(program.num_fds())

    with ExitStack() as stack:
        looking = threading.Thread(target=look)
        looking.start()
        stack.callback(looking.join)
        stack.callback(ended.set)
        for _ in range(SILENT):
            opened = stack.enter_context(_connected(demo))
            with suppress(OSError):  # closed already
                opened.sendall(KINDS[kind].format("auth/sign-in", _host(demo), _host(demo)).encode())
        yield used


def stop(demo):
    """Stop as somebody does who is not connected yet."""
    connection = http.client.HTTPConnection(_host(demo), timeout=60.0)
    connection.request("POST", "/api/v1/control/stop")
    assert b'"fault"' in connection.getresponse().read()
    connection.close()


def upload_as_nobody(demo):
    """Begin uploads; return how many bytes the program keeps on the disk for them, at most."""
    kept = 0
    with ExitStack() as stack:
        opened = [stack.enter_context(_connected(demo)) for _ in range(UPLOADS)]
        for one in opened:
            one.settimeout(0.2)
            head = HEAD.format("equipment/files", _host(demo), _host(demo))
            head += f"Content-Type: multipart/form-data; boundary=x\r\nContent-Length: {LENGTH}\r\n\r\n"
            part = '--x\r\nContent-Disposition: form-data; name="file"; filename="a.csv"\r\n\r\n'
            with suppress(OSError):
                one.sendall((head + part).encode() + bytes(SENT))
            kept = max(kept, _unnamed_files(demo.process.pid))
    return kept


def _connected(demo):
    host, port = _host(demo).split(":")
    return socket.create_connection((host, int(port)), timeout=60)


def _host(demo):
    return demo.base.removeprefix("http://")


def _unnamed_files(pid):
    """Return the size of the files that a process has open and that have no name: what arrives of an upload."""
    size = 0
    for link in Path(f"/proc/{pid}/fd").iterdir():
        with suppress(OSError):
            if os.readlink(link).endswith("(deleted)") and not os.readlink(link).startswith(("/dev/", "/memfd")):
                size += link.stat().st_size
    return size

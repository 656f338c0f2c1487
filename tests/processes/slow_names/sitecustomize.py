"""Lets a process wait for names that end in `.slow`, as a resolver does that nobody answers."""

import socket
import time

_resolve = socket.getaddrinfo


def _slowly(host, *arguments, **keywords):
    if str(host).endswith(".slow"):
        time.sleep(5.0)
        raise socket.gaierror(socket.EAI_AGAIN, "Temporary failure in name resolution")
    return _resolve(host, *arguments, **keywords)


socket.getaddrinfo = _slowly

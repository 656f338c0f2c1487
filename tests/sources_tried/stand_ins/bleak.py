"""Stands in for bleak in a program that is tried: sensors of WitMotion, whose frames their far end sends by UDP.

A datagram is the address of a sensor (6 bytes) and its frame.
"""

import os
import socket
import threading
from contextlib import suppress

from hardware.shirt.orientation_sensors.fake_bleak import FakeBleak

LONGEST = 4096  # bytes
ADDRESS = 6  # bytes


def take_frames(library, port):
    """Let each sensor send what the far end sends to a port."""
    sensors = {}
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listening:
        listening.bind(("127.0.0.1", port))
        while True:
            datagram = listening.recv(LONGEST)
            address = datagram[:ADDRESS].hex(":").upper()
            if address not in sensors:
                sensors[address] = library.add_sensor(address)
            sensor = sensors[address]
            if sensor.is_asked:
                with suppress(RuntimeError):  # its connection has just ended
                    sensor.send(datagram[ADDRESS:])


_library = FakeBleak()
BleakScanner, BleakClient = _library.BleakScanner, _library.BleakClient
threading.Thread(
    target=take_frames, args=(_library, int(os.environ["SOURCES_TRIED_PORT"])), name="far end", daemon=True
).start()

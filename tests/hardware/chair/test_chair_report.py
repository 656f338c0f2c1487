"""The virtual chair's report, byte by byte."""

import socket
import struct

import pytest

from app.faults import State
from app.hardware.base import HardwareError
from app.hardware.chair.report import ChairReport, encode_report
from app.messages import Tick

TICK = Tick(t=12.5, frame_seq=77, x=1.5, y=-2.0, theta=0.25, v=0.5, omega=-0.75, state=State.ARMED)


def test_the_bytes_are_those_of_the_protocol():
    datagram = encode_report(TICK)
    assert len(datagram) == 44
    assert datagram[:8] == b"BMIP" + bytes([1, 2, 0, 0])
    assert struct.unpack("<IQ", datagram[8:20]) == (77, 12_500_000_000)
    assert struct.unpack("<6f", datagram[20:]) == (1.5, -2.0, 0.25, 0.5, -0.75, 0.0)


def test_a_report_arrives_and_nobody_there_is_no_trouble():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as listening:
        listening.bind(("127.0.0.1", 0))
        listening.settimeout(5.0)
        report = ChairReport(*listening.getsockname())
        report.send(TICK)
        assert listening.recv(100) == encode_report(TICK)
    for _ in range(5):
        report.send(TICK)
    report.close()


def test_an_address_that_is_none_is_one_sentence():
    with pytest.raises(HardwareError, match=r"reports cannot be sent to .*: give a host and port"):
        ChairReport("not a host", 5000)

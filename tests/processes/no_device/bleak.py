"""Stands in for bleak in a process of tests: the machine has no Bluetooth adapter."""


class BleakScanner:
    def __init__(self, **_keywords):
        raise OSError("there is no adapter")

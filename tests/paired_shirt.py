"""A paired shirt over the network: a thread sends the frames of the simulated shirt, signed."""

import socket
import sqlite3
import threading
from contextlib import closing

from processes.udp_shirt import free_port

from app.clock import MonotonicClock
from app.hardware.body.visitor import Visitor
from app.hardware.chair.key import read_key
from app.hardware.shirt.sender import signed_frame
from app.hardware.shirt.simulator import SimulatedShirt, SimulatorConfig
from app.session.equipment.pairing import pair_shirt, shirt_key_file


def calibrated_as_worn(database):
    """Let the maps in a database file count as ones of a worn shirt, whose patients consented to recording.

    A calibration takes minutes.
    """
    with closing(sqlite3.connect(database, timeout=10)) as connection, connection:
        connection.execute("UPDATE profile SET simulated = 0")
        connection.execute(
            "INSERT INTO patient_consent (patient_id, consent, given, person, written) "
            "SELECT id, 'recording', '2026-03-01', 'Ada', '2026-03-01 10:00:00.000000' FROM patient"
        )


class PairedShirt:
    """Pairs with the clinic in a state folder and sends to it until it is closed; its body rests until it is moved."""

    def __init__(self, state):
        keys = state / "keys"
        file = shirt_key_file(keys, pair_shirt(keys).id)
        self._key = read_key(file)
        self.port = free_port()
        self._shirt = SimulatedShirt(SimulatorConfig(kind="simulator"), MonotonicClock())
        self._shirt.body = Visitor()
        self._shirt.open()
        layout = self._shirt.layout.model_dump(mode="json")
        self.config = {"kind": "udp", "port": self.port, "layout": layout, "key_file": file.name}
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._send)
        self._thread.start()

    def bend(self, share):
        """Bend the right elbow, 0 (at rest) to 1."""
        self._shirt.body.move({"right_elbow": share})

    def close(self):
        self._ended.set()
        self._thread.join()

    def _send(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            while not self._ended.is_set():
                frame = self._shirt.read(0.05)
                if frame is not None:
                    values = frame.values.tolist()
                    datagram = signed_frame(self._key, 1, frame.seq, round(frame.t_device * 1e6), values)
                    sender.sendto(datagram, ("127.0.0.1", self.port))

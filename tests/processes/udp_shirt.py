"""A shirt over UDP, sent by a thread: at rest, or with one stroke of the right elbow; signed when it is paired."""

import socket
import threading

import numpy as np

from app.clock import MonotonicClock
from app.hardware.chair.key import read_key
from app.hardware.shirt.packet import encode
from app.hardware.shirt.sender import signed_frame
from app.session.equipment.pairing import pair_shirt, shirt_key_file

RATE = 100.0
STROKE_TIME = 0.6  # s


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def paired_key_file(folder):
    """Pair a shirt and return its key file."""
    return shirt_key_file(folder, pair_shirt(folder).id)


def shirt_config(parameters, port, key_file=None):
    layout = parameters.profile.layout.model_dump(mode="json")
    where = {"kind": "udp", "host": "127.0.0.1", "port": port}
    return {**where, "layout": layout, "sample_rate": RATE, "key_file": key_file and str(key_file)}


class UdpShirtSender:
    """Sends frames at 100 Hz until it is closed, signed when it has a key; after a stroke the arm stays bent."""

    def __init__(self, parameters, port, key_file=None):
        self._key = key_file and read_key(key_file)
        self._profile = parameters.profile
        self._address = ("127.0.0.1", port)
        self._stroke_at = self._back_at = None
        self._ended = threading.Event()
        self._frames = 0
        self._thread = threading.Thread(target=self._send)
        self._thread.start()

    def stroke(self):
        """Bend the right elbow: forward, at about half speed. An elbow that is bent is first brought back."""
        self._back_at, self._stroke_at = self._stroke_at and self._frames, self._frames
        if self._back_at is not None:
            self._stroke_at += round(STROKE_TIME * RATE)

    def close(self):
        self._ended.set()
        self._thread.join()

    def _done(self, since):
        """Return the share of a smooth movement that began at a frame; 0 before it, or without one."""
        share = 0.0 if since is None else min(1.0, max(0.0, (self._frames - since) / RATE / STROKE_TIME))
        return share * share * (3 - 2 * share)

    def _values(self):
        elbow = next(joint for joint in self._profile.joints if joint.name == "right_elbow")
        values = np.zeros(len(self._profile.layout.channels), dtype=np.float32)
        for joint in self._profile.joints:
            values[list(joint.channels)] += np.array(joint.mean, dtype=np.float32)
        posture = 0.6 * (
            self._done(self._stroke_at) + (0.0 if self._back_at is None else 1.0 - self._done(self._back_at))
        )
        values[list(elbow.channels)] += (posture * elbow.span * np.array(elbow.direction)).astype(np.float32)
        # a constant channel would count as broken
        return values + np.float32(1e-3) * np.random.default_rng(self._frames).standard_normal(len(values), np.float32)

    def _frame(self):
        values, t = self._values(), self._frames / RATE
        if self._key is None:
            return encode(self._frames, t, values)
        return signed_frame(self._key, 1, self._frames, round(t * 1e6), values.tolist())

    def _send(self):
        clock = MonotonicClock()
        due = clock.now()
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            while not self._ended.is_set():
                sender.sendto(self._frame(), self._address)
                self._frames += 1
                due += 1 / RATE
                clock.sleep_until(due)

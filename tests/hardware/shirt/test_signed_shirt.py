"""A shirt with a key: only its own frames, each once, across restarts of the shirt and of this process (safety S23)."""

import hmac
import random
import socket
import struct
import threading
import zlib

import numpy as np
import pytest
from fake_clock import FakeClock
from hardware.shirt.shirts import RATE, small_layout
from hypothesis import given, settings
from hypothesis import strategies as st

from app.clock import MonotonicClock
from app.hardware.base import HardwareError
from app.hardware.chair.key import Key, new_key, read_key
from app.hardware.shirt.newest_frame import newest_file
from app.hardware.shirt.packet import decode, decode_signed, encode, refusal
from app.hardware.shirt.sender import signed_frame
from app.hardware.shirt.sender_choice import SHIRT_SENDER_SILENCE
from app.hardware.shirt.udp import UdpConfig, UdpShirt
from app.session.equipment.pairing import pair_shirt, shirt_key_file

WAIT = 2.0  # s
FORGED = 12_000
VALUES = [0.25, -1.5, 3.0]
SAMPLES = st.lists(st.floats(width=32, allow_nan=False), min_size=1, max_size=64)


class PairedShirt:
    """A shirt over the network with a key, and devices that send to it."""

    def __init__(self, folder, clock):
        self.key_file = shirt_key_file(folder, pair_shirt(folder).id)
        self.key = read_key(self.key_file)
        self.clock = clock
        self.devices = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(2)]
        self.shirt = self.new_shirt()

    def new_shirt(self):
        layout = small_layout()
        config = UdpConfig(kind="udp", port=0, layout=layout, sample_rate=RATE, key_file=str(self.key_file))
        shirt = UdpShirt(config, self.clock)
        shirt.open()
        return shirt

    def frame(self, boot, seq, kept=0.0):
        """Return a frame that was made `kept` seconds ago."""
        return signed_frame(self.key, boot, seq, round(1e6 * (self.clock.now() - kept)), VALUES)

    def send(self, content, device=0):
        self.devices[device].sendto(content, self.shirt.address)

    def takes(self, boot, seq, device=0, kept=0.0):
        """Send a frame and return whether it is accepted."""
        self.send(self.frame(boot, seq, kept), device)
        return self.shirt.read(0.05) is not None

    def begin(self, boot, seq=0, device=0):
        """Send the first frame of a start repeatedly, until the number on the disk allows it."""
        pause = threading.Event()
        for _ in range(500):
            if self.takes(boot, seq, device):
                return
            pause.wait(0.005)
        raise AssertionError(str(self.shirt.description()))

    def close(self):
        self.shirt.close()
        for device in self.devices:
            device.close()


@pytest.fixture
def paired(tmp_path):
    made = PairedShirt(tmp_path / "keys", MonotonicClock())
    yield made
    made.close()


@settings(max_examples=200, deadline=None)
@given(SAMPLES, st.integers(0, 2**64 - 1), st.integers(0, 2**32 - 1), st.integers(0, 2**64 - 1), st.integers(0, 65_535))
def test_the_sender_s_bytes_come_back_as_they_were(samples, boot, seq, microseconds, key_id):
    key = Key(key_id, bytes(range(32)))
    content = signed_frame(key, boot, seq, microseconds, samples)
    found_boot, (found_seq, found_time, values) = decode_signed(content, len(content), len(samples), key)
    assert (found_boot, found_seq, found_time) == (boot, seq, microseconds)
    np.testing.assert_array_equal(values, np.array(samples, np.float32))
    assert decode(content, len(content), len(samples)) is None
    assert "choose its key" in str(refusal(content, len(content), len(samples)))


def test_the_bytes_are_those_of_the_protocol():
    key = Key(0x1234, bytes(range(32)))
    content = signed_frame(key, 0x1122334455667788, 0xAABBCCDD, 1_000_000, [1.0, -2.0])
    body = bytes.fromhex("53485254 01 02 0200 ddccbbaa 40420f0000000000 3412 8877665544332211 0000803f 000000c0")
    tag = hmac.new(bytes(range(32)), body, "sha256").digest()[:16]
    assert content == body + tag + struct.pack("<I", zlib.crc32(body + tag))


def test_int16_samples_can_be_signed_too():
    key = new_key(7)
    body = struct.pack("<4sBBHIQHQ2h", b"SHRT", 1, 3, 2, 5, 6, 7, 8, 32767, -32767)
    content = body + hmac.digest(key.secret, body, "sha256")[:16]
    content += struct.pack("<I", zlib.crc32(content))
    boot, (seq, _, values) = decode_signed(content, len(content), 2, key)
    assert (boot, seq, values.tolist()) == (8, 5, [1.0, -1.0])


def forged(dice, paired, boot, seq):
    """Return a datagram that is not the shirt's next frame: (boot, seq) was taken last."""
    newer = paired.frame(boot, seq + dice.randint(1, 500))
    kind = dice.randrange(10)
    forgeries = (
        lambda: encode(seq + 1, 1.0, np.array(VALUES, np.float32)),
        lambda: signed_frame(new_key(paired.key.id), boot + 1, seq + 1, 0, VALUES),
        lambda: signed_frame(Key(paired.key.id ^ 1, paired.key.secret), boot, seq + 1, 0, VALUES),
        lambda: paired.frame(boot, dice.randint(0, seq)),
        lambda: paired.frame(dice.randint(0, boot - 1), dice.randint(0, 2**32 - 1)),
        lambda: newer[: dice.randrange(len(newer))],
        lambda: newer + dice.randbytes(dice.randint(1, 40)),
    )
    if kind < len(forgeries):
        return forgeries[kind]()
    changed = bytearray(newer)
    place = dice.randrange(len(changed) - 4)
    changed[place] ^= 1 << dice.randrange(8)
    if kind >= 8:  # ... by somebody who knows the checksum
        changed[-4:] = struct.pack("<I", zlib.crc32(changed[:-4]))
    return bytes(changed)


def test_12000_forged_and_repeated_frames_do_nothing(paired):
    dice = random.Random(5)
    boot, seq = 9, 600
    paired.begin(boot, seq)
    taken = 0
    for _ in range(FORGED // 40):
        for _ in range(40):
            paired.send(forged(dice, paired, boot, seq), device=dice.randrange(2))
        while paired.shirt.pending():
            taken += paired.shirt.read(0.0) is not None
    assert taken == 0
    assert paired.shirt.junk + paired.shirt.repeated == FORGED
    assert paired.takes(boot, seq + 1)  # ... and the shirt is heard as before
    assert "not signed with this shirt's key" in str(paired.shirt.description())


def test_a_frame_is_taken_once_also_by_a_process_that_comes_later(paired):
    paired.begin(4, 10)
    assert not paired.takes(4, 10)
    assert not paired.takes(4, 9)
    assert "2 repeated frames left out" in str(paired.shirt.description())
    paired.shirt.close()
    paired.shirt = paired.new_shirt()
    assert not paired.takes(4, 10)
    assert not paired.takes(3, 4_000_000)
    paired.begin(4, 11)


@pytest.fixture
def begun(tmp_path):
    made = PairedShirt(tmp_path / "keys", FakeClock(10.0))
    made.begin(1)
    yield made
    made.close()


def test_another_address_with_the_key_waits_until_nothing_can_be_armed(begun):
    assert not begun.takes(1, 5, device=1)  # the shirt's own frame, sent on by somebody else
    assert begun.takes(1, 5)  # which does not spoil the shirt's
    assert not begun.takes(2, 0, device=1)
    assert "frames of another sender" in str(begun.shirt.description())
    begun.clock.time += SHIRT_SENDER_SILENCE + 0.1
    begun.begin(2, 0, device=1)
    assert not begun.takes(1, 6)
    assert begun.shirt.lost <= 4


def test_genuine_frames_that_are_kept_back_are_none(begun):
    """Kept back for 2 s they armed, and a stroke of the past moved the chair."""
    for seq, kept in ((1, 2.0), (2, 2.0), (3, 0.12), (4, 9.0)):
        begun.clock.time += 0.01
        assert not begun.takes(1, seq, kept=kept)
        assert str(begun.shirt.description()).endswith(f", {seq} late frame{'s' if seq > 1 else ''} left out.")
    begun.clock.time += 2.0
    assert not begun.takes(1, 5, kept=2.0)
    assert str(begun.shirt.description()).startswith("No frames from 127.0.0.1:")
    assert "(its frames arrive 2.0 s late, and a late one is not used: bring" in str(begun.shirt.description())
    assert begun.takes(1, 6, kept=0.05)
    assert not begun.takes(1, 4)
    assert begun.shirt.lost == 0


def test_a_shirt_that_is_started_again_is_judged_by_its_own_clock(begun):
    begun.clock.time += 5.0
    begun.begin(2)
    begun.clock.time += 5.0
    assert not begun.takes(2, 1, kept=0.2)


def test_a_key_that_is_none_opens_nothing(paired):
    paired.shirt.close()
    paired.key_file.chmod(0o644)
    with pytest.raises(HardwareError, match="can be read by others"):
        paired.new_shirt()
    paired.key_file.chmod(0o600)
    newest_file(paired.key_file).unlink()
    with pytest.raises(HardwareError, match="pair the shirt anew"):
        paired.new_shirt()

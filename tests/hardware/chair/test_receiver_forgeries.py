"""S13: forged, replayed, reordered, truncated and old commands do nothing: 12,000 of them, every bit looked at."""

import random
import struct

import pytest
from hardware.chair.commanded_receiver import KEY, CommandedReceiver

from app.hardware.chair.key import Key
from app.hardware.chair.packet import DRIVE, FRAME_BYTES, NONCE_BYTES, STOP, ChairCommand, encode_command, encode_hello
from app.hardware.chair.reasons import Reason
from app.hardware.chair.receiver import ReceiverState

CASES = 12_000


def booted(chair):
    chair.wait(0.1)


def checking(chair):
    chair.command(0.3)


def driving(chair):
    chair.drive(0.5, 0.2)


def stopped(chair):
    chair.drive(0.5, 0.2)
    chair.send(flags=STOP)
    chair.wait(0.1)  # still on its way to standstill


def switched_off(chair):
    chair.drive(0.5, 0.2)
    chair.conditions = {"obstacle": Reason.STOP_INPUT}
    chair.wait(0.1)


@pytest.fixture(scope="module")
def earlier():
    """Return the frames of a drive, from its arming to its end, with the same key and an earlier boot."""
    chair = CommandedReceiver()
    chair.nonces = 1000
    chair.receiver.nonce = chair._nonce(NONCE_BYTES)
    frames = listened_to(chair)
    stopped(chair)
    return frames


def listened_to(chair):
    """Return a list of all frames that this chair's sender makes from now on."""
    frames = []
    make = chair.frame

    def frame(*words, **changes):
        frames.append(make(*words, **changes))
        return frames[-1]

    chair.frame = frame
    return frames


def everything(receiver):
    """Return the whole state of a receiver."""
    return repr(vars(receiver))


def forgeries(chair, seen, earlier, rng):
    """Return one function for each kind of forgery, which makes a datagram from a `seen` command or a new one."""

    def fresh(**changes):
        """Return the next command of the true sender."""
        true = {} if is_running(chair) else {"epoch": chair.epoch + 1}
        if chair.state is ReceiverState.ARMED:
            true = {"v": 0.5, "omega": 0.2, "flags": DRIVE}
        return chair.frame(**{**true, **changes})

    def flipped():
        frame = bytearray(fresh())
        frame[rng.randrange(FRAME_BYTES)] ^= 1 << rng.randrange(8)
        return bytes(frame)

    def swapped_field():
        frame = fresh()
        at, size = rng.choice(((4, 1), (5, 1), (6, 2), (8, 4), (12, 8), (20, 8), (28, 8), (36, 8), (44, 8), (52, 16)))
        other = bytes(byte ^ rng.randint(1, 255) for byte in frame[at : at + size])
        return frame[:at] + other + frame[at + size :]

    def resigned(key=KEY, nonce=None):
        body = fresh()[:52]
        return encode_command(ChairCommand(*struct.unpack("<4sBBHIQQffff8s", body)[2:]), key, nonce)

    odd = (float("nan"), float("inf"), float("-inf"))
    number = rng.choice(("v", "omega", "v_cap", "omega_cap"))
    return {
        "a bit flipped": flipped,
        "a field swapped": swapped_field,
        "truncated": lambda: fresh()[: rng.randrange(FRAME_BYTES)],
        "extended": lambda: fresh() + rng.randbytes(rng.randint(1, 40)),
        "random": lambda: b"BMIW\x01" + rng.randbytes(rng.choice((63, 63, 63, 7, 0, 300))),
        "replayed": lambda: rng.choice(seen),
        "reordered": lambda: fresh(epoch=chair.epoch, sequence=rng.randint(0, chair.receiver._sequence)),
        "of an epoch before": lambda: fresh(
            epoch=chair.epoch - rng.randint(1, 3) if is_running(chair) else chair.epoch
        ),
        "another key": lambda: resigned(Key(KEY.id, rng.randbytes(32)), chair.receiver.nonce),
        "another number of key": lambda: fresh(key_id=(KEY.id + rng.randint(1, 65_535)) % 65_536),
        "another nonce": lambda: resigned(KEY, rng.randbytes(8)),
        "the nonce before": lambda: resigned(KEY, (chair.nonces - 1).to_bytes(8, "little")),
        "no nonce": lambda: resigned(KEY, b""),
        "of an earlier boot": lambda: rng.choice(earlier),
        "not a number": lambda: fresh(**{number: rng.choice(odd)}),
        "a negative cap": lambda: fresh(**{rng.choice(("v_cap", "omega_cap")): -rng.random() - 1e-6}),
        "telemetry sent back": lambda: chair.receiver.telemetry(chair.t),
        "telemetry made a command": lambda: b"BMIW" + chair.receiver.telemetry(chair.t)[4:],
        "a hello": lambda: encode_hello(KEY.id),
        "a command made telemetry": lambda: b"BMIT" + fresh()[4:],
        "another set": lambda: fresh(digest=b"practisf"),
    }


def is_running(chair):
    return chair.state in (ReceiverState.CHECKING, ReceiverState.ARMED)


NEEDS_AN_EPOCH = {"replayed", "reordered", "of an epoch before"}  # nothing of that kind exists before the first one
NEEDS_TO_RUN = {"another set"}  # a set is chosen by the first command
FORGED = [
    (way, reach)
    for way in forgeries(CommandedReceiver(), [], [], random.Random(0))
    for reach in (booted, checking, driving, stopped, switched_off)
    if not (way in NEEDS_AN_EPOCH and reach is booted)
    and not (way in NEEDS_TO_RUN and reach not in (checking, driving))
]
REPEATS = -(-CASES // len(FORGED))


def test_a_forgery_changes_nothing(earlier):
    for way, reach in FORGED:
        changes_nothing(way, reach, earlier)


def changes_nothing(way, reach, earlier):
    case = f"{way}, {reach.__name__}"
    rng = random.Random(f"{way} {reach.__name__}")
    chair = CommandedReceiver()
    seen = listened_to(chair)
    reach(chair)
    chair.t += 0.005
    before, nonces = everything(chair.receiver), chair.nonces
    for _ in range(REPEATS):
        make = forgeries(chair, seen, earlier, rng)[way]
        assert not chair.receiver.accept(make(), chair.t), case
    assert everything(chair.receiver) == before, case
    assert chair.nonces == nonces, case
    chair.conditions = {}
    chair.step()
    true = {"v": 0.5, "flags": DRIVE} if reach is driving else {}
    assert chair.send(**true, epoch=chair.epoch + (not is_running(chair))), f"{case}: what is true is not taken"


def test_every_bit_of_a_command_counts():
    chair = CommandedReceiver().drive()
    frame = chair.frame(0.5, 0.0, DRIVE)
    before = everything(chair.receiver)
    for bit in range(8 * FRAME_BYTES):
        forged = bytearray(frame)
        forged[bit // 8] ^= 1 << bit % 8
        assert not chair.receiver.accept(bytes(forged), chair.t)
    assert everything(chair.receiver) == before
    assert chair.receiver.accept(frame, chair.t)


def test_a_whole_drive_of_an_earlier_boot_moves_nothing(chair, earlier):
    for frame in earlier:
        assert not chair.receiver.accept(frame, chair.t)
        chair.wait(0.02)
    assert chair.state is ReceiverState.DISARMED
    assert not any(v or omega for _, v, omega in chair.speeds)


def test_drives_of_the_same_boot_move_nothing_when_they_are_sent_again(chair):
    sent = []
    for _ in range(3):
        for speed in (*[0.0] * 30, *[0.4] * 10):
            sent.append(chair.frame(speed, 0.0, DRIVE))
            assert chair.receiver.accept(sent[-1], chair.t)
            chair.wait(0.02)
        chair.wait(0.5)  # silence ends the epoch
        assert chair.state is ReceiverState.DISARMED
        chair.epoch += 1
    begun = len(chair.speeds)
    for frame in sent:
        assert not chair.receiver.accept(frame, chair.t)
        chair.wait(0.02)
    assert chair.state is ReceiverState.DISARMED
    assert not any(v or omega for _, v, omega in chair.speeds[begun:])

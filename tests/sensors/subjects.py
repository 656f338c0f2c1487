"""The drivers that are measured: how each is opened, what its frames say of their age, what else may be sent to it."""

import random
import socket
from contextlib import contextmanager, suppress
from functools import partial

import numpy as np
from fake_clock import FakeClock
from hardware.shirt.camera_page import CHANNELS
from hardware.shirt.fake_brainflow import FakeBrainFlow
from hardware.shirt.fake_lsl import FakeLsl
from hardware.shirt.orientation_sensors.fake_bleak import FakeBleak
from hardware.shirt.orientation_sensors.phone_page import PhonePage
from hardware.shirt.orientation_sensors.slime_tracker import SlimeTracker
from hardware.shirt.wired_board import WiredBoard
from sensors.far_ends import (
    MACS,
    PHONES,
    SENSORS,
    STREAM,
    BluetoothEnd,
    BoardEnd,
    CameraEnd,
    FarEnd,
    FramesEnd,
    LinesEnd,
    LslEnd,
    PhonesEnd,
    TrackersEnd,
    UdpEnd,
    age_of_angle,
    age_of_parts,
    line_in,
)
from sensors.fed_shirt import FedShirt, take_notification

from app.api.live.camera_socket import ActiveCamera
from app.clock import MonotonicClock
from app.hardware.base import HardwareError
from app.hardware.body.person import SimulatedPerson
from app.hardware.shirt.brainflow_board import BrainFlowConfig, BrainFlowShirt
from app.hardware.shirt.camera import HEADER, CameraConfig, CameraShirt
from app.hardware.shirt.lsl import LslConfig, LslShirt
from app.hardware.shirt.orientation_sensors.bluetooth import BluetoothConfig, BluetoothShirt
from app.hardware.shirt.orientation_sensors.phones import MESSAGE, PhonesConfig, PhonesShirt
from app.hardware.shirt.orientation_sensors.slimevr import SlimeVrConfig, SlimeVrShirt
from app.hardware.shirt.packet import encode
from app.hardware.shirt.serial_line import SerialConfig, SerialShirt
from app.hardware.shirt.simulator import SimulatedShirt, SimulatorConfig
from app.hardware.shirt.udp import UdpConfig, UdpShirt
from app.layout import Channel, Joint, ShirtLayout

AT_ONCE = 64  # junk datagrams before they are read: the kernel keeps that many
OTHERS = 1000  # frames of a second sender


def layout_of_sensors():
    """Return a layout of SENSORS channels of one joint."""
    return ShirtLayout(
        name="measured",
        channels=tuple(Channel(name=f"elbow_{number}", joint="elbow") for number in range(1, SENSORS + 1)),
        joints=(Joint(name="elbow", label="Elbow"),),
    )


class Subject:
    """A driver at its full rate (Hz).

    Attributes
    ----------
    kind : str
        The name of its kind of shirt.
    far_end : type or None
        The class of its far end; None: there is none.
    is_counted : bool
        Whether each sample of the far end is a frame.
    """

    kind, title, what, rate = "", "", "", 100.0
    far_end: type[FarEnd] | None = None
    is_counted = True

    def shirt(self, folder):
        """Return the driver, not yet open; what it shares with its far end lies in `folder`."""
        raise NotImplementedError

    def age(self, frame, now):
        """Return how old (s) the samples of a frame are at `now` (monotonic s), NaN when it has none."""
        return age_of_parts(frame.values, now)

    def junk(self, folder, count):
        """Send junk, and return how many frames came; None: nothing can be sent that the driver would have to read."""

    def second(self, folder):
        """Let a second sender send, and return in words what became of it; None: there can be none."""


class Simulator(Subject):
    kind = "simulator"
    title, what, rate = "simulator (reference)", "52 sensors, a simulated person", 1000.0

    def shirt(self, _folder):
        shirt = SimulatedShirt(SimulatorConfig(kind="simulator", sample_rate=self.rate), MonotonicClock())
        shirt.body = SimulatedPerson("practised", 1)
        return shirt

    def age(self, frame, now):
        return now - frame.t_device  # from an unknown start: only differences count


class Udp(Subject):
    kind = "udp"
    title, what, rate, far_end = "UDP", "52 sensors as float32", 1000.0, UdpEnd

    def shirt(self, _folder):
        config = UdpConfig(kind="udp", port=0, sample_rate=self.rate, layout=layout_of_sensors())
        return UdpShirt(config, MonotonicClock())

    def junk(self, folder, count):
        source, frames = random.Random(1), 0
        with opened(self.shirt(folder)) as shirt, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as out:
            for i in range(count):
                out.sendto(source.randbytes(i % 300), shirt.address)
                if i % AT_ONCE == AT_ONCE - 1 or i == count - 1:
                    frames += read_waiting(shirt)
            assert shirt.junk == count
        return frames

    def second(self, folder):
        with opened(self.shirt(folder)) as shirt, datagrams() as own, datagrams() as other:
            frames = 0
            for seq in range(OTHERS):
                for device in (own, other):
                    device.sendto(encode(seq, seq / self.rate, np.zeros(SENSORS, np.float32)), shirt.address)
                frames += read_waiting(shirt)
            assert (frames, shirt.sender_choice.other_frames) == (OTHERS, OTHERS)
        return f"{OTHERS} frames counted, none taken"


class Frames(Subject):
    kind = "serial"
    title, what, rate, far_end = "cable, frames", "52 sensors as int16, a checksum", 1000.0, FramesEnd
    format = "frames"

    def config(self, **more):
        return SerialConfig(
            kind="serial", format=self.format, sample_rate=self.rate, layout=layout_of_sensors(), **more
        )

    def shirt(self, folder):
        config = self.config().model_copy(update={"device": str(line_in(folder))})
        return SerialShirt(config, MonotonicClock())

    def piece(self, source):
        """Return junk between two ends of a frame or line."""
        return source.randbytes(source.randrange(1, 150)).replace(b"\0", b"\1") + b"\0"

    def junk(self, _folder, count):
        source, frames, board = random.Random(2), 0, WiredBoard()
        with opened(SerialShirt(self.config(device=board.device), MonotonicClock())) as shirt:
            board.write(self.far_end.BEGIN)
            for i in range(count):
                board.write(self.piece(source))
                if i % 16 == 15 or i == count - 1:
                    until = MonotonicClock().now() + 10.0
                    while shirt._decoder.junk <= i and MonotonicClock().now() < until:
                        frames += shirt.read(0.01) is not None
            assert shirt._decoder.junk == count
        board.pull()
        return frames

    def second(self, _folder):
        board = WiredBoard()
        with opened(SerialShirt(self.config(device=board.device), MonotonicClock())):
            other = SerialShirt(self.config(device=board.device), MonotonicClock())
            with suppress(HardwareError):
                other.open()
                raise AssertionError("the line was opened twice")
        board.pull()
        return "a second program cannot open the line"


class Lines(Frames):
    title, what, rate, far_end = "cable, plain lines", "52 numbers", 500.0, LinesEnd
    format = "lines"

    def piece(self, source):
        return bytes(128 + byte % 64 for byte in source.randbytes(source.randrange(1, 150))) + b"\n"


class Trackers(Subject):
    kind = "slimevr"
    title, what, rate, far_end = "SlimeVR", "8 trackers", 100.0, TrackersEnd
    is_counted = False

    def shirt(self, _folder):
        config = SlimeVrConfig(kind="slimevr", host="127.0.0.1", port=0, sample_rate=self.rate, **MACS)
        return SlimeVrShirt(config, MonotonicClock())

    def age(self, frame, now):
        return age_of_angle(frame.values[2], now)  # of the trunk, about the vertical

    def junk(self, folder, count):
        source, frames = random.Random(3), 0
        with opened(self.shirt(folder)) as shirt, datagrams() as out:
            for i in range(count):
                out.sendto(source.randbytes(12 + i % 40), shirt.address)
                if i % AT_ONCE == AT_ONCE - 1 or i == count - 1:
                    frames += shirt.read(0.0) is not None
            assert shirt._trackers.junk >= 0.99 * count  # few have a kind and content by chance
        return frames

    def second(self, folder):
        tracker = SlimeTracker(MACS["trunk"])
        with opened(self.shirt(folder)) as shirt, datagrams() as own, datagrams() as other:
            for device in (own, other):
                device.setblocking(False)
                device.sendto(tracker.handshake(), shirt.address)
                shirt.read(0.0)
            assert own.recv(100)
            with suppress(BlockingIOError):
                other.recv(100)
                raise AssertionError("two trackers in one name were answered")
            assert shirt.sender_choice.other_frames == 1
        return "counted, named, not answered"


class Bluetooth(Subject):
    kind = "bluetooth"
    title, what, rate, far_end = "Bluetooth", "8 sensors, no radio", 100.0, BluetoothEnd
    is_counted = False

    def shirt(self, _folder):
        bleak = FakeBleak()
        for mac in MACS.values():
            bleak.add_sensor(mac)
        config = BluetoothConfig(kind="bluetooth", sample_rate=self.rate, **MACS)
        return FedShirt(BluetoothShirt(config, MonotonicClock(), lambda: bleak), partial(take_notification, bleak))

    def age(self, frame, now):
        return age_of_angle(frame.values[2], now)

    def junk(self, _folder, count):
        source, frames, bleak = random.Random(5), 0, FakeBleak()
        sensor = bleak.add_sensor(MACS["trunk"])
        config = BluetoothConfig(kind="bluetooth", sample_rate=self.rate, trunk=sensor.address)
        with opened(BluetoothShirt(config, MonotonicClock(), lambda: bleak)) as shirt:
            sensor.wait_until_connected()
            for i in range(count):
                sensor.send(source.randbytes(1 + i % 40))
                if i % AT_ONCE == AT_ONCE - 1 or i == count - 1:
                    frames += shirt.read(1 / self.rate) is not None
            assert shirt._junk >= 0.99 * count  # few begin as a frame does by chance
        return frames


class Phones(Subject):
    kind = "phones"
    title, what, rate, far_end = "phones", "6 phones", 60.0, PhonesEnd
    is_counted = False

    def shirt(self, _folder):
        return PhonesShirt(PhonesConfig(kind="phones", sample_rate=self.rate, **PHONES), MonotonicClock())

    def age(self, frame, now):
        return age_of_angle(frame.values[2], now)

    def junk(self, folder, count):
        return junk_samples(self.shirt(folder), count, MESSAGE.size)

    def second(self, _folder):
        clock = FakeClock(50.0)
        shirt = PhonesShirt(PhonesConfig(kind="phones", sample_rate=self.rate, trunk="1"), clock)
        with opened(shirt):
            pages = [PhonePage(shirt, clock, page=number) for number in (1, 2)]
            for i in range(OTHERS):
                pages[i % 2].send()
                clock.time += 1 / self.rate
                assert shirt.read(0.0) is None
        return "no frame of two pages in one number"


class Camera(Subject):
    kind = "camera"
    title, what, rate, far_end = "camera", "19 channels", 30.0, CameraEnd
    is_counted = False

    def shirt(self, _folder):
        return CameraShirt(CameraConfig(kind="camera", sample_rate=self.rate), MonotonicClock())

    def age(self, frame, now):
        return age_of_angle(frame.values[0], now)

    def junk(self, folder, count):
        return junk_samples(self.shirt(folder), count, HEADER.size + 4 * CHANNELS)

    def second(self, _folder):
        active, own, other = ActiveCamera(), object(), object()
        numbers = [active.number((own, other)[i % 2], i / self.rate) for i in range(OTHERS)]
        assert numbers == [1, None] * (OTHERS // 2)
        return f"{OTHERS // 2} samples of a second page, none taken"


class Lsl(Subject):
    kind = "lsl"
    title, what, rate, far_end = "LSL", "52 sensors as float32", 1000.0, LslEnd

    def shirt(self, _folder):
        return LslShirt(LslConfig(kind="lsl", source_id=STREAM), MonotonicClock())

    def second(self, _folder):
        clock = FakeClock(50.0)
        lsl = FakeLsl(clock)
        for host in ("lab", "other"):
            lsl.add_sender(source_id=STREAM, host=host)
        with suppress(HardwareError):
            LslShirt(LslConfig(kind="lsl", source_id=STREAM), clock, lambda: lsl).open()
            raise AssertionError("one of two equal streams was taken")
        return "refused: two streams fit"


class Board(Subject):
    kind = "brainflow"
    title, what, rate, far_end = "BrainFlow", "52 channels, no board", 1000.0, BoardEnd

    def shirt(self, _folder):
        channels = {"analog_channels": [*range(SENSORS)], "timestamp_channel": SENSORS, "num_rows": SENSORS + 1}
        brainflow = FakeBrainFlow({"name": "Measured", "sampling_rate": self.rate, **channels})
        config = BrainFlowConfig(kind="brainflow", data="analog")
        shirt = BrainFlowShirt(config, MonotonicClock(), lambda: brainflow)
        return FedShirt(shirt, lambda sample: brainflow.send([np.frombuffer(sample)]))


SUBJECTS = (Simulator(), Udp(), Frames(), Lines(), Trackers(), Bluetooth(), Phones(), Camera(), Lsl(), Board())


@contextmanager
def opened(shirt):
    """Open a shirt, and close it at the end."""
    shirt.open()
    try:
        yield shirt
    finally:
        shirt.close()


def datagrams():
    """Return a socket that sends datagrams."""
    return socket.socket(socket.AF_INET, socket.SOCK_DGRAM)


def read_waiting(shirt):
    """Read what has arrived, and return how many frames it were."""
    frames = 0
    while shirt.pending():
        frames += shirt.read(0.0) is not None
    return frames


def junk_samples(shirt, count, size):
    """Give junk of about this size (bytes) to a shirt of pages, and return how many frames came."""
    source, frames = random.Random(4), 0
    with opened(shirt):
        for i in range(count):
            shirt.add_sample(1 + i % 6, source.randbytes(size + i % 3 - 1), MonotonicClock().now())
            if i % AT_ONCE == 0:
                frames += shirt.read(0.0) is not None
        assert shirt.refused == count
    return frames

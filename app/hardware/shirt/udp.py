"""A shirt that sends its frames as UDP datagrams."""

import math
import select
import socket
import struct
from pathlib import Path
from typing import Annotated, Literal

from pydantic import Field

from app.arrivals import Arrivals, ArrivalVerdict
from app.clock import Clock
from app.hardware.addresses import Host
from app.hardware.base import HardwareError
from app.hardware.chair.key import Key, KeyRefused, read_key
from app.hardware.chair.link_texts import lost_key, refusal_text
from app.hardware.shirt.arrival_watch import GOOD, WAITING, ArrivalWatch, LeftOut, RateMeter
from app.hardware.shirt.frame_order import Lateness, Sequence
from app.hardware.shirt.kind import (
    FieldTexts,
    LayoutFile,
    ShirtConfig,
    ShirtKey,
    ShirtKind,
    ShirtRate,
    SourceFacts,
    Trust,
    page_texts,
)
from app.hardware.shirt.newest_frame import NewestFrame, newest_file
from app.hardware.shirt.packet import KEY_REFUSALS, LONGEST, Packet, decode, decode_signed, refusal
from app.hardware.shirt.sender_choice import SHIRT_SENDER_SILENCE, Address, SenderChoice, address_text
from app.hardware.shirt.standard import standard_layout
from app.hardware.shirt.udp_socket import bound_socket, reach_of
from app.messages import ALIVE, SensorFrame
from app.ports import SHIRT_PORT
from app.quantities import Port
from app.texts import Figure, Text, Value

BUFFER = 2 * LONGEST  # bytes: room to notice a datagram that is too long
WRITE_AHEAD = 10.0  # s of frames that one write of the newest frame's number allows
_TIME = struct.Struct("@ll")  # struct timeval


class UdpConfig(ShirtConfig):
    """Frames that arrive by UDP on this machine."""

    model_config = page_texts(
        Text("shirtdev-udp-title"),
        about=Text("shirtdev-udp-about"),
        in_use=Text("shirtdev-udp-in-use", port="{port}"),
        facts=SourceFacts(Text("shirtdev-udp-needs"), Text("shirtdev-udp-costs"), Text("shirtdev-udp-takes")),
    )

    kind: Literal["udp"]
    # The address of this machine that the shirt sends to.
    host: Annotated[Host, FieldTexts(Text("shirtdev-udp-host"))] = "127.0.0.1"
    port: Annotated[Port, FieldTexts(Text("shirtdev-udp-port"))] = SHIRT_PORT  # 0: any free port
    sample_rate: ShirtRate = 100.0
    layout: LayoutFile = Field(default_factory=standard_layout)
    key_file: ShirtKey = None  # None: unsigned frames are accepted, and no real chair is armed


class UdpShirt:
    """Listens on one address; the sender of the first good frame is the shirt, until a person chooses another.

    Frames of two senders would be mixed into one body, and a forger could drive. So frames of every other sender are
    counted and ignored, however long the shirt is silent. With a key only signed frames are good, and none is accepted
    twice; one that comes late by the shirt's own clock is left out, for it shows a body of the past.
    """

    def __init__(self, config: UdpConfig, clock: Clock) -> None:
        self.layout = config.layout
        self.sample_rate = config.sample_rate
        self.address: tuple[str, int] = (config.host, config.port)  # with the true port once open
        self.sender_choice = SenderChoice()
        self.junk = 0  # datagrams that are no frame of this shirt
        self.repeated = 0  # signed frames that came again, or after a newer one
        self.late = 0  # signed frames that came late
        self._key_file = None if config.key_file is None else Path(config.key_file)
        self._key: Key | None = None
        self._newest: NewestFrame | None = None
        self._clock = clock
        self._channels = len(config.layout.channels)
        self._sequence = Sequence()
        self._lateness = Lateness()
        self._late_by = 0.0  # s, of the newest frame
        self._boot = 0
        self._socket: socket.socket | None = None
        self._buffer = bytearray(BUFFER)
        self._timeout = -1.0  # s, the timeout that is set in the kernel
        self._wait = -1.0  # s, the timeout of the last call of `read`
        self._sender: Address = ("", 0)  # of the datagram in the buffer
        self._watch = ArrivalWatch()
        self._rate = RateMeter(self.sample_rate)
        self._refusal: Text | None = None

    @property
    def lost(self) -> int:
        """Frames missing in the shirt's own count since it was opened."""
        return self._sequence.lost

    def open(self) -> None:
        """Open the socket.

        Raises
        ------
        HardwareError
            When the address is not of this machine, its port is in use, or the key is invalid.
        """
        self.close()
        self._sequence = Sequence()
        self.sender_choice = SenderChoice()
        self._lateness = Lateness()
        self.junk = self.repeated = self.late = self._boot = 0
        self._late_by = 0.0
        self._refusal = None
        self._watch = ArrivalWatch(self._clock.now())
        self._rate = RateMeter(self.sample_rate)
        if self._key_file is not None:
            self._open_key(self._key_file)
        self._socket = bound_socket(*self.address)
        self.address = (self.address[0], self._socket.getsockname()[1])

    def read(self, timeout: float) -> SensorFrame | None:
        """Return the next frame, waiting for it at most `timeout` (s); junk is counted and ignored."""
        now = self._clock.now()
        deadline = now + timeout
        wait = timeout
        while True:
            size = self._receive(wait)
            now = self._clock.now()
            if size < 0:
                return None
            packet = self._packet(size, now)
            if packet is not None:
                seq, microseconds, values = packet
                t_device = microseconds * 1e-6
                if not self._sequence.accept(seq):
                    self._watch.leave_out(LeftOut(now, "repeated"))
                elif self._key is None or self._is_in_time(microseconds, now):
                    self._watch.accept(now)
                    self._rate.add(seq, t_device)
                    return SensorFrame(seq, t_device, now, values)
            wait = deadline - now
            if wait <= 0.0:
                return None

    def _packet(self, size: int, now: float) -> Packet | None:
        """Return the frame in the buffer when it is good and the shirt's; otherwise count it and return None."""
        boot = 0
        if self._key is None:
            packet = decode(self._buffer, size, self._channels)
        else:
            boot, packet = decode_signed(self._buffer, size, self._channels, self._key) or (0, None)
        if packet is None:
            self.junk += 1
            self._refusal = refusal(self._buffer, size, self._channels, self._key)
            reason: ArrivalVerdict = "refused" if self._refusal.id in KEY_REFUSALS else "foreign"
            self._watch.leave_out(LeftOut(now, reason, size, self._sender))
            return None
        if self._newest is not None and not self._newest.is_new(boot, packet[0]):
            self.repeated += 1
            self._watch.leave_out(LeftOut(now, "repeated"))
            return None
        if not self.sender_choice.accept(self._sender, boot, now - self._watch.accepted_t > SHIRT_SENDER_SILENCE):
            self._watch.leave_out(LeftOut(now, "senders"))
            return None
        if self._newest is not None and not self._newest.accept(boot, packet[0]):
            self._watch.leave_out(LeftOut(now, "disk"))
            return None
        if boot != self._boot:
            self._boot = boot
            self._forget_device()
        return packet

    def _is_in_time(self, microseconds: int, now: float) -> bool:
        """Return whether a signed frame of this device time is not late at `now` (monotonic s); count it when it is.

        The clock of unsigned frames is not believed: anybody can write it, and a replay at another speed stretches it.
        """
        self._late_by = self._lateness.of(microseconds, now)
        if self._late_by:
            self.late += 1
            self._watch.leave_out(LeftOut(now, "late"))
        return not self._late_by

    def _forget_device(self) -> None:
        """Begin with the next frame, which another device sends, or the shirt after a restart."""
        self._sequence.forget()
        self._lateness.forget()

    def use_sender(self, name: str) -> bool:
        """Accept another sender as the shirt; False when none of this name (HOST:PORT) sent good frames."""
        if not self.sender_choice.use(name):
            return False
        self._forget_device()
        return True

    def lost_key(self) -> Text | None:
        """Return why the shirt's key counts no longer, None while it does; reads the key file."""
        return None if self._key is None or self._key_file is None else lost_key(self._key_file, self._key)

    def pending(self) -> bool:
        """Return whether a datagram has arrived already."""
        if self._socket is None:
            return False
        try:
            self._socket.recv_into(self._buffer, 1, socket.MSG_PEEK | socket.MSG_DONTWAIT)
        except OSError:
            return False
        return True

    def description(self) -> Text:
        """Return the shirt's state in words."""
        trouble = (self._newest.trouble if self._newest else None) or self._late_text() or self._refusal or "none"
        if self._socket is None:
            return Text("shirtdev-udp-closed", trouble=trouble)
        choice = self.sender_choice
        host, port = self.address
        common: dict[str, Value] = {
            "place": f"{host}:{port}",
            "sender": choice.name or "unknown",
            "trouble": trouble,
            "other": choice.other_frames,
            "stranger": choice.other,
            "repeated": self.repeated,
            "late": self.late,
        }
        if self._clock.now() - self._watch.accepted_t > ALIVE:
            return Text("shirtdev-udp-silent", **common)
        return Text("shirtdev-udp", sensors=self._channels, lost=self._sequence.lost, refused=self.junk, **common)

    def arrivals(self) -> Arrivals:
        """Return what arrives at the socket."""
        verdict: ArrivalVerdict = "gone" if self._socket is None else self._watch.verdict(self._clock.now())
        if verdict == "arrives" and self._rate.is_wrong:
            verdict = "rate"
        return Arrivals(verdict, self._arrival_text(verdict), self._watch.accepted, self._watch.left_out)

    def _arrival_text(self, verdict: ArrivalVerdict) -> Text:
        """Return a verdict in words, with what to do."""
        host, port = self.address
        newest, choice = self._watch.newest, self.sender_choice
        match verdict:
            case "gone":
                return self.description()
            case "nothing" if self._socket is not None:
                return Text("arrivals-udp-nothing", place=f"{host}:{port}", port=port, reach=reach_of(self._socket))
            case "foreign" | "refused" if self._refusal is not None and newest.sender is not None:
                sender = address_text(newest.sender)
                return Text("arrivals-foreign", count=self.junk, size=newest.size, sender=sender, why=self._refusal)
            case "late":
                why = Text("shirtdev-frame-late", delay=Figure(self._late_by, 1))
                return Text("arrivals-none-counts", why=why)
            case "disk" if self._newest is not None and self._newest.trouble is not None:
                return Text("arrivals-none-counts", why=self._newest.trouble)
            case "repeated":
                return Text("arrivals-none-counts", why=Text("arrivals-repeated"))
            case "senders" if choice.other:
                return Text("arrivals-senders", sender=choice.name, stranger=choice.other)
            case "rate":
                return Text("arrivals-rate", measured=round(self._rate.rate), expected=round(self.sample_rate, 2))
            case _:
                return GOOD if verdict == "arrives" else WAITING

    def _late_text(self) -> Text | None:
        """Return why the newest frame is left out when it came late, None when it did not."""
        return Text("shirtdev-frame-late", delay=Figure(self._late_by, 1)) if self._late_by else None

    def close(self) -> None:
        """Close the socket; closing twice does no harm."""
        if self._socket is not None:
            self._socket.close()
            self._socket = None
        if self._newest is not None:
            self._newest.close()
            self._newest = None
        self._timeout = -1.0

    def _receive(self, wait: float) -> int:
        """Return the size of the next datagram in the buffer, -1 when none came within `wait` (s)."""
        if self._socket is None:
            self._clock.sleep_until(self._clock.now() + wait)
            return -1
        flags = 0
        if wait <= 0.0:
            flags = socket.MSG_DONTWAIT
        elif wait == self._wait:
            self._set_timeout(wait)
        elif wait != self._timeout:
            # The kernel rounds its own timeout to ticks of up to 10 ms, too coarse for waits that differ each time.
            self._wait = wait
            flags = socket.MSG_DONTWAIT
            if not select.select([self._socket], [], [], wait)[0]:
                return -1
        try:
            size, self._sender = self._socket.recvfrom_into(self._buffer, 0, flags)
        except (BlockingIOError, ConnectionError):
            return -1
        return size

    def _set_timeout(self, wait: float) -> None:
        """Set the kernel's timeout: it costs one system call a frame, a timeout of Python's costs two."""
        if self._socket is not None and wait != self._timeout:
            seconds, fraction = divmod(max(wait, 1e-6), 1.0)
            self._socket.setsockopt(
                socket.SOL_SOCKET, socket.SO_RCVTIMEO, _TIME.pack(int(seconds), int(fraction * 1e6))
            )
            self._timeout = wait

    def _open_key(self, file: Path) -> None:
        try:
            self._key = read_key(file)
        except KeyRefused as refused:
            raise HardwareError(Text("shirtdev-not-opened", problem=refusal_text(refused))) from refused
        newest = NewestFrame(newest_file(file), math.ceil(WRITE_AHEAD * self.sample_rate))
        newest.open()
        self._newest = newest


KIND = ShirtKind(UdpConfig, UdpShirt, Trust.WITH_KEY)

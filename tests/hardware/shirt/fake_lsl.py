"""A network of LSL streams without a network: the part of pylsl that the program uses, on a fake clock."""

from collections import deque
from itertools import count
from threading import current_thread, main_thread


class LostError(RuntimeError):
    """As pylsl raises when the sender has ended."""


class FakeElement:
    """An element of a description."""

    def __init__(self, name="", text="", beside=()):
        self.name, self.text, self.children = name, text, []
        self._beside = beside

    def empty(self):
        return not self.name

    def child(self, name):
        return next((child for child in self.children if child.name == name), FakeElement())

    def next_sibling(self, name):
        after = self._beside[self._beside.index(self) + 1 :]
        return next((child for child in after if child.name == name), FakeElement())

    def child_value(self, name):
        return self.child(name).text

    def append_child(self, name):
        self.children.append(FakeElement(name, beside=self.children))
        return self.children[-1]

    def append_child_value(self, name, value):
        self.append_child(name).text = value
        return self


class FakeInfo:
    """What a stream says of itself, as pylsl has it."""

    def __init__(self, name="", type="", channel_count=1, nominal_srate=0.0, channel_format=1, source_id=""):  # noqa: A002
        self._facts = name, type, channel_count, nominal_srate, channel_format, source_id
        self.host, self.start = "lab", "0"
        self.description = FakeElement("desc")

    def name(self):
        return self._facts[0]

    def type(self):
        return self._facts[1]

    def channel_count(self):
        return self._facts[2]

    def nominal_srate(self):
        return self._facts[3]

    def channel_format(self):
        return self._facts[4]

    def source_id(self):
        return self._facts[5]

    def hostname(self):
        return self.host

    def uid(self):
        return self.start

    def desc(self):
        return self.description


class FakeSender:
    """A sender whose clock is `clock_ahead` (s) ahead of this machine's, and may `drift` (s per s)."""

    def __init__(self, lsl, info, clock_ahead=0.0, drift=0.0):
        self.lsl, self.info = lsl, info
        self.clock_ahead, self.drift = clock_ahead, drift
        self.alive, self.answers = True, True
        self.inlets = []

    def ahead(self):
        return self.clock_ahead + self.drift * self.lsl.local_clock()

    def send(self, values, t=None, *, late=0.0, stamp=None):
        """Send a sample that was measured at `t` (s, of the fake clock) and arrives `late` (s) after that."""
        t = self.lsl.clock.now() if t is None else t
        stamp = t + self.lsl.offset + self.ahead() if stamp is None else stamp
        for inlet in self.inlets:
            inlet.queue.append((t + late, tuple(values), stamp))

    def end(self):
        self.alive = False
        self.lsl.senders.remove(self)


class FakeInlet:
    """Receives from one sender."""

    def __init__(self, lsl, info, **options):
        self.lsl, self.options = lsl, options
        self.sender = next(sender for sender in lsl.senders if sender.info is info)
        self.queue = deque()

    def info(self, _timeout):
        return self.sender.info

    def open_stream(self, timeout):
        self._require(timeout)
        self.sender.inlets.append(self)

    def time_correction(self, timeout):
        self._require(timeout)
        return -self.sender.ahead()

    def pull_sample(self, timeout):
        self._require_alive()
        now = self.lsl.clock.now()
        if not self.queue or self.queue[0][0] > now + timeout:
            self.lsl.clock.sleep_until(now + timeout)
            return None, None
        arrival, values, stamp = self.queue.popleft()
        self.lsl.clock.sleep_until(arrival)
        return list(values), stamp

    def pull_chunk(self, timeout, max_samples):
        self._require_alive()
        assert timeout == 0.0, "a chunk that is waited for comes when it is full"
        samples, stamps = [], []
        while self.samples_available() and len(samples) < max_samples:
            _, values, stamp = self.queue.popleft()
            samples.append(list(values))
            stamps.append(stamp)
        return samples, stamps

    def samples_available(self):
        return sum(arrival <= self.lsl.clock.now() for arrival, *_ in self.queue)

    def _require_alive(self):
        if not self.sender.alive:
            raise LostError("the stream has been lost.")

    def _require(self, timeout):
        self._require_alive()
        if not self.sender.answers:
            self.lsl.clock.sleep_until(self.lsl.clock.now() + timeout)
            raise RuntimeError("the operation failed due to a timeout.")


class FakeOutlet:
    """Sends one stream of the program: keeps what was sent."""

    def __init__(self, lsl, info, **options):
        self.info, self.options = info, options
        self.sent = []  # (time stamp, values)
        self.consumers = True
        lsl.outlets.append(self)

    def push_chunk(self, x, timestamp):
        rows = [list(row) if not isinstance(row, str) else [row] for row in x]
        assert len(rows) == len(timestamp)
        assert all(len(row) == self.info.channel_count() for row in rows)
        self.sent += zip(timestamp, rows, strict=True)

    def have_consumers(self):
        return self.consumers


class FakeLsl:
    """The module pylsl, whose clock is `offset` (s) ahead of the fake clock."""

    cf_float32, cf_double64, cf_string = 1, 2, 3

    def __init__(self, clock, offset=5000.0):
        self.clock, self.offset = clock, offset
        self.senders, self.outlets = [], []
        self.StreamInfo = FakeInfo
        self._starts = count(1)

    def StreamInlet(self, info, **options):  # noqa: N802
        return FakeInlet(self, info, **options)

    def StreamOutlet(self, info, **options):  # noqa: N802
        return FakeOutlet(self, info, **options)

    def local_clock(self):
        return self.clock.now() + self.offset

    def resolve_streams(self, wait_time):
        if current_thread() is main_thread():  # a search beside the loop does not advance its clock
            self.clock.sleep_until(self.clock.now() + wait_time)
        return [sender.info for sender in self.senders]

    def add_sender(self, name="Arm", channels=3, rate=100.0, *, kind="MoCap", source_id="arm-1", host="lab", form=1,
                   labels=(), units=(), joints=(), **clock):  # fmt: skip
        """Start a sender of this network."""
        info = FakeInfo(name, kind, channels, rate, form, source_id)
        info.host, info.start = host, f"start {next(self._starts)}"
        described = info.description.append_child("channels")
        for i in range(max(map(len, (labels, units, joints)))):
            channel = described.append_child("channel")
            for fact, values in (("label", labels), ("unit", units), ("joint", joints)):
                if values:
                    channel.append_child_value(fact, values[i])
        self.senders.append(FakeSender(self, info, **clock))
        return self.senders[-1]

"""The page on a phone that is a sensor, for tests: its messages, numbered and with its own clock."""

from app.hardware.shirt.orientation_sensors.phones import MESSAGE, VERSION


class PhonePage:
    """Sends how the phone is held; `ahead` (s) is what its clock is ahead of ours."""

    def __init__(self, shirt, clock, number=1, page=77, ahead=500.0):
        self.angles = (0.0, 0.0, 0.0)
        self.number = number
        self._shirt, self._clock, self._page, self._ahead = shirt, clock, page, ahead
        self._seq = 0

    def delay_clock(self, seconds):
        """Let the clock of the page stand for so long (s)."""
        self._ahead -= seconds

    def message(self, sent_t=None):
        """Return the next message."""
        self._seq += 1
        sent_t = self._clock.now() + self._ahead if sent_t is None else sent_t
        return MESSAGE.pack(VERSION, 0, 0, self._page, self._seq - 1, sent_t, *self.angles)

    def send(self, delay=0.0):
        """Send a message that was `delay` (s) on its way."""
        message = self.message(self._clock.now() - delay + self._ahead)
        self._shirt.add_sample(self.number, message, self._clock.now())

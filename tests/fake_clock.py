"""A clock whose time advances only when somebody waits."""


class FakeClock:
    """A clock as `app.clock.Clock`, without waiting."""

    def __init__(self, start: float = 0.0) -> None:
        self.time = start

    def now(self) -> float:
        """Return the clock's time (s)."""
        return self.time

    def sleep_until(self, deadline: float) -> None:
        """Advance the time to `deadline` at once."""
        self.time = max(self.time, deadline)

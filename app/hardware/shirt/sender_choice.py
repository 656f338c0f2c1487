"""Choose which sender is the shirt: that of the first good frame, until a person chooses another (safety S23)."""

MOST = 8  # other senders whose addresses are kept; frames of more senders are only counted
SHIRT_SENDER_SILENCE = 2.0  # s until another sender is accepted: longer than a shirt may be silent while armed (S4)

Address = tuple[str, int] | tuple[str, int, int, int]
"""A sender as a socket returns it: host and port first."""


class SenderChoice:
    """One sender is the shirt; the frames of all others are counted and ignored.

    Attributes
    ----------
    other_frames : int
        Good frames of other senders since the shirt was opened or another sender was chosen.
    """

    __slots__ = ("_boot", "_current", "_frames", "other_frames")

    def __init__(self) -> None:
        self.other_frames = 0
        self._current: Address | None = None
        self._boot = 0
        self._frames: dict[Address, int] = {}  # other senders, and the number of good frames from each

    @property
    def name(self) -> str:
        """The shirt's address, empty before its first frame."""
        return "" if self._current is None else address_text(self._current)

    @property
    def other(self) -> str:
        """The address of the other sender that sent most, empty when there is none."""
        return address_text(max(self._frames, key=lambda address: self._frames[address])) if self._frames else ""

    def accept(self, address: Address, boot: int, silent: bool) -> bool:
        """Return whether a good frame from `address` is the shirt's.

        `boot` is the boot counter of a signed frame, 0 of an unsigned one. A device with the same key that was started
        again may send from another address, but only after the previous sender was `silent` for so long that nothing
        is armed.
        """
        if address == self._current or self._current is None or (boot > self._boot and silent):
            self._current, self._boot = address, boot
            return True
        self.other_frames += 1
        if address in self._frames or len(self._frames) < MOST:
            self._frames[address] = self._frames.get(address, 0) + 1
        return False

    def use(self, name: str) -> bool:
        """Accept another sender as the shirt, by its name; False when none of this name sent good frames."""
        for address in self._frames:
            if address_text(address) == name:
                self._current, self._boot = address, 0
                self._frames.clear()
                self.other_frames = 0
                return True
        return False


def address_text(address: Address) -> str:
    """Return an address as HOST:PORT, an IPv6 host in brackets."""
    host, port = address[:2]
    return f"[{host}]:{port}" if ":" in host else f"{host}:{port}"

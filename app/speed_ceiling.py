"""The speeds that nothing here exceeds: no limit that somebody sets, and no chair's receiver.

Standard library only: the receiver runs on the chair's board.
"""

from typing import Final

HIGHEST_SPEED: Final = 1.5  # m/s
HIGHEST_TURN_RATE: Final = 2.5  # rad/s

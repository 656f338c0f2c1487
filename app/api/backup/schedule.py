"""When the backup of the night is due."""

from datetime import datetime, timedelta
from typing import Final

AGAIN_AFTER: Final = timedelta(hours=1)  # a backup that failed is tried again


def is_due(now: datetime, hour: int, last_good: datetime | None, last_try: datetime | None) -> bool:
    """Return whether there was no good backup since the last time that the clock showed `hour`.

    Of a machine that was off in the night, it is due when the machine is on again. All moments are in the local zone.
    """
    at_hour = now.replace(hour=hour, minute=0, second=0, microsecond=0)
    scheduled = at_hour if at_hour <= now else at_hour - timedelta(days=1)
    if last_good is not None and last_good >= scheduled:
        return False
    return last_try is None or now - last_try >= AGAIN_AFTER

"""The name of a file that the program gives to a browser."""

from datetime import datetime


def download_name(what: str, made: datetime, ending: str) -> str:
    """Return the name of a file that was made at `made` (UTC); `what` names no person, `ending` has no dot."""
    return f"bodydrive-{what}-{made:%Y%m%dT%H%M%SZ}.{ending}"

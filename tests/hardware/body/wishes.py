"""What a simulated driver wants."""

from app.hardware.body.steering import Intention


def wished(intention: Intention | None) -> str:
    """Return the wish of a driver who wants something."""
    assert intention is not None
    return intention.wish

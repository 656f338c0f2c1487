"""A network of ROS 2 on this machine alone, for tests."""

from threading import Event

from app.clock import monotonic

PATIENCE = 20.0  # s
THIS_MACHINE_ONLY = """<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast>
<Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces></General></Domain></CycloneDDS>"""

BETWEEN_PROCESSES = THIS_MACHINE_ONLY.replace(
    "</Domain>", '<Discovery><Peers><Peer Address="127.0.0.1"/></Peers></Discovery></Domain>'
)


def wait_until(condition):
    """Wait until a condition holds."""
    until, pause = monotonic() + PATIENCE, Event()
    while not condition():
        assert monotonic() < until, "it did not come to that in time"
        pause.wait(0.01)

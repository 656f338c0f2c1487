"""A blocking UDP echo: the shortest time from datagram to datagram in Python on this machine."""

import socket
import sys

from app.realtime import go_real_time


def main() -> None:
    """Print the port, then send back each datagram, with the scheduling of the control loop."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as echo:
        echo.bind(("127.0.0.1", 0))
        sys.stdout.write(f"{echo.getsockname()[1]}\n")
        sys.stdout.flush()
        go_real_time()
        while True:
            datagram, address = echo.recvfrom(2048)
            echo.sendto(datagram, address)


if __name__ == "__main__":
    main()

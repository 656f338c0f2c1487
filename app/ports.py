"""The standard ports: of the pages, and of devices that send or listen by UDP.

Standard library only: the receiver on a chair's board imports this module, too.
"""

from typing import Final

HTTP_PORT: Final = 8080  # for browsers on this machine, or a proxy
HTTPS_PORT: Final = 8443  # for other machines; the same at every start: home screens and bookmarks keep it

SHIRT_PORT: Final = 5252  # where this machine takes a shirt's frames
SLIMEVR_PORT: Final = 6969  # where trackers look for their server
OPENTRACK_PORT: Final = 4242  # as opentrack sends unless told otherwise
FREEPIE_PORT: Final = 5555  # as FreePIE does
RECEIVER_PORT: Final = 5354  # where the receiver on a chair's board listens

"""Whether this release of Python reads crafted zip and tar files safely: archives and backups are such files.

Mended in these releases: a zip file whose members overlap (CVE-2024-0450), tar headers that take very long to parse
(CVE-2024-6232), and tar members of negative size, on which the reader never ends (CVE-2025-8194).
"""

from typing import Final

from app.texts import Text

SAFE_FROM: Final[dict[tuple[int, int], int]] = {(3, 11): 14, (3, 12): 12, (3, 13): 6}
"""Version -> its first release in which all of them are mended; later versions have them mended from the beginning."""


def python_warning(version: tuple[int, int, int]) -> Text | None:
    """Return in one sentence which release of Python to install; None when this one is safe."""
    major, minor, release = version
    least = SAFE_FROM.get((major, minor))
    if least is None or release >= least:
        return None
    return Text("python-faulty", version=f"{major}.{minor}.{release}", least=f"{major}.{minor}.{least}")

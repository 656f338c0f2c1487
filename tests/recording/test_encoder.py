"""The encoder of a recording runs beside the control loop: it loads no library while somebody drives."""

import subprocess
import sys

ENCODE = """
import sys
import numpy as np
from app.messages import TICK
from app.recording.arrow import Encoder
before = set(sys.modules)
encoder = Encoder(b"{}", 52, 4)
encoder.schema()
encoder.batch(np.zeros(10, dtype=TICK))
print(*sorted({name.split(".")[0] for name in set(sys.modules) - before}))
"""


def test_the_first_rows_load_no_library():
    seen = subprocess.run([sys.executable, "-c", ENCODE], capture_output=True, text=True, check=True)
    assert seen.stdout.split() == []

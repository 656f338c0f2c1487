"""What holds for every test: generated cases have no deadline, and are the same ones on each run of CI."""

import os

from hypothesis import settings

settings.register_profile("bodydrive", deadline=None, derandomize=os.environ.get("CI") == "true")
settings.load_profile("bodydrive")

"""bodydrive: a body-machine interface for powered wheelchairs."""

__version__ = "0.2.0"

"""The reference of the application, for pages and modules that run without it."""

from pathlib import Path

from app.api.app import create_app
from app.api.routes.reference import reference_of
from app.computing_process import ComputingProcess
from app.process.supervisor import ControlProcess
from app.settings import Settings


def served_reference() -> str:
    """Return the answer to `GET /reference`, in JSON."""
    app = create_app(Settings(state=Path("unused")), ControlProcess.start, ComputingProcess())
    return reference_of(app).model_dump_json()

"""The layouts that are installed with the application, such as that of the paper's shirt with 52 channels."""

from pydantic import ValidationError

from app.hardware.base import HardwareError
from app.layout import ShirtLayout
from app.sentences import one_sentence
from app.settings import data_folder
from app.texts import Text

STANDARD_SHIRT = "bodydrive-52.json"


def standard_layout() -> ShirtLayout:
    """Return the layout of the paper's shirt, as `bundled_layout` does."""
    return bundled_layout(STANDARD_SHIRT)


def bundled_layout(name: str) -> ShirtLayout:
    """Return the layout of this file name that is installed with the application.

    Raises
    ------
    HardwareError
        When its file is missing or broken, so that the installation is incomplete.
    """
    file = data_folder() / "shirts" / name
    try:
        return ShirtLayout.model_validate_json(file.read_bytes())
    except OSError as error:
        raise HardwareError(Text("shirtdev-no-standard", file=str(file), why=error.strerror or "")) from error
    except ValidationError as error:
        raise HardwareError(one_sentence(error, str(file))) from error

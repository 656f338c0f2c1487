"""Reads a prior from its file."""

from pathlib import Path

from pydantic import TypeAdapter, ValidationError

from app.calibration.prior.documents import PriorDocument
from app.sentences import one_sentence
from app.texts import Text

PRIOR: TypeAdapter[PriorDocument] = TypeAdapter(PriorDocument)


def read_prior(path: Path) -> PriorDocument:
    """Return the prior in a file; raise ValueError with one sentence."""
    try:
        return PRIOR.validate_json(path.read_bytes())
    except ValidationError as error:
        raise ValueError(one_sentence(error, str(path))) from error
    except FileNotFoundError as error:
        raise ValueError(Text("calibration-prior-no-file", file=str(path))) from error
    except OSError as error:
        raise ValueError(Text("calibration-prior-unreadable", file=str(path), problem=str(error.strerror))) from error

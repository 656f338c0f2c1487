"""The drivers of all devices in tables, from kind to (module, class); a driver is imported when it is used."""

from collections.abc import Mapping
from enum import Enum
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple, cast

from pydantic import TypeAdapter, ValidationError

from app.clock import Clock
from app.hardware.base import Body, HardwareError, HeadTracker, Shirt
from app.hardware.configs import BodyConfig, ChairConfig, HeadConfig, RealChairConfig, ShirtConfig
from app.sentences import one_sentence

if TYPE_CHECKING:
    from app.hardware.chair.link import ChairLink


class ShirtDriver(NamedTuple):
    """The class of a kind of shirt, and whether the shirt is simulated."""

    module: str
    name: str
    simulated: bool  # nobody wears it: its drives are practice, and every record says so


Table = Mapping[str, tuple[str, str] | ShirtDriver]

SHIRTS: Mapping[str, ShirtDriver] = {
    "simulator": ShirtDriver("app.hardware.shirt.simulator", "SimulatedShirt", simulated=True),
    "replay": ShirtDriver("app.hardware.shirt.replay", "ReplayedShirt", simulated=True),
    "udp": ShirtDriver("app.hardware.shirt.udp", "UdpShirt", simulated=False),
}


class Trust(Enum):
    """Whether a source of frames may arm a real chair (safety S29)."""

    WIRED = "nobody but the shirt is on the line"
    WITH_KEY = "only where a key is paired"
    NEVER = "nobody wears it"


TRUST: Mapping[str, Trust] = {
    "simulator": Trust.NEVER,
    "replay": Trust.NEVER,
    "udp": Trust.WITH_KEY,
}
"""The trust in each kind of `SHIRTS`; a kind that is missing here arms no real chair."""

NOBODY_WEARS_IT = (
    "A simulated or played shirt arms no real chair, for nobody wears it: choose the shirt on the Shirt page."
)
NO_KEY = (
    "A shirt without a key arms no real chair, for anybody on the network could send its frames: pair it "
    "(bodydrive shirt pair), then choose its key on the Shirt page."
)

BODIES: Table = {
    "person": ("app.hardware.body.person", "SimulatedPerson"),
    "visitor": ("app.hardware.body.visitor", "Visitor"),
    "recorded": ("app.hardware.body.recorded", "RecordedBody"),
}
CHAIRS: Table = {
    "virtual": ("app.hardware.chair.simulator", "VirtualChair"),
    "udp": ("app.hardware.chair.link", "ChairLink"),
}
HEADS: Table = {
    "opentrack": ("app.hardware.head.opentrack", "Opentrack"),
    "freepie": ("app.hardware.head.freepie", "Freepie"),
    "flock_of_birds": ("app.hardware.head.flock_of_birds", "FlockOfBirds"),
    "simulator": ("app.hardware.head.simulator", "SimulatedHead"),
    "recorded": ("app.hardware.head.recorded", "RecordedHead"),
    "tablet": ("app.hardware.head.tablet", "TabletHead"),
}


def driver_class(what: str, word: str, table: Table) -> Any:
    """Return the class of the kind `word` in `table`; `what` ("shirt", "chair" ...) names the device in sentences.

    Raises
    ------
    HardwareError
        For an unknown kind, a missing module or library, and a missing class, each with its own sentence.
    """
    if word not in table:
        raise HardwareError(f"there is no {what} of the kind '{word}': use one of {', '.join(table)}")
    module, name = table[word][:2]
    try:
        found = import_module(module)
    except ModuleNotFoundError as error:
        if error.name and error.name.partition(".")[0] != "app":
            raise HardwareError(
                f"the {what} '{word}' needs the library '{error.name}', which is not installed: install it"
            ) from error
        raise HardwareError(
            f"the driver {module} of the {what} '{word}' is missing from this installation: install bodydrive again"
        ) from error
    try:
        return getattr(found, name)
    except AttributeError as error:
        raise HardwareError(
            f"the driver {module} of the {what} '{word}' has no class {name}: correct its table in app/hardware"
        ) from error


def mistrust(config: ShirtConfig) -> str:
    """Return in a sentence why this shirt arms no real chair; empty when it may."""
    trust = TRUST.get(config.kind, Trust.NEVER)
    if trust is Trust.WIRED:
        return ""
    if trust is Trust.WITH_KEY:
        return "" if getattr(config, "key_file", None) else NO_KEY
    return NOBODY_WEARS_IT


def parse_shirt(document: object) -> ShirtConfig:
    """Return the shirt configuration in `document` (JSON values), or raise HardwareError with one sentence."""
    return cast(ShirtConfig, _parse("shirt", document, SHIRTS, TypeAdapter(ShirtConfig)))


def parse_body(document: object) -> BodyConfig:
    """Return the body configuration in `document` (JSON values), or raise HardwareError with one sentence."""
    return cast(BodyConfig, _parse("body", document, BODIES, TypeAdapter(BodyConfig)))


def parse_chair(document: object) -> ChairConfig:
    """Return the chair configuration in `document` (JSON values), or raise HardwareError with one sentence."""
    return cast(ChairConfig, _parse("chair", document, CHAIRS, TypeAdapter(ChairConfig)))


def parse_head(document: object) -> HeadConfig:
    """Return the head tracker's configuration in `document` (JSON values), or raise HardwareError with one sentence."""
    return cast(HeadConfig, _parse("head tracker", document, HEADS, TypeAdapter(HeadConfig)))


def make_head(config: HeadConfig, clock: Clock) -> HeadTracker:
    """Return the head tracker that `config` describes, not yet open; raise HardwareError without its driver."""
    return cast(HeadTracker, driver_class("head tracker", config.kind, HEADS)(config, clock))


def make_shirt(config: ShirtConfig, clock: Clock) -> Shirt:
    """Return the shirt that `config` describes, not yet open; raise HardwareError without its driver."""
    return cast(Shirt, driver_class("shirt", config.kind, SHIRTS)(config, clock))


def make_body(config: BodyConfig) -> Body:
    """Return the body that `config` describes, at rest; each class takes the fields of its configuration.

    Raises
    ------
    HardwareError
        Without its driver, or when its file cannot be read.
    """
    made = driver_class("body", config.kind, BODIES)
    return cast(Body, made(**config.model_dump(exclude={"kind"})))


def make_real_chair(config: RealChairConfig) -> "ChairLink":
    """Return the chair link that `config` describes, not yet open; raise HardwareError without its driver."""
    return cast("ChairLink", driver_class("chair", config.kind, CHAIRS)(config))


def _parse(what: str, document: object, table: Table, adapter: TypeAdapter[Any]) -> object:
    kind = document.get("kind") if isinstance(document, Mapping) else None
    if not isinstance(kind, str):
        raise HardwareError(f'a {what} configuration needs a "kind": give one of {", ".join(table)}')
    if kind not in table:
        raise HardwareError(f"there is no {what} of the kind '{kind}': use one of {', '.join(table)}")
    try:
        return adapter.validate_python(document)
    except ValidationError as error:
        raise HardwareError(one_sentence(error, f"{what} configuration")) from error

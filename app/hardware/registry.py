"""Makes devices of their configurations, and configurations of documents.

A shirt's driver stands with its configuration (`app.hardware.configs.SHIRTS`). Those of other devices stand in tables
here, from kind to (module, class), and are imported when they are used.
"""

from collections.abc import Callable, Mapping
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, cast

from pydantic import TypeAdapter, ValidationError

from app.clock import Clock
from app.hardware.base import Body, HardwareError, HeadTracker, Shirt
from app.hardware.configs import SHIRTS, BodyConfig, ChairConfig, HeadConfig, RealChairConfig
from app.hardware.shirt.kind import ShirtConfig
from app.sentences import one_sentence
from app.texts import Text

if TYPE_CHECKING:
    from app.hardware.chair.link import ChairLink


Table = Mapping[str, tuple[str, str]]
Role = Literal["shirt", "body", "chair", "head"]

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


def driver_class(role: Role, kind: str, table: Table) -> Callable[..., object]:
    """Return the class of the driver of `kind` in `table`, the table of this role.

    Raises
    ------
    HardwareError
        For an unknown kind, a missing module or library, and a missing class, each with its own sentence.
    """
    if kind not in table:
        raise HardwareError(_unknown_kind(role, kind, table))
    module, name = table[kind]
    try:
        driver = import_module(module)
    except ModuleNotFoundError as error:
        if error.name and error.name.partition(".")[0] != "app":
            raise HardwareError(Text("device-no-library", device=role, kind=kind, library=error.name)) from error
        raise HardwareError(Text("device-no-driver", device=role, kind=kind, driver=module)) from error
    try:
        return cast(Callable[..., object], getattr(driver, name))
    except AttributeError as error:
        raise HardwareError(Text("device-no-class", driver=module, name=name)) from error


def parse_shirt(document: object) -> ShirtConfig:
    """Return the shirt configuration in `document` (JSON values), or raise HardwareError with one sentence."""
    kind = SHIRTS[_kind_of("shirt", document, SHIRTS)]
    return cast(ShirtConfig, _parse("shirt configuration", document, TypeAdapter(kind.config)))


def parse_body(document: object) -> BodyConfig:
    """Return the body configuration in `document` (JSON values), or raise HardwareError with one sentence."""
    _kind_of("body", document, BODIES)
    return cast(BodyConfig, _parse("body configuration", document, TypeAdapter(BodyConfig)))


def parse_chair(document: object) -> ChairConfig:
    """Return the chair configuration in `document` (JSON values), or raise HardwareError with one sentence."""
    _kind_of("chair", document, CHAIRS)
    return cast(ChairConfig, _parse("chair configuration", document, TypeAdapter(ChairConfig)))


def parse_head(document: object) -> HeadConfig:
    """Return the head tracker's configuration in `document` (JSON values), or raise HardwareError with one sentence."""
    _kind_of("head", document, HEADS)
    return cast(HeadConfig, _parse("head tracker configuration", document, TypeAdapter(HeadConfig)))


def make_head(config: HeadConfig, clock: Clock) -> HeadTracker:
    """Return the head tracker that `config` describes, not yet open; raise HardwareError without its driver."""
    return cast(HeadTracker, driver_class("head", config.kind, HEADS)(config, clock))


def make_shirt(config: ShirtConfig, clock: Clock) -> Shirt:
    """Return the shirt that `config` describes, not yet open."""
    return SHIRTS[config.kind].driver(config, clock)


def make_body(config: BodyConfig) -> Body:
    """Return the body that `config` describes, at rest; each class takes the fields of its configuration.

    Raises
    ------
    HardwareError
        Without its driver, or when its file cannot be read.
    """
    body = driver_class("body", config.kind, BODIES)
    return cast(Body, body(**config.model_dump(exclude={"kind"})))


def make_real_chair(config: RealChairConfig) -> "ChairLink":
    """Return the chair link that `config` describes, not yet open; raise HardwareError without its driver."""
    return cast("ChairLink", driver_class("chair", config.kind, CHAIRS)(config))


def _kind_of(role: Role, document: object, table: Mapping[str, object]) -> str:
    """Return the kind that `document` names, or raise HardwareError when `table` has no such kind."""
    kind = document.get("kind") if isinstance(document, Mapping) else None
    if not isinstance(kind, str):
        raise HardwareError(Text("device-needs-kind", device=role, kinds=", ".join(table)))
    if kind not in table:
        raise HardwareError(_unknown_kind(role, kind, table))
    return kind


def _unknown_kind(role: Role, kind: str, table: Mapping[str, object]) -> Text:
    return Text("device-unknown-kind", device=role, kind=kind, kinds=", ".join(table))


def _parse(name: str, document: object, adapter: TypeAdapter[Any]) -> object:
    try:
        return adapter.validate_python(document)
    except ValidationError as error:
        raise HardwareError(one_sentence(error, name)) from error

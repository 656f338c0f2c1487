"""What a kind of shirt consists of: its configuration, its driver, and whether its frames may arm a real chair."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Annotated, Generic, TypeVar, get_args

from pydantic import ConfigDict, Field

from app.clock import Clock
from app.hardware.addresses import FilePlace
from app.hardware.base import Shirt
from app.layout import ShirtLayout
from app.quantities import Document, Hertz

NOBODY_WEARS_IT = (
    "A simulated or played shirt arms no real chair, for nobody wears it: choose the shirt on the Shirt page."
)
NOBODY_PROVES_IT = (
    "This source arms no real chair, for nothing proves whose movements it shows: choose the shirt on the Shirt page."
)
NO_KEY = (
    "A shirt without a key arms no real chair, for anybody on the network could send its frames: pair it "
    "(bodydrive shirt pair), then choose its key on the Shirt page."
)


class Trust(Enum):
    """Whether a kind of shirt may arm a real chair (safety S29)."""

    WIRED = "yes: nobody but the shirt is on the line"
    WITH_KEY = "only where a key is paired"
    NEVER = "no: nobody wears it, or nothing proves who sends"


class ShirtConfig(Document):
    """The configuration of a shirt, without the fields that each kind adds.

    The form on the Shirt page is made of the JSON schema (docs/drivers.md): the class's docstring stands below its
    title, and each field has its title, its description as a hint, and its bounds.
    """

    kind: str


def page_texts(title: str, in_use: str) -> ConfigDict:
    """Return the part of a `model_config` with the texts of the Shirt page.

    Parameters
    ----------
    title : str
        The name of the kind, where shirts are chosen.
    in_use : str
        The shirt in use in one line; `{NAME}` stands for the value of a field.
    """
    return ConfigDict(title=title, json_schema_extra={"in_use": in_use})


ShirtRate = Annotated[Hertz, Field(ge=10, le=2000, title="Frames a second")]
SignalFile = Annotated[FilePlace, Field(title="File", json_schema_extra={"format": "signal-file"})]
"""The name of a file of signals, or of a recording, that lies on this machine."""
ShirtKey = Annotated[
    FilePlace | None,
    Field(
        title="Key",
        description=(
            "Only a shirt with a key may drive a real chair. “bodydrive shirt pair” on this machine makes one."
        ),
        json_schema_extra={"format": "shirt-key"},
    ),
]
"""The key file of a paired shirt; None: frames are not signed."""
LayoutFile = Annotated[
    ShirtLayout,
    Field(
        title="Layout",
        description="A JSON file that names the sensors. Without one, the layout in use now is kept.",
        json_schema_extra={"format": "layout"},
    ),
]
"""A layout that people bring as a JSON file."""

Config = TypeVar("Config", bound=ShirtConfig)


@dataclass(frozen=True, slots=True)
class ShirtKind(Generic[Config]):
    """One kind of shirt; a kind that declares no trust arms no real chair."""

    config: type[Config]
    driver: Callable[[Config, Clock], Shirt]
    trust: Trust = Trust.NEVER
    simulated: bool = False  # nobody wears it: its drives are practice, and every record says so

    @property
    def name(self) -> str:
        """The kind's name in configurations and recordings."""
        return str(get_args(self.config.model_fields["kind"].annotation)[0])

    @property
    def is_on_network(self) -> bool:
        """Whether others could send frames to it, so that people choose the sender (`NetworkShirt`)."""
        return hasattr(self.driver, "use_sender")

    def fields_of(self, form: str) -> list[str]:
        """Return the names of the fields whose schema has this `format`, such as `signal-file`."""
        extras = {name: field.json_schema_extra for name, field in self.config.model_fields.items()}
        return [name for name, extra in extras.items() if isinstance(extra, dict) and extra.get("format") == form]

    def mistrust(self, config: Config) -> str:
        """Return in a sentence why a shirt of this configuration arms no real chair; empty when it may."""
        if self.trust is Trust.WIRED:
            return ""
        if self.trust is Trust.WITH_KEY:
            is_paired = any(getattr(config, name) is not None for name in self.fields_of("shirt-key"))
            return "" if is_paired else NO_KEY
        return NOBODY_WEARS_IT if self.simulated else NOBODY_PROVES_IT

"""What a kind of shirt consists of: its configuration, its driver, and whether its frames may arm a real chair."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum
from typing import Annotated, Any, Generic, NamedTuple, TypeVar, get_args

from pydantic import AfterValidator, ConfigDict, Field, GetJsonSchemaHandler
from pydantic.config import JsonDict
from pydantic_core import CoreSchema

from app.clock import Clock
from app.hardware.addresses import Cable, FilePlace
from app.hardware.base import Shirt
from app.hardware.cables import is_cable
from app.layout import ShirtLayout
from app.quantities import Document, Hertz
from app.texts import Text

NOBODY_WEARS_IT = Text("shirtdev-nobody-wears")
NOBODY_PROVES_IT = Text("shirtdev-nobody-proves")
NO_KEY = Text("shirtdev-no-key")
LOWEST_RATE, HIGHEST_RATE = 10.0, 2000.0  # Hz
NO_CABLE = Text("shirtdev-no-cable")


class Trust(Enum):
    """Whether a kind of shirt may arm a real chair (safety S29)."""

    WIRED = "where its line is a cable: nobody but the shirt is on it"
    WITH_KEY = "only where a key is paired"
    NEVER = "no: nobody wears it, or nothing proves who sends"


MAY_ARM = {
    Trust.WIRED: Text("shirtdev-chair-wired"),
    Trust.WITH_KEY: Text("shirtdev-chair-with-key"),
    Trust.NEVER: Text("shirtdev-chair-nobody-proves"),
}
"""Whether a kind of worn shirt may drive a real chair, with the reason, where shirts are chosen."""


class SourceFacts(NamedTuple):
    """What people want to know of a kind of shirt before they choose it."""

    needs: Text | str
    costs: Text | str
    takes: Text | str  # how long until its signals are there


class ShirtConfig(Document):
    """The configuration of a shirt, without the fields that each kind adds.

    The form on the Shirt page is made of the JSON schema (docs/drivers.md): what the kind is stands below its title,
    and each field has its title, its description as a hint, and its bounds.
    """

    kind: str


class WiredConfig(ShirtConfig):
    """The configuration of a shirt on a cable: it arms a real chair where its line is one."""

    device: Cable


def page_texts(
    title: Text | str, *, in_use: Text | str, about: Text | None = None, facts: SourceFacts | None = None
) -> ConfigDict:
    """Return the part of a `model_config` with the texts of the Shirt page, in the language of its reader.

    Parameters
    ----------
    title : Text or str
        The name of the kind, where shirts are chosen. A driver outside of the catalogue gives strings.
    in_use : Text or str
        The shirt in use in one line; `{NAME}` stands for the value of a field.
    about : Text or None
        What the kind is, in one line; None: the class's docstring.
    facts : SourceFacts or None
        What it needs and costs, and how long it takes; None: the page does not say.
    """

    def add(schema: JsonDict) -> None:
        schema |= {"title": str(title), "in_use": str(in_use)}
        if about is not None:
            schema["description"] = str(about)
        if facts is not None:
            schema["facts"] = {name: str(text) for name, text in facts._asdict().items()}

    return ConfigDict(json_schema_extra=add)


@dataclass(frozen=True, slots=True)
class FieldTexts:
    """Marks the type of a field with its title and its hint on the Shirt page, in the language of its reader."""

    title: Text
    hint: Text | None = None

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        """Return the JSON schema of the field."""
        texts = {"title": str(self.title)} | ({} if self.hint is None else {"description": str(self.hint)})
        return handler(schema) | texts


ShirtRate = Annotated[Hertz, Field(ge=LOWEST_RATE, le=HIGHEST_RATE), FieldTexts(Text("shirtdev-rate"))]
SignalFile = Annotated[FilePlace, Field(json_schema_extra={"format": "signal-file"}), FieldTexts(Text("shirtdev-file"))]
"""The name of a file of signals, or of a recording, that lies on this machine."""
ShirtKey = Annotated[
    FilePlace | None,
    Field(json_schema_extra={"format": "shirt-key"}),
    FieldTexts(Text("shirtdev-key"), Text("shirtdev-key-hint")),
]
"""The key file of a paired shirt; None: frames are not signed."""
OwnLayout = Annotated[ShirtLayout, AfterValidator(lambda layout: layout.without_liveness)]
"""A layout that people bring; whatever it says, the driver watches over no sensor (safety S5)."""
LayoutFile = Annotated[
    OwnLayout,
    Field(json_schema_extra={"format": "layout"}),
    FieldTexts(Text("shirtdev-layout"), Text("shirtdev-layout-hint")),
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

    @property
    def may_arm(self) -> Text:
        """Whether a shirt of this kind may drive a real chair, with the reason."""
        return Text("shirtdev-chair-nobody-wears") if self.simulated else MAY_ARM[self.trust]

    def fields_of(self, form: str) -> list[str]:
        """Return the names of the fields whose schema has this `format`, such as `signal-file`."""
        extras = {name: field.json_schema_extra for name, field in self.config.model_fields.items()}
        return [name for name, extra in extras.items() if isinstance(extra, dict) and extra.get("format") == form]

    def title_of(self, field: str) -> Text | None:
        """Return the title of a field on the Shirt page, None when it has none in the catalogue."""
        texts = (one.title for one in self.config.model_fields[field].metadata if isinstance(one, FieldTexts))
        return next(texts, None)

    def mistrust(self, config: Config) -> Text | None:
        """Return why a shirt of this configuration arms no real chair; None when it may."""
        if self.trust is Trust.WIRED:
            return None if isinstance(config, WiredConfig) and is_cable(config.device) else NO_CABLE
        if self.trust is Trust.WITH_KEY:
            is_paired = any(getattr(config, name) is not None for name in self.fields_of("shirt-key"))
            return None if is_paired else NO_KEY
        return NOBODY_WEARS_IT if self.simulated else NOBODY_PROVES_IT

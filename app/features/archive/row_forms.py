"""The form of each row that an archive may hold: every value and every document in it, by the model that wrote it.

A column has the form of its type: numbers are strict, finite and bounded, texts visible, moments of this age. The
columns that hold documents, words of a fixed set or names stand below. What fits is stored as it is.
"""

import json
from collections.abc import Mapping
from datetime import UTC, date, datetime
from functools import cache
from typing import Annotated, Any, Final, Literal, TypeAlias

from pydantic import AfterValidator, AwareDatetime, Field, TypeAdapter, ValidationError, create_model
from sqlalchemy import Boolean, Column, Date, Float, Integer
from sqlalchemy import Table as SqlTable

from app.calibration.adaptation.proposal_document import JointChange
from app.calibration.profile import CalibrationProfile
from app.calibration.vocabulary import DriveParameters, SetTitle
from app.json_values import JsonDocument
from app.layout import ShirtLayout
from app.quantities import Count, Document, Finite, Line, Name, Note
from app.scoring.control_quality import ControlQuality
from app.scoring.interface_test.interface_measures import InterfaceMeasures
from app.scoring.interface_test.workload import Workload
from app.scoring.trial_measures import TrialMeasures
from app.store.patient_screens import ScreenSettings
from app.store.tables import DriveEnding, InterfaceTestEnding, Moment, TrialEnding
from app.texts import Text, text_of
from app.world.cursor_task import CursorPlan
from app.world.floorplan import Polyline
from app.world.path import Path

SqlColumn: TypeAlias = Column[Any]
Form: TypeAlias = Any
"""An annotation of pydantic: a model, a `Literal`, an `Annotated` type. There is no type for these."""

EARLIEST, LATEST = datetime(1970, 1, 2, tzinfo=UTC), datetime(2200, 1, 1, tzinfo=UTC)


def _of_this_age(moment: datetime) -> datetime:
    if not EARLIEST <= moment <= LATEST:
        raise ValueError(Text("archive-date"))
    return moment


def _day_of_this_age(day: date) -> date:
    if not EARLIEST.date() <= day <= LATEST.date():
        raise ValueError(Text("archive-date"))
    return day


def _line(points: Polyline) -> Polyline:
    Path(points)  # two different points at least
    return points


def _joint_change(change: JsonDocument) -> JsonDocument:
    """Check the change of a joint as `JointChange` has it, under the joint's name; fitted to a donning it has less."""
    whole = {"name": "joint", "status": "applied", "reason": "", **change}
    JointChange.model_validate_json(json.dumps(whole), strict=True)
    return change


class SureOfRings(Document):
    """Which rings a person is sure of, and the recording in which they looked turned."""

    recording: Line | None
    rings: tuple[Name, ...]


class CalibrationUnderWay(Document):
    """The calibration of a session: its layout, and whether it is the short one."""

    layout: ShirtLayout
    as_worn: SureOfRings | None = None
    short: bool = False


class MapDifference(Document):
    """What a version of a map differs in from its parent."""

    felt_change: Finite | None = None
    joints: dict[Name, Annotated[JsonDocument, AfterValidator(_joint_change)]] | None = None
    trials: tuple[Count, ...] | None = None
    by_itself: bool | None = None
    back_to: Count | None = None


Moments = Annotated[AwareDatetime, AfterValidator(_of_this_age)]
Days = Annotated[date, AfterValidator(_day_of_this_age)]
Hash = Annotated[str, Field(pattern=r"^[0-9a-f]{64}$")]
Status = Literal["running", "done"]

BY_TYPE: Final[tuple[tuple[type, Form], ...]] = (
    (Boolean, bool),
    (Integer, Count),
    (Float, Finite),
    (Moment, Moments),
    (Date, Days),
)
FORMS: Final[dict[str, dict[str, Form]]] = {
    "patient": {"code": Line, "pseudonym": Line, "adaptation": Literal["off", "suggest", "auto"]},
    "session": {
        "script": CalibrationUnderWay,
        "current_step": Name,
        "result": CalibrationProfile,
        "screen": ScreenSettings,
        "opened_by": Line,
        "version": Line,
    },
    "run": {
        "shirt": Name,
        "body": Name,
        "chair": Name,
        "kind": Literal["rest", "free", "prompt", "drive", "interface_test"],
    },
    "calibration_step": {
        "step": Name,
        "status": Literal["waiting", "running", "done", "failed", "skipped"],
    },
    "profile": {
        "origin": Literal["calibration", "adaptation", "donning", "back"],
        "difference": MapDifference,
        "document": CalibrationProfile,
    },
    "parameters": {"title": SetTitle, "settings": JsonDocument, "hash": Hash},
    "trial": {
        "floorplan": Name,
        "floorplan_title": Line,
        "path": Name,
        "path_points": Annotated[Polyline, AfterValidator(_line)],
        "status": Status,
        "end": TrialEnding,
        "measures": TrialMeasures,
        "quality": ControlQuality,
    },
    "drive": {"end": DriveEnding, "hash": Hash},
    "interface_test": {
        "status": Status,
        "end": InterfaceTestEnding,
        "plan": CursorPlan,
        "measures": InterfaceMeasures,
        "workload": Workload,
    },
}


def wrong_value(
    table: SqlTable, columns: list[SqlColumn], rows: list[JsonDocument], feature_forms: Mapping[str, Form]
) -> Text | None:
    """Say in half a sentence which value of these rows does not have its form; None when all have.

    `feature_forms`: forms of columns of a feature's table, as in FORMS.
    """
    try:
        _form_of_rows(table.name, tuple(columns), tuple(feature_forms.items())).validate_json(
            json.dumps(rows), strict=True
        )
    except ValidationError as error:
        row = int(error.errors()[0]["loc"][0]) + 1
        return Text("archive-row-field", row=row, table=table.name, problem=first_error(error, skip=1))
    return None


def first_error(error: ValidationError, *, skip: int = 0, before: str = "") -> Text | str:
    """Return the field of the first thing that is wrong, and what: `skip` parts of its place are left out."""
    first = error.errors(include_url=False, include_input=False)[0]
    field = ".".join(map(str, [*filter(None, [before]), *first["loc"][skip:]]))
    is_own = first["type"] == "value_error"
    problem = text_of(first["ctx"]["error"]) if is_own else first["msg"].removeprefix("Input ")
    return Text("archive-field", field=field, problem=problem) if field else problem


def wrong_versions(rows: dict[str, list[JsonDocument]]) -> Text | None:
    """Say which map or set of controls contradicts another one: every map comes from an earlier one, or from none."""
    documents: dict[int, JsonDocument] = {}
    for place, row in enumerate(rows["profile"], start=1):
        before = (row["difference"] or {}).get("back_to")
        earlier = {other["version"] for other in rows["profile"] if other["version"] < row["version"]}
        if any(version is not None and version not in earlier for version in (row["parent"], before)):
            return Text("archive-map-from", row=place)
        if row["origin"] == "back" and before is None:
            return Text("archive-map-back", row=place)
        documents[row["id"]] = row["document"]
    current: set[int] = set()
    for place, row in enumerate(rows["parameters"], start=1):
        if row["profile_id"] not in documents:
            return Text("archive-controls-map", row=place)
        if row["current"] and (row["abandoned"] or row["profile_id"] in current):
            return Text("archive-controls-current", row=place)
        if row["current"]:
            current.add(row["profile_id"])
        try:
            whole = json.dumps({**row["settings"], "profile": documents[row["profile_id"]]})
            DriveParameters.model_validate_json(whole, strict=True)
        except ValidationError as error:
            problem = first_error(error, before="settings")
            return Text("archive-row-field", row=place, table="parameters", problem=problem)
    return None


@cache
def _form_of_rows(
    table: str, columns: tuple[SqlColumn, ...], feature_forms: tuple[tuple[str, Form], ...]
) -> TypeAdapter[Form]:
    forms = FORMS.get(table, {}) | dict(feature_forms)
    fields: dict[str, Any] = {
        column.name: (_form(column, forms.get(column.name, _by_type(column))), ...) for column in columns
    }
    row = create_model(table, __base__=Document, **fields)
    return TypeAdapter(list[row])


def _form(column: SqlColumn, form: Form) -> Form:
    return form | None if column.nullable else form


def _by_type(column: SqlColumn) -> Form:
    return next((form for kind, form in BY_TYPE if isinstance(column.type, kind)), Note)

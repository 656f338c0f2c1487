"""The layouts of a clinic, and drafts of new ones: of a file of signals, of channels that move together."""

from pathlib import Path
from typing import Annotated, Literal

from fastapi import APIRouter, Query
from pydantic import Field

from app.api.answers import MomentText
from app.api.deps import Clinician, ComputingPart, ControlPart, Db, EquipmentPart, LivePart, RowId, SettingsPart
from app.api.page_session import OF_CLINIC, any_session
from app.features.layouts.drafts import draft_of_file
from app.features.layouts.joint_groups import JointGroups, joint_groups
from app.features.layouts.service import add_layout, bundled_layouts, delete_layout, layouts_of, replace_layout
from app.features.layouts.tables import ClinicLayout
from app.layout import ShirtLayout
from app.news import News
from app.quantities import Document, Line
from app.refusals import Conflict
from app.session.equipment.choice import without_folders
from app.session.equipment.shirt import Equipment
from app.store.database import Transaction
from app.store.log import write_log
from app.texts import Text, text_of

router = APIRouter(prefix="/layouts", tags=["layouts"])

LayoutUse = Literal["none", "same", "changed"]
LastSeconds = Annotated[int, Query(ge=10, le=120)]


class DraftOfFile(Document):
    """The file of signals that a first layout is made of."""

    file: Annotated[Line, Field(min_length=1, max_length=200)]  # a name from `files` of `GET /equipment`


class ChangedLayout(Document):
    """A layout to save in place of its `version`."""

    version: Annotated[int, Field(strict=True, ge=1, le=2**31)]
    layout: ShirtLayout


class ClinicLayoutView(Document):
    """A layout that the clinic has made."""

    id: int
    version: int
    saved: MomentText
    use: LayoutUse
    layout: ShirtLayout


class BundledLayoutView(Document):
    """A layout that comes with the program."""

    use: LayoutUse
    layout: ShirtLayout


class LayoutsView(Document):
    """All layouts, by name. `use`: whether the shirt in use has it, as it is now or as it was before a change."""

    own: list[ClinicLayoutView]
    bundled: list[BundledLayoutView]


class JointGroupsView(Document):
    """Channels that move together, by their indices; no groups where these are not clear."""

    message: Text
    groups: list[list[int]]
    still: list[int]


class LayoutDraftView(Document):
    """A layout to begin with, which is not saved; no proposal where the names of the columns say its joints."""

    layout: ShirtLayout
    proposal: JointGroupsView | None


@router.get("")
def list_layouts(_person: Clinician, database: Db, equipment: EquipmentPart) -> LayoutsView:
    """Return the clinic's layouts, and those that come with the program."""
    with database.reading() as db:
        return _view(db, equipment)


@router.post("", status_code=201)
@any_session(OF_CLINIC)
def save_layout(
    body: ShirtLayout, person: Clinician, database: Db, equipment: EquipmentPart, live: LivePart
) -> LayoutsView:
    """Save a new layout under its name; 409 when that is taken."""
    with database.transaction() as db:
        row = add_layout(db, body)
        write_log(db, person.name, "layout saved", layout=row.id, name=row.name, version=row.version)
        answer = _view(db, equipment)
    live.notify(News(what="layouts"))
    return answer


@router.get("/proposal")
def propose_joints(
    _person: Clinician, control: ControlPart, equipment: EquipmentPart, seconds: LastSeconds = 20
) -> JointGroupsView:
    """Propose the joints of the shirt in use from its last `seconds`, in which everything was moved freely."""
    channels = len(equipment.needed_layout().channels)
    frames = control.newest_frames(channels, equipment.sample_rate, seconds)
    return _groups_view(joint_groups(frames, equipment.sample_rate))


@router.post("/draft")
@any_session(OF_CLINIC)
def draft_layout(
    body: DraftOfFile, _person: Clinician, computing: ComputingPart, equipment: EquipmentPart, settings: SettingsPart
) -> LayoutDraftView:
    """Return a first layout of a file of signals; nothing is saved."""
    path = Path(equipment.with_path({"file": body.file})["file"])
    try:
        draft = computing.ask(draft_of_file, path)
    except (ValueError, OSError) as error:
        raise Conflict(without_folders(text_of(error), settings.files)) from error
    return LayoutDraftView(layout=draft.layout, proposal=None if draft.groups is None else _groups_view(draft.groups))


@router.put("/{layout_id}")
@any_session(OF_CLINIC)
def change_layout(
    layout_id: RowId, body: ChangedLayout, person: Clinician, database: Db, equipment: EquipmentPart, live: LivePart
) -> LayoutsView:
    """Save a layout with its changes; refused when somebody saved it after `version` was read.

    The shirt in use and every calibration keep the layout that they have.
    """
    with database.transaction() as db:
        row = replace_layout(db, layout_id, body.layout, body.version)
        write_log(db, person.name, "layout saved", layout=row.id, name=row.name, version=row.version)
        answer = _view(db, equipment)
    live.notify(News(what="layouts"))
    return answer


@router.delete("/{layout_id}")
@any_session(OF_CLINIC)
def remove_layout(
    layout_id: RowId, person: Clinician, database: Db, equipment: EquipmentPart, live: LivePart
) -> LayoutsView:
    """Delete a layout; refused for that of the shirt in use."""
    with database.transaction(closing=True) as db:
        row = delete_layout(db, layout_id, _given(equipment))
        write_log(db, person.name, "layout deleted", layout=layout_id, name=row.name)
        answer = _view(db, equipment)
    live.notify(News(what="layouts"))
    return answer


def _view(db: Transaction, equipment: Equipment) -> LayoutsView:
    given = _given(equipment)
    has = equipment.layout or given  # without a shirt: what the one has that could not be opened
    return LayoutsView(
        own=[_own_view(row, given) for row in layouts_of(db)],
        bundled=[BundledLayoutView(use=_use(layout, has), layout=layout) for layout in bundled_layouts()],
    )


def _own_view(row: ClinicLayout, given: ShirtLayout | None) -> ClinicLayoutView:
    layout = ShirtLayout.model_validate(row.document)
    use = _use(layout, given)
    return ClinicLayoutView(id=row.id, version=row.version, saved=row.saved.isoformat(), use=use, layout=layout)


def _given(equipment: Equipment) -> ShirtLayout | None:
    """Return the layout that the shirt in use was given; None where it was given none, and has one of its own."""
    document = (equipment.shirt or {}).get("layout")
    return None if document is None else ShirtLayout.model_validate(document)


def _use(layout: ShirtLayout, in_use: ShirtLayout | None) -> LayoutUse:
    if in_use is None or in_use.name != layout.name:
        return "none"
    return "same" if in_use == layout else "changed"


def _groups_view(found: JointGroups) -> JointGroupsView:
    return JointGroupsView(message=found.text, groups=[*map(list, found.groups)], still=list(found.still))

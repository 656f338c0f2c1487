"""`bodydrive people`: the people of a clinic, on its own machine; also while the program runs.

Who can read the clinic's files owns the clinic. So this is also the way in again for somebody who is locked out.
"""

import json
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, TypedDict

import typer

from app.cli.clinic_folder import open_clinic
from app.cli.common_options import COMMAND_LINE, AsJson, State, settings_of
from app.cli.errors import InputError
from app.cli.help_text import help_text
from app.cli.qr import terminal_code
from app.network import link
from app.ports import HTTP_PORT
from app.refusals import Refusal
from app.texts import Text, text_of

if TYPE_CHECKING:
    from app.store.access.invitations import MadeInvitation
    from app.store.access.person_tables import Person
    from app.store.database import Transaction

Name = Annotated[str, typer.Argument(help=help_text("cli-help-people-name"))]
Role = Annotated[str, typer.Option(help=help_text("cli-help-people-role"))]
VisiblePatients = Annotated[list[str] | None, typer.Option("--patient", help=help_text("cli-help-people-patient"))]
Address = Annotated[str, typer.Option(help=help_text("cli-help-people-address"))]

ROLES = ("owner", "clinician", "reviewer")

people_app = typer.Typer(no_args_is_help=True, pretty_exceptions_enable=False)


class PersonFacts(TypedDict):
    """A person of the clinic, as `--json` has it."""

    name: str
    role: str
    patients: list[str] | None  # codes of the patients whom a reviewer may see; None: all
    state: str


@people_app.command("list", help=help_text("cli-help-people-list"))
def list_people(
    state: State = None,
    as_json: AsJson = False,
) -> None:
    """List the people of the clinic: name, role, what a reviewer may see, whether they can sign in."""
    from app.store.access.rights import people_of
    from app.store.tables import Patient

    with open_clinic(settings_of(state)) as (database, _), database.reading() as db:
        people: list[PersonFacts] = []
        for person in people_of(db):
            codes = None
            if person.patients is not None:
                rows = [db.get(Patient, patient) for patient in person.patients]
                codes = [patient.code for patient in rows if patient is not None]
            people.append({"name": person.name, "role": person.role, "patients": codes, "state": _state_of(person)})
    if as_json:
        typer.echo(json.dumps({"people": people}))
        return
    width = max((len(str(person_facts["name"])) for person_facts in people), default=0)
    for person_facts in people:
        cells = [f"{person_facts['name']:<{width}}", f"{person_facts['role']:<9}"]
        cells.append(str(Text(f"cli-person-state-{person_facts['state']}")))
        if person_facts["patients"]:
            cells.append(str(Text("cli-person-patients", codes=", ".join(person_facts["patients"]))))
        elif person_facts["patients"] is not None:
            cells.append(str(Text("cli-person-no-patients")))
        typer.echo("  ".join(cells))


@people_app.command("invite", help=help_text("cli-help-people-invite", "cli-help-people-invite-again"))
def invite_person(
    name: Name, role: Role = "clinician", patients: VisiblePatients = None, state: State = None, address: Address = ""
) -> None:
    """Add a person, and print the link by which this person chooses a password within 24 hours.

    For somebody who is there already, the link makes a new password; role and patients stay.
    """
    from app.store.access.invitations import invite
    from app.store.access.rights import checked_patients
    from app.store.people import add_clinic, add_person, find_person, the_clinic

    if role not in ROLES:
        raise InputError(Text("cli-no-role", role=role))
    _require_name(name)
    with open_clinic(settings_of(state)) as (database, running):
        try:
            with database.transaction() as db:
                person = find_person(db, name)
                if person is None:
                    clinic = the_clinic(db) or add_clinic(db, str(Text("cli-clinic-name")))
                    ids = None if patients is None else _patient_ids(db, patients)
                    ids = checked_patients(db, role, ids)
                    person = add_person(db, clinic, name, role, None, patients=ids, by=COMMAND_LINE)
                invitation = invite(db, person, COMMAND_LINE)
        except Refusal as refusal:
            raise InputError(text_of(refusal)) from refusal
    _print_link(name, invitation, address or running)


@people_app.command("disable", help=help_text("cli-help-people-disable"))
def disable_person(name: Name, state: State = None) -> None:
    """Let a person sign in no longer; open pages of this person end within 5 s."""
    from app.store.access.rights import disable

    _change(name, state, lambda db, person: disable(db, person, COMMAND_LINE))
    typer.echo(Text("cli-person-is-disabled", name=name))


@people_app.command("enable", help=help_text("cli-help-people-enable"))
def enable_person(name: Name, state: State = None) -> None:
    """Let a disabled person sign in again."""
    from app.store.access.rights import enable

    _change(name, state, lambda db, person: enable(db, person, COMMAND_LINE))
    typer.echo(Text("cli-person-is-enabled", name=name))


def _state_of(person: "Person") -> str:
    if person.disabled is not None:
        return "disabled"
    return "invited" if person.password_hash is None else "active"


def _require_name(name: str) -> None:
    from pydantic import TypeAdapter, ValidationError

    from app.api.sign_in.auth import PersonName

    try:
        TypeAdapter(PersonName).validate_python(name)
    except ValidationError as error:
        raise InputError(Text("cli-name-unusable")) from error


def _patient_ids(db: "Transaction", codes: list[str]) -> list[int]:
    from app.store.patients import all_patients

    by_code = {patient.code: patient.id for patient in all_patients(db)}
    unknown = next((code for code in codes if code not in by_code), None)
    if unknown is not None:
        raise InputError(Text("cli-no-patient-option", code=unknown))
    return [by_code[code] for code in codes]


def _change(name: str, state: Path | None, change: Callable[["Transaction", "Person"], None]) -> None:
    from app.store.access.rights import needed_person
    from app.store.people import find_person

    with open_clinic(settings_of(state)) as (database, _):
        try:
            with database.transaction(closing=True) as db:
                change(db, needed_person(find_person(db, name), name))
        except Refusal as refusal:
            raise InputError(text_of(refusal)) from refusal


def _print_link(name: str, invitation: "MadeInvitation", address: str) -> None:
    base = address or link("http", "127.0.0.1", HTTP_PORT)
    address_to_open = f"{base.rstrip('/')}/#invite={invitation.code}"
    typer.echo(terminal_code(address_to_open))
    typer.echo(Text("cli-invitation", name=name, time=invitation.expires))
    typer.echo(address_to_open)
    if not address:
        typer.echo(Text("cli-not-running"))

"""Archives of patients: what the feature gives to the rest of the program."""

from typing import TYPE_CHECKING, Final

from app.features.registration import Feature

if TYPE_CHECKING:
    from app.api.parts import Parts


def add_parts(parts: "Parts") -> None:
    """Add the imports under way."""
    from app.features.archive.routes import ImportCourses

    parts.add(ImportCourses, ImportCourses())


FEATURE: Final = Feature(
    routes=("routes",),
    add_parts=add_parts,
)

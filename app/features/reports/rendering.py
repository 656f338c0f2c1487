"""Makes the file of a report: called in the computing process, or by the command."""

from typing import Final

from app.features.reports.composition import compose
from app.features.reports.document import Form, Paper
from app.features.reports.html import render_html
from app.features.reports.material import ReportMaterial
from app.features.reports.pdf import render_pdf

MEDIA_TYPES: Final[dict[Form, str]] = {"pdf": "application/pdf", "html": "text/html; charset=utf-8"}


def report_file(material: ReportMaterial, form: Form, paper: Paper) -> bytes:
    """Return the content of the file."""
    report = compose(material)
    return render_pdf(report, paper) if form == "pdf" else render_html(report, paper)


def file_name(material: ReportMaterial, form: Form) -> str:
    """Return a name for the file, without any name of the patient."""
    what = "course" if material.session is None else f"session-{material.session}"
    return f"bodydrive-report-{material.patient_id}-{what}-{material.made:%Y%m%dT%H%M%SZ}.{form}"

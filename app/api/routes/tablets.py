"""How a tablet reaches the pages: the link to begin with, and whether it trusts this machine."""

from fastapi import APIRouter, HTTPException, Response

from app.api.deps import Anyone, ForEveryone, SettingsPart
from app.api.qr import qr_picture
from app.quantities import Document
from app.texts import Text

router = APIRouter(tags=["tablets"])

# The page that explains asks from another origin (http); nothing is answered that this page does not know.
FOR_OTHER_ORIGINS = {"Access-Control-Allow-Origin": "*", "Cross-Origin-Resource-Policy": "cross-origin"}
THIS_MACHINE_ONLY = Text("api-this-machine-only")


class TrustView(Document):
    """The fingerprint of what a tablet trusts when it gets this answer over https."""

    fingerprint: str


class TabletsView(Document):
    """The link with which a tablet begins, and where it arrives."""

    url: str | None  # None: the program serves this machine alone
    qr: str
    pages: str
    message: Text | str


@router.get("/trust", dependencies=[ForEveryone])
def trust(response: Response, settings: SettingsPart) -> TrustView:
    """Answer a tablet that tries whether it trusts this machine."""
    network = settings.network
    if network is None:
        raise HTTPException(404, THIS_MACHINE_ONLY)
    response.headers.update(FOR_OTHER_ORIGINS)
    return TrustView(fingerprint=network.trust.fingerprint)


@router.get("/tablets")
def tablets(_person: Anyone, settings: SettingsPart) -> TabletsView:
    """Return the link for further tablets."""
    network = settings.network
    if network is None:
        return TabletsView(url=None, qr="", pages="", message=THIS_MACHINE_ONLY)
    url = network.page_link()
    return TabletsView(url=url, qr=qr_picture(url), pages=network.link(), message="")

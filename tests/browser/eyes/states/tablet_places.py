"""The page that connects a device, in each state that it finds: the machine's facts are put together here."""

from datetime import timedelta
from typing import Any

from browser.eyes.eyes_clinic import EyesClinic
from browser.eyes.opening import Open
from playwright.sync_api import expect

from app.clock import utc_now

FINGERPRINT = "3f" * 32


def connecting(
    state: str,
    device: str | None = None,
    *,
    trusts: bool = False,
    before: str = "",
    began: int = -30,
    installs: bool = True,
) -> Open:
    """Return what opens the page where it comes to a state; `began`: days from now at which the certificate began."""

    def open_place(page: Any, clinic: EyesClinic) -> None:
        start = utc_now() + timedelta(days=began)
        facts = {
            "link": f"{clinic.address}/", "check": f"{clinic.address}/api/v1/trust", "name": "bodydrive.local",
            "fingerprint": FINGERPRINT, "installs": installs, "start": start.isoformat(),
            "end": (start + timedelta(days=397)).isoformat(), "now": utc_now().isoformat(),
        }  # fmt: skip
        page.unroute_all()
        page.goto(f"{clinic.address}/facts.json")  # the address alone, so that something can be stored for it
        page.evaluate("(before) => localStorage.setItem('bodydrive_trusted', before)", before)
        page.route("**/facts.json", lambda route: route.fulfill(json=facts))
        answer = {"fingerprint": FINGERPRINT if trusts else "another"}
        page.route("**/api/v1/trust", lambda route: route.fulfill(json=answer))
        clinic.when_left.append(lambda: page.evaluate("() => localStorage.removeItem('bodydrive_trusted')"))
        page.goto(f"{clinic.address}/tablet.html")
        expect(page.locator(f".check[data-state={state}]")).to_be_visible()
        if device:
            page.get_by_role("button", name=device).click()
            expect(page.locator(".steps li").first).to_be_visible()

    return open_place


TABLET_PLACES: dict[str, Open] = {
    "tablet, not yet": connecting("not-yet", "iPad or iPhone"),
    "tablet, trusted": connecting("trusted", trusts=True),
    "tablet, replaced": connecting("replaced", "Windows", before="another"),
    "tablet, wrong clock": connecting("clock", "Linux", began=3),
    "tablet, own certificate": connecting("not-yet", "A certificate of your own", installs=False),
}

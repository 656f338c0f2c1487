"""The icons of the home screen, drawn from web_static/icon.svg by a browser: `make shipped FILE=icons`."""

import shutil

from folders import ROOT

STATIC = ROOT / "web_static"
TEAL = "#0b6b6b"
# Name, size in pixels, and the share of the picture that the drawing fills. Systems cut a maskable icon to any shape
# within the middle 80 %, and an iPad rounds the corners itself, so that these two have no corners of their own.
ICONS = (
    ("icon-192", 192, 1.0),
    ("icon-512", 512, 1.0),
    ("maskable-192", 192, 0.8),
    ("maskable-512", 512, 0.8),
    ("apple-180", 180, 0.9),
)


def draw() -> None:
    """Write the icons."""
    from playwright.sync_api import sync_playwright

    drawing = (STATIC / "icon.svg").read_text()
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        for name, size, share in ICONS:
            page = browser.new_page(viewport={"width": size, "height": size})
            side, edge = size * share, size * (1 - share) / 2
            ground = "transparent" if share == 1.0 else TEAL
            style = f"position: absolute; left: {edge}px; top: {edge}px; width: {side}px; height: {side}px"
            page.set_content(f"<body style='margin: 0; background: {ground}'><div style='{style}'>{drawing}</div>")
            page.screenshot(path=STATIC / "icons" / f"{name}.png", omit_background=True)
            page.close()
        browser.close()


if __name__ == "__main__":
    draw()

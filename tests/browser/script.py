"""What runs in a page, each in a file of its own."""

from pathlib import Path

SCRIPTS = Path(__file__).with_name("scripts")


def script(name: str) -> str:
    """Return a function, or statements, in JavaScript."""
    return (SCRIPTS / f"{name}.js").read_text(encoding="utf-8")

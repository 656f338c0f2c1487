"""Folders that tests read from or write to."""

from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SHARED = ROOT.parent / "shared"  # recordings of people; they are not part of the project and may be absent
SCREENSHOTS = ROOT / "var" / "screenshots"

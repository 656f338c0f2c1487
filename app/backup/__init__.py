"""Back a clinic up and restore it; archive what an incident left behind."""

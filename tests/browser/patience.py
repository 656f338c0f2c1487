"""How long a page may take until it shows what is expected: a busy machine that draws in software is slow."""

PATIENCE = 60_000  # ms

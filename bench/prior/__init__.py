"""The tables of docs/learning/prior-measured.md: people kept apart, real and simulated."""

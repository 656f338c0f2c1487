"""The tables of docs/learning.md, "The prior": people kept apart, real and simulated."""

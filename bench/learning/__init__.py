"""The tables of docs/learning: simulated people and recordings of real ones."""

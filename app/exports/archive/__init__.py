"""The archive of a whole patient: its list, how it is made, and how another clinic reads and imports it."""

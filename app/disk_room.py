"""How much room the disk of the recordings needs, in bytes."""

LITTLE_ROOM = 2_000_000_000  # below, people are asked to make room
ROOM_TO_RECORD = 500_000_000  # below, nothing is recorded or driven: a drive of 20 minutes with the largest shirt
NO_ROOM = 32_000_000  # below, the disk counts as full; more than the ballast can release

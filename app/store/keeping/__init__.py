"""How long records are kept: deletion for good, what must not be deleted, the backups that were made."""

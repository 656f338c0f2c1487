"""The owner's page "Backup", and the backup of every night."""

"""The owner's page "This computer"."""

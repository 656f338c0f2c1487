"""Commands about a clinic's records."""

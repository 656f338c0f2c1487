"""The record of a session and the consents of a patient, for browsers."""

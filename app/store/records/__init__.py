"""What a clinician writes about a session, its sign-off, and the consents of a patient."""

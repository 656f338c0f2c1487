"""Review from elsewhere: what needs attention, stories of sessions, comments on moments, share links."""

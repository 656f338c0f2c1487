"""What people elsewhere see and say: comments on moments of trials, share links, the story of a session."""

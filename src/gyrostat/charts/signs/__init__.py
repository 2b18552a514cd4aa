"""Charts signs."""

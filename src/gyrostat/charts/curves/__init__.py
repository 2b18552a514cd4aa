"""Charts curves."""

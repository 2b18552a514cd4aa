"""Published checks."""

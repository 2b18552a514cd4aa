"""Charts boxes."""

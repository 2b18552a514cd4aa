"""Charts stores."""

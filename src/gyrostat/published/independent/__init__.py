"""Published independent."""

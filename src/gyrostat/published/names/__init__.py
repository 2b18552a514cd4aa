"""Published names."""

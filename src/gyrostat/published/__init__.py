"""Published formulas: load them, exactly as printed, and check each against what the library derives."""

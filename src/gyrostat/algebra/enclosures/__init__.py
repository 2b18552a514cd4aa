"""Algebra enclosures."""

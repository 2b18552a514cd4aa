"""Stability damping."""

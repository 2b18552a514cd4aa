"""Mechanics scenes."""

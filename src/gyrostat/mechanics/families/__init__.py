"""Mechanics families."""

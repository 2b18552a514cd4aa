"""Algebra solving."""

"""Algebra text."""

"""Algebra rings."""

"""Algebra reals."""

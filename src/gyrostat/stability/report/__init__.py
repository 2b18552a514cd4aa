"""Stability report."""

"""Stability criteria."""

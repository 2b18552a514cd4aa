"""Mechanics classical."""

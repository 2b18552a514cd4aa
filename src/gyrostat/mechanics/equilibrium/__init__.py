"""Mechanics equilibrium."""

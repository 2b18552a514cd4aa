"""Equilibria curves."""

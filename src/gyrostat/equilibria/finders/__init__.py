"""Equilibria finders."""

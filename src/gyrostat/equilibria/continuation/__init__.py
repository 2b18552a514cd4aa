"""Equilibria continuation."""

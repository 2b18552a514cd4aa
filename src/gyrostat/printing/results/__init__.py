"""Printing results."""

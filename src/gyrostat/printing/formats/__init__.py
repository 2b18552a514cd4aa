"""Printing formats."""

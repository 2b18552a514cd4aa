"""Cli answers."""

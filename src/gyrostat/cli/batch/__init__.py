"""Cli batch."""

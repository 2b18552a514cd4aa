"""Cli options."""

"""Cli verbs."""

"""Stability normal_forms."""

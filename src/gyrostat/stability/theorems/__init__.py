"""Stability theorems."""

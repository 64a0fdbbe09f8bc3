"""Seeded pairs of shapes: ordinary pairs to time, and pairs that are hard to decide to a given degree."""

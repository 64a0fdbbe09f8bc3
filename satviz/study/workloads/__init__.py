"""Seeded pairs of shapes: ordinary ones to time, and ones as hard as asked."""

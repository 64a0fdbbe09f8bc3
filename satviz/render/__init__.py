"""Pens and files: the only floor that knows matplotlib's artists."""

"""Pens and files: the only package that knows matplotlib's artists."""

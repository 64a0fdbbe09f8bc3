"""Speed against accuracy: the methods measured beside each other, against the truth in rationals.

A section is a module with `cells(settings)` and `charts(results)`: it gives its cells (cells.py) and, from their
results, its charts (chart.py).
"""

"""Speed against accuracy: the methods measured beside each other, against the truth in rationals.

`methods` are asked about `pairs` in the cells of `sections`, with what `lab` has for that.  A section is a module
with `cells(settings)` and `charts(found, settings)`: it gives its cells and, from their results, its charts.
"""

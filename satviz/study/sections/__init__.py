"""The sections of the study: one module for each question.

Every section has the same two functions:
    cells(settings) -> list[Cell]            the work, in cells that are run once and kept on disk
    charts(found, settings) -> list[Chart]   the charts, from `found`: the results of all cells by their names

A result is a list of rows: dictionaries of plain JSON values (`harness.cells.JsonRow`).
"""

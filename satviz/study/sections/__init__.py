"""The sections of the study: one module for each question.

Every section has the same two functions and one table:
    cells(settings) -> list[Cell]   the work, in cells that are run once and kept on disk
    rows(found) -> dict             the numbers of each chart by its stem, from the results of all cells by their names
    CHARTS                          by stem: the function (rows, settings) -> Chart, which sees nothing but its numbers

Results and numbers are rows: dictionaries of plain JSON values (`harness.cells.JsonRow`).  A chart is left out where
its methods are not installed; then it has no rows.
"""

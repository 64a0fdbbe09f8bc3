"""One question each: a section gives its cells, and charts from their results."""

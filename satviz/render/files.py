"""Pictures as files: SVG, PNG, PDF and GIF, the same bytes each time, each with its words inside."""

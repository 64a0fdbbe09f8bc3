"""Read shapes from any text, such as WKT, JSON or lines of code; say what is found, and write it in other forms."""

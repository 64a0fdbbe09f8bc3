"""Pages of static files that need no network."""

"""The site: chapters, guides, the reference, a gallery and an explorer as static files that need no network."""

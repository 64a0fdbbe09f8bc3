"""Scenes and traces as files, the article's scenes, and those where shortcuts fail."""

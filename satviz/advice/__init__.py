"""The least model that is right for a scene, and what it costs."""

"""Pictures: one step of a trace as marks, with no pen in sight."""

from .comparison import picture
from .marks import Mark, Picture
from .stages import Stage, Step, steps
from .theme import DARK, LIGHT, THEMES, Theme

__all__ = ["DARK", "LIGHT", "THEMES", "Mark", "Picture", "Stage", "Step", "Theme", "picture", "steps"]

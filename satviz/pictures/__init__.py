"""Pictures: a step of a trace as marks, which any pen can draw."""

from .comparison import picture
from .marks import Mark, Picture
from .stages import Stage, Step, steps
from .theme import DARK, LIGHT, THEMES, Theme

__all__ = ["DARK", "LIGHT", "THEMES", "Mark", "Picture", "Stage", "Step", "Theme", "picture", "steps"]

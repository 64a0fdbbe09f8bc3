"""The look, shared by every pen: colours by role, line weights and text sizes in points."""

from typing import NamedTuple


class Theme(NamedTuple):
    """Colours of one theme; `text` overrides a role's colour where letters need more contrast."""

    name: str
    paper: str
    roles: dict[str, str]
    text: dict[str, str]


LIGHT = Theme(
    "light",
    "#FFFFFF",
    {"A": "#0072B2", "B": "#D55E00", "gap": "#009E73", "overlap": "#CC79A7", "ink": "#1A1A1A", "guide": "#595959"},
    {"B": "#B34F00", "gap": "#00734F", "overlap": "#A34A7C"},
)
DARK = Theme(
    "dark",
    "#1E1E1E",
    {"A": "#56B4E9", "B": "#FF9E4A", "gap": "#2BD4A4", "overlap": "#F0A6CA", "ink": "#E5E7EB", "guide": "#A3A3A3"},
    {},
)
THEMES = {theme.name: theme for theme in (LIGHT, DARK)}

OUTLINE, STRONG, BAR, OVERLAP_BAR, GUIDE, AXIS = 2.0, 4.0, 4.0, 5.0, 1.0, 1.2
FILL = 0.15  # opacity
DOT = 6.5  # a dot's width
HEAD = 8.0, 6.0  # an arrow head's length and width
DASH = 4.0, 2.0  # B's edges, in line widths
DOTTED = 1.0, 2.2
TEXT = 11.0
TITLE_TEXT = 15.0  # the names of the shapes


def text_size(weight: str) -> float:
    """A label's size in points."""
    return TITLE_TEXT if weight == "title" else TEXT

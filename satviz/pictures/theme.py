"""The look, shared by every pen: colours by role, line weights and text sizes in points."""

from functools import cache
from typing import NamedTuple


class Theme(NamedTuple):
    """Colours of one theme, one meaning each; `text` overrides a role's colour where letters need more contrast."""

    name: str
    paper: str
    roles: dict[str, str]
    text: dict[str, str]


# in a picture: two shapes, what their ranges do, the way out, what is wrong; in charts: who a method is, how it errs
LIGHT = Theme(
    "light",
    "#FFFFFF",
    {"A": "#0072B2", "B": "#D55E00", "gap": "#009E73", "overlap": "#CC79A7", "ink": "#1A1A1A", "guide": "#595959"}
    | {"move": "#4B2E9E", "wrong": "#8A0F2E"}
    | {"exact": "#332288", "float": "#0E7C7B", "tolerance": "#AA4499", "shortcut": "#7A7A00"}
    | {"false": "#9E1B32", "missed": "#5B3FB5"},
    {"B": "#B34F00", "gap": "#00734F", "overlap": "#A34A7C"},
)
DARK = Theme(
    "dark",
    "#1E1E1E",
    {"A": "#56B4E9", "B": "#FF9E4A", "gap": "#2BD4A4", "overlap": "#F0A6CA", "ink": "#E5E7EB", "guide": "#A3A3A3"}
    | {"move": "#F4E04D", "wrong": "#FF5F6D"}
    | {"exact": "#7F8CFF", "float": "#4DD0E1", "tolerance": "#C6A700", "shortcut": "#F0F4A0"}
    | {"false": "#FF6F61", "missed": "#D59CFF"},
    {},
)
PICTURE_ROLES = "A", "B", "gap", "overlap", "ink", "guide", "move", "wrong"
CHART_ROLES = "exact", "float", "tolerance", "shortcut", "false", "missed", "ink", "guide"
THEMES = {theme.name: theme for theme in (LIGHT, DARK)}

OUTLINE, STRONG, BAR, OVERLAP_BAR, GUIDE, SEGMENT, AXIS = 2.0, 4.0, 4.0, 5.0, 1.0, 1.5, 1.2
FILL, FAINT = 0.15, 0.55  # opacities
DOT_PT = 6.5  # a dot's width
HEAD = 8.0, 6.0  # an arrow head's length and width
STRONG_HEAD = 15.0, 11.0
DASH = 4.0, 2.0  # B's edges, in line widths
DOTTED = 1.0, 2.2
TEXT_PT = 11.0
TITLE_TEXT = 15.0  # the names of the shapes
# lines lie on top of each other in this order: what guides, the shapes, then what the step is about
LAYERS = {"guide": 0, "faint": 1, "plain": 2, "strong": 3, "interval": 4, "bracket": 5}


class Style(NamedTuple):
    """How every pen draws a mark: finished numbers, lengths in points."""

    kind: str
    role: str
    layer: int = 0  # of its line
    width: float = 0.0  # 0: it has no line
    dash: tuple[float, ...] = ()  # in widths
    opacity: float = 1.0
    fill: float = 0.0  # the opacity of its inside
    size: float = 0.0  # a dot's width or the letters' size
    square: bool = False  # a dot else is round
    bold: bool = False
    head: tuple[float, float] = (0.0, 0.0)  # an arrow head's length and width


@cache
def style_of(kind: str, role: str, weight: str) -> Style:
    """The look of a mark of that kind, role and weight."""
    faint, strong = weight == "faint", weight == "strong"
    if kind == "label":
        bold = weight == "title"
        return Style(kind, role, size=TITLE_TEXT if bold else TEXT_PT, bold=bold)
    if kind == "dot":
        square = role == "B"
        return Style(kind, role, size=DOT_PT * 0.9 if square else DOT_PT, square=square)
    line = Style(kind, role, LAYERS.get(kind, LAYERS[weight]), OUTLINE, opacity=FAINT if faint else 1.0)
    if kind == "outline" and role == "wrong":
        return Style(kind, role, fill=FILL * 2)  # an area, and no line: what lies side by side shows no seam
    if kind in ("outline", "disc"):
        fill = FILL / 3 if faint else FILL
        return line._replace(width=GUIDE if faint else OUTLINE, dash=DASH if role == "B" else (), fill=fill)
    if kind == "interval":
        return line._replace(width=OVERLAP_BAR if role == "overlap" else BAR)
    if kind == "arrow":
        if strong:
            return line._replace(width=STRONG, head=STRONG_HEAD)
        return line._replace(width=AXIS if role in ("ink", "guide") else OUTLINE, head=HEAD)
    if role == "guide":
        return line._replace(layer=LAYERS["guide"], width=GUIDE, dash=DOTTED)
    if kind == "segment" or strong:
        return line._replace(width=STRONG if strong else SEGMENT)
    return line

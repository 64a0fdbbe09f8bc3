"""The style of every mark, shared by all pens: colours by role, line widths and text sizes in points."""

from functools import cache
from typing import NamedTuple


class Theme(NamedTuple):
    """The colours of one theme: each role has one meaning and one colour.

    `text` has the colours of those roles whose letters need more contrast than their lines.
    """

    name: str
    paper: str
    roles: dict[str, str]
    text: dict[str, str]


# roles in a picture: two shapes, what their ranges do, the MTV, what is wrong; in charts: methods and kinds of error
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

# widths of lines in points
OUTLINE_PT, STRONG_PT, BAR_PT, OVERLAP_BAR_PT, GUIDE_PT, SEGMENT_PT, AXIS_PT = 2.0, 4.0, 4.0, 5.0, 1.0, 1.5, 1.2
LEADER_PT = 0.8  # width of the line from a label to its anchor
FILL_OPACITY, FAINT_OPACITY = 0.15, 0.55
DOT_PT = 6.5  # a dot's width
ARROW_HEAD_PT = 8.0, 6.0  # length and width
STRONG_ARROW_HEAD_PT = 15.0, 11.0
DASHES = 4.0, 2.0  # B's outline: a dash and a space, in line widths
DOTS = 1.0, 2.2  # a guide line: a dot and a space, in line widths
TEXT_PT = 11.0
TITLE_TEXT_PT = 15.0  # the names of the shapes
# lines cover each other in this order: guides, the shapes, then what the step explains
LAYERS = {"guide": 0, "faint": 1, "plain": 2, "tint": 2, "fill": 2, "area": 2, "strong": 3, "interval": 4, "bracket": 5}


class Style(NamedTuple):
    """How every pen draws a mark: finished numbers, lengths in points."""

    kind: str
    role: str
    layer: int = 0  # the layer of its line
    width: float = 0.0  # the width of its line; 0 means no line
    dash: tuple[float, ...] = ()  # dash and space, in line widths; () is a solid line
    opacity: float = 1.0  # the opacity of its line
    fill: float = 0.0  # the opacity of its inside
    size: float = 0.0  # the width of a dot, or the text size of a label
    square: bool = False  # a square dot instead of a round one
    bold: bool = False
    head: tuple[float, float] = (0.0, 0.0)  # an arrow head's length and width


@cache
def style_of(kind: str, role: str, weight: str) -> Style:
    """Return the style of a mark from its kind, role and weight."""
    faint, strong = weight == "faint", weight == "strong"
    if kind == "label":
        bold = weight == "title"
        return Style(kind, role, size=TITLE_TEXT_PT if bold else TEXT_PT, bold=bold)
    if kind == "dot":
        square = role == "B"
        return Style(kind, role, size=DOT_PT * 0.9 if square else DOT_PT, square=square)
    line = Style(kind, role, LAYERS.get(kind, LAYERS[weight]), OUTLINE_PT, opacity=FAINT_OPACITY if faint else 1.0)
    if kind == "outline" and weight == "area":
        return Style(kind, role, fill=FILL_OPACITY * 3)
    if kind == "outline" and weight == "fill":
        return Style(kind, role, fill=FILL_OPACITY)
    if kind == "outline" and role == "wrong":
        return Style(kind, role, fill=FILL_OPACITY * 2)  # an area without a line, so that adjacent areas show no seam
    if weight == "tint":
        return line._replace(dash=DASHES if role == "B" else (), fill=FILL_OPACITY * 2.2)
    if kind in ("outline", "disc"):
        fill, width = (FILL_OPACITY / 3, GUIDE_PT) if faint else (FILL_OPACITY, OUTLINE_PT)
        return line._replace(width=width, dash=DASHES if role == "B" else (), fill=fill)
    if kind == "bracket":
        width = GUIDE_PT if faint else OUTLINE_PT  # a thin one stays open in a narrow gap
        return line._replace(width=width, opacity=1.0, dash=DASHES if role == "B" else ())
    if kind == "interval":
        return line._replace(width=OVERLAP_BAR_PT if role == "overlap" else BAR_PT)
    if kind == "arrow":
        if strong:
            return line._replace(width=STRONG_PT, head=STRONG_ARROW_HEAD_PT)
        return line._replace(width=AXIS_PT if role in ("ink", "guide") else OUTLINE_PT, head=ARROW_HEAD_PT)
    if role == "guide" and faint and kind == "segment":
        return line._replace(layer=LAYERS["guide"], width=LEADER_PT)  # solid: no drop
    if role == "guide":
        return line._replace(layer=LAYERS["guide"], width=GUIDE_PT, dash=DOTS)
    if kind == "segment" and faint and role in ("A", "B"):
        return line._replace(layer=LAYERS["guide"], width=GUIDE_PT, dash=DOTS, opacity=1.0)
    if kind == "segment" and faint:
        return line._replace(layer=LAYERS["guide"], width=GUIDE_PT)
    if kind == "segment" or strong:
        return line._replace(width=STRONG_PT if strong else SEGMENT_PT)
    return line

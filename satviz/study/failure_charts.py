"""The failure maps as charts: where the shortcut is wrong, its smallest scene, and the right answer beside it."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..engine.axes import Choice, hull_normals
from ..engine.trace import record
from ..pictures import Picture, Theme, picture
from ..render.draw import draw
from ..scenes.failing import NAMED, Row
from .chart import TEXT, Chart, headline, label_ends
from .failure_map import LOOKS, draw_map, limits
from .failures import APART, HIT, PUSHES, WRONG, Slide

WIDTH, ABOVE, BELOW = 780.0, 54.0, 16.0  # points
MAP = 16.0, 290.0, 345.0  # left, width and height at most
SCENE, WORDS = (462.0, 302.0, 310.0), 46.0  # the same, and room for two lines above it
COLUMNS, PANEL, TOP = 6, (150.0, 180.0), 60.0


def map_chart(slide: Slide) -> Chart:
    """One shortcut: its map on the left, on the right the scene with its claim and the right answer."""
    row = NAMED[slide.name]
    scene = _right_answer(row)
    scene_size = scene.size  # where it needs more room than there is, the chart is larger, so that letters stay
    map_size = _size(slide, row, MAP[1:])
    wider = max(0.0, scene_size[0] - SCENE[1])
    size = WIDTH + wider, ABOVE + max(map_size[1], WORDS + scene_size[1]) + BELOW

    def draw_it(fig: Figure, theme: Theme) -> None:
        headline(fig, theme, f"{row.number}  “{row.claim}”", _under(slide))
        left, bottom = MAP[0] + (MAP[1] - map_size[0]) / 2, size[1] - ABOVE - map_size[1]
        ax = _axes(fig, (left, bottom, *map_size), limits(slide, row))
        draw_map(ax, slide, row, theme)
        label_ends(ax, _ends(slide, theme), gap=15.0, room=14.0 + MAP[0] + MAP[1] - left - map_size[0])
        _answers(fig, row, theme)
        left, bottom = SCENE[0] + max(0.0, SCENE[1] - scene_size[0]) / 2, size[1] - ABOVE - WORDS - scene_size[1]
        draw(scene, ax=fig.add_axes(_part(fig, (left, bottom, *scene_size))), theme=theme.name)

    return Chart(
        f"failing-{row.number:02}-{row.name}", f"{row.number} {row.name}", size, draw_it, _lines(slide), reading(slide)
    )


def _right_answer(row: Row) -> Picture:
    """The axis with the largest gap, or the way out; on a run of that axis alone, for which there is more room."""
    trace = row.scene.record().truth
    hull = record(row.a, row.b, axes=hull_normals, every_axis=True)
    runs = (trace,) if trace.tests else (hull,) if hull.separating else trace.pairs
    best = [max(run.tests, key=lambda test: test.gap) for run in runs]
    test, run = min(zip(best, runs, strict=True), key=lambda found: found[0].gap)
    alone = replace(run, choice=Choice((test.axis,), complete=run.choice.complete), tests=(test,))
    return picture(alone, -2 if test.gap > 0 else -1, largest=SCENE[1:])


def overview(slides: Sequence[Slide]) -> Chart:
    """All maps in small."""
    lines = -(-len(slides) // COLUMNS)
    size = COLUMNS * PANEL[0] + 24, lines * PANEL[1] + TOP + 8

    def draw_it(fig: Figure, theme: Theme) -> None:
        under = "B's middle put everywhere round A. Grey: a hit, and right. Plain: apart, and right. Hatched: wrong."
        headline(fig, theme, "Where each shortcut is wrong", under)
        for k, slide in enumerate(slides):
            middle, top = 12 + (k % COLUMNS + 0.5) * PANEL[0], size[1] - TOP - k // COLUMNS * PANEL[1]
            row = NAMED[slide.name]
            w, h = _size(slide, row, (PANEL[0] - 24, PANEL[1] - 66))
            ax = _axes(fig, (middle - w / 2, top - 20 - (PANEL[1] - 66 + h) / 2, w, h), limits(slide, row))
            draw_map(ax, slide, row, theme, named=False)
            at = {"ha": "center", "va": "top", "fontsize": TEXT, "parse_math": False, "color": theme.roles["ink"]}
            fig.text(middle / size[0], top / size[1], f"{row.number} {row.name}", fontweight="bold", **at)
            below = (top - PANEL[1] + 42) / size[1]
            fig.text(middle / size[0], below, slide.told.replace(", ", ",\n"), linespacing=1.2, **at)

    rows = [_summary(slide) for slide in slides]
    worst = max(slides, key=lambda s: s.wrong / s.counts.total())
    least = min(slides, key=lambda s: s.wrong / s.counts.total())
    text = (
        f"{len(slides)} shortcuts, B on up to {max(s.counts.total() for s in slides)} positions round A each. "
        f"Most often wrong: {worst.name} ({_share(worst)} of the positions); least often: {least.name} "
        f"({_share(least)}). "
    ) + " ".join(f"{s.name}: {s.told}." for s in slides)
    return Chart("failing-maps", "Where each shortcut is wrong", size, draw_it, rows, text)


def reading(slide: Slide) -> str:
    """What a map shows, in words."""
    row = NAMED[slide.name]
    where = "spots along the contact with A" if slide.path else "positions round A"
    return (
        f"Belief {row.number}, “{row.claim}”: with B on {slide.counts.total()} {where} the shortcut is wrong "
        f"{slide.wrong} times ({_share(slide)}): {slide.told}. In the scene beside the map it gives "
        f"{row.told(row.wrong)}; right is {row.told(row.truth)}. {row.scene.record().truth.sentence}"
    )


def _under(slide: Slide) -> str:
    of = "spots where B touches A" if slide.path else "positions of B's middle"
    return f"wrong at {slide.wrong} of {slide.counts.total()} {of} ({_share(slide)})"


def _share(slide: Slide) -> str:
    return f"{100 * slide.wrong / slide.counts.total():.1f} %"


def _summary(slide: Slide) -> dict[str, Any]:
    found = slide.counts
    names = {code: one for code, (one, _) in WRONG.items()}
    start = {"number": NAMED[slide.name].number, "name": slide.name, "positions": found.total()}
    return start | {"apart": found[APART], "hit": found[HIT]} | {names[code]: found[code] for code in names}


def _lines(slide: Slide) -> list[dict[str, Any]]:
    """The map as rows, one a line of positions (one a position along a contact)."""
    if slide.path:
        return [{"x": x, "y": y, "answer": code} for x, y, code in slide.positions()]
    return [
        {"y": slide.y + j * slide.dy, "x": slide.x, "dx": slide.dx, "answers": line}
        for j, line in enumerate(slide.codes)
    ]


def _part(fig: Figure, box: tuple[float, float, float, float]) -> tuple[float, float, float, float]:
    """A box in points as parts of the figure."""
    w, h = (inches * 72 for inches in fig.get_size_inches())
    return box[0] / w, box[1] / h, box[2] / w, box[3] / h


def _size(slide: Slide, row: Row, room: tuple[float, float]) -> tuple[float, float]:
    """As large as the map can be in that room, in points."""
    x0, y0, x1, y1 = limits(slide, row)
    scale = min(room[0] / (x1 - x0), room[1] / (y1 - y0))
    return (x1 - x0) * scale, (y1 - y0) * scale


def _axes(fig: Figure, box: tuple[float, float, float, float], limits: tuple[float, float, float, float]) -> Axes:
    """Axes on a box in points."""
    ax = fig.add_axes(_part(fig, box))
    ax.set(xlim=limits[::2], ylim=limits[1::2])
    return ax


def _ends(slide: Slide, theme: Theme) -> list[tuple[float, float, str, str]]:
    """A label for each kind of answer, tied to a position well inside its own kind."""
    found = slide.counts
    words = {APART: "right: apart", HIT: "right: a hit"}
    words |= {code: f"{found[code]} {many if found[code] != 1 else one}" for code, (one, many) in WRONG.items()}
    if slide.name in PUSHES:
        words[HIT] = "right push"
    ends = []
    for code, text in words.items():
        if found[code]:
            role = LOOKS[code][0] if code in LOOKS else "ink"
            shade = theme.roles["ink"] if role == "guide" else theme.text.get(role, theme.roles[role])
            ends.append((*_spot(slide, code), text, shade))
    return ends


def _spot(slide: Slide, code: str) -> tuple[float, float]:
    """The position of a kind that is furthest right of those with the most neighbours of their kind."""
    if slide.path:
        return max((x, y) for x, y, letter in slide.positions() if letter == code)
    grid = slide.codes

    def alike(i: int, j: int) -> int:
        near = ((i + s, j + t) for s in (-1, 0, 1) for t in (-1, 0, 1))
        return sum(0 <= j < len(grid) and 0 <= i < len(grid[j]) and grid[j][i] == code for i, j in near)

    every = [(i, j) for j, line in enumerate(grid) for i, letter in enumerate(line) if letter == code]
    middle = len(grid) / 2
    i, j = max(every, key=lambda p: (alike(*p), p[0], -abs(p[1] - middle)))
    return slide.x + i * slide.dx, slide.y + j * slide.dy


def _answers(fig: Figure, row: Row, theme: Theme) -> None:
    """The shortcut's claim and the right answer, over the scene."""
    w, h = (inches * 72 for inches in fig.get_size_inches())
    at = {"ha": "left", "va": "top", "fontsize": TEXT + 1, "parse_math": False}
    lines = ("wrong", f"shortcut: {row.told(row.wrong)}  ({row.how})"), ("ink", f"right: {row.told(row.truth)}")
    for k, (role, text) in enumerate(lines):
        shade = theme.text.get(role, theme.roles[role])
        fig.text(SCENE[0] / w, (h - ABOVE - 18 * k) / h, text, color=shade, **at)

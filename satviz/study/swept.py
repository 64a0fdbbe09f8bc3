"""A shape on its way: on each axis the stretch of time in which the ranges overlap, entry and exit."""

from fractions import Fraction
from typing import Any

from matplotlib.figure import Figure

from ..pictures import Theme
from ..pictures import theme as look
from ..scenes.failing import NAMED, swept
from ..scenes.shortcuts import written
from .cells import Cell, Settings
from .chart import TEXT, Chart, axes, headline

ROW = NAMED["tunnelling"]
SIZE = 780.0, 400.0  # points
FRAMES = 0.0, 1.0  # when the shortcut looks


def cells(settings: Settings) -> list[Cell]:
    """One cell: the windows of the scene."""
    return [Cell("failures-tunnelling", windows, ())]


def windows() -> list[dict[str, Any]]:
    """Each axis with its exact entry and exit as text, and the ranges: A's at the start, its speed, and B's."""
    a, b = written(ROW.a), written(ROW.b)
    rows = []
    for name, n in ("x", (Fraction(1), Fraction(0))), ("y", (Fraction(0), Fraction(1))):
        found, (a0, a1), (b0, b1) = swept.window(a, b, swept.FLIGHT, n), swept.span(a, n), swept.span(b, n)
        speed = sum(v * u for v, u in zip(swept.FLIGHT, n, strict=True))
        numbers = {"a_lo": a0, "a_hi": a1, "speed": speed, "b_lo": b0, "b_hi": b1}
        times = {"enter": str(found.enter), "leave": str(found.leave), "never": found.never}
        rows.append({"axis": name, **times, **{key: float(value) for key, value in numbers.items()}})
    return rows


def charts(results: dict[str, Any]) -> list[Chart]:
    """Place against time on each axis: A's range as a band that moves, B's as one that stays."""
    rows = results["failures-tunnelling"]
    times = [tuple(float(Fraction(row[key])) for key in ("enter", "leave")) for row in rows]
    enter, leave = max(t[0] for t in times), min(t[1] for t in times)

    def draw(fig: Figure, theme: Theme) -> None:
        under = f"contact from t = {enter:g}, the last entry, to t = {leave:g}, the first exit; looked at: t = 0 and 1"
        headline(fig, theme, f"{ROW.number}  “{ROW.claim}”", under)
        for k, (row, own) in enumerate(zip(rows, times, strict=True)):
            _panel(fig, theme, row, own, (enter, leave), k)

    each = " ".join(f"On {row['axis']} the ranges overlap from t = {s:g} to {e:g}." for row, (s, e) in zip(rows, times))
    text = (
        f"Belief {ROW.number}, “{ROW.claim}”. {each} On both at once from t = {enter:g} to {leave:g}: then the bullet "
        f"is in the wall. At t = 0 and t = 1, where the shortcut looks, it is {ROW.wrong:.2f} away."
    )
    return [Chart(f"failing-{ROW.number}-{ROW.name}", f"{ROW.number} {ROW.name}", SIZE, draw, rows, text)]


def _panel(
    fig: Figure, theme: Theme, row: dict[str, Any], own: tuple[float, float], both: tuple[float, float], k: int
) -> None:
    """One axis: its bands, the stretch of time they share, the contact, and when the shortcut looks."""
    ax = axes(fig, (0.06 + 0.5 * k, 0.13, 0.41, 0.66), theme, f"the {row['axis']} axis")
    roles = theme.roles
    a = {end: [row[f"a_{end}"] + row["speed"] * t for t in FRAMES] for end in ("lo", "hi")}
    low, high = min(*a["lo"], row["b_lo"]), max(*a["hi"], row["b_hi"])
    rim = (high - low) * 0.18
    ax.fill_between(FRAMES, row["b_lo"], row["b_hi"], facecolor=roles["B"], alpha=look.FILL, linewidth=0)
    ax.hlines([row["b_lo"], row["b_hi"]], *FRAMES, colors=roles["B"], linestyles="--", lw=1.2)
    ax.fill_between(FRAMES, a["lo"], a["hi"], facecolor=theme.paper, linewidth=0)
    ax.fill_between(FRAMES, a["lo"], a["hi"], facecolor=roles["A"], alpha=0.45, linewidth=0)
    ax.plot(FRAMES, a["lo"], FRAMES, a["hi"], color=roles["A"], lw=1.2)
    ax.axvspan(*both, facecolor=roles["overlap"], alpha=0.3, linewidth=0)
    ax.vlines(both, low - rim, high + rim, colors=roles["overlap"], lw=1)
    ax.hlines(low - rim / 2, *own, colors=roles["overlap"], lw=look.OVERLAP_BAR)
    for t in FRAMES:
        ends = [row[f"a_{end}"] + row["speed"] * t for end in ("lo", "hi")]
        ax.plot([t, t], ends, color=roles["ink"], lw=look.BAR, solid_capstyle="butt")
    ax.set(xlim=(-0.04, 1.04), ylim=(low - rim, high + rim), xlabel="time, in parts of the frame")
    ax.set_xticks([0, 0.25, 0.5, 0.75, 1])

    def say(text: str, x: float, y: float, role: str, **at: str) -> None:
        ax.text(x, y, text, color=theme.text.get(role, roles[role]), fontsize=TEXT, parse_math=False, **at)

    gap = rim / 8
    say("bullet", 0.25, row["a_hi"] + row["speed"] * 0.25 + gap, "A", ha="right", va="bottom")
    say("wall", 0.97, row["b_hi"] - gap if row["speed"] == 0 else row["b_lo"] - gap, "B", ha="right", va="top")
    say("looked at", 0.02, row["a_lo"] - gap, "ink", ha="left", va="top")
    say("looked at", 0.98, row["a_hi"] + row["speed"] + gap, "ink", ha="right", va="bottom")
    say(f"overlap on {row['axis']}", both[0] - 0.02, low - rim / 2 + gap / 2, "overlap", ha="right", va="bottom")
    say(f"enter {both[0]:g}", both[0] - 0.012, high + rim, "overlap", ha="right", va="top")
    say(f"leave {both[1]:g}", both[1] + 0.012, high + rim, "overlap", ha="left", va="top")

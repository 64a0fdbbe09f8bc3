"""A stack that rests: what a test of contact does to a pile of boxes, over time.

Question: does a stack need exact answers to stay still?  Workload: five boxes of 1 kg on a slope, with a small solver
(`workloads/stack.py`), beside the origin and 1,000 km away.  Methods: satviz (`trace.mtv`), SAT with normals of length
1 in float64 and in float32, and upright boxes.  The truth is a stack at rest: not sunk, no energy.  The
claim is refuted if the float64 stack sinks or moves visibly more than the exact one, or the float32 stack no more.
"""

from math import hypot
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...engine.shapes import Polygon
from ...engine.trace import record
from ...pictures import Theme
from ..harness.cells import Cell, JsonRow, Settings
from ..harness.chart import TEXT_POINTS, WIDTH, Chart, add_axes, draw_headline, head_height
from ..workloads.stack import GRAVITY, SLOP, STEP, Contact, Test, simulate
from .mtv_by_method import Push, box_push, sat_push
from .speed_against_accuracy import in_metres

BOXES, FAR = 5, 1e6  # metres
PANELS = (  # (title, test, away, colour role)
    ("satviz", "exact", 0.0, "exact"), ("SAT, float64", "float64", 0.0, "float"),
    ("SAT, float32", "float32", 0.0, "tolerance"), ("upright boxes", "boxes", 0.0, "shortcut"),
    ("satviz", "exact", FAR, "exact"), ("SAT, float64", "float64", FAR, "float"),
    ("SAT, float32", "float32", FAR, "tolerance"), ("upright boxes", "boxes", FAR, "shortcut"),
)  # fmt: skip


def exact_contact(a: Polygon, b: Polygon) -> Contact:
    """Return the contact that satviz finds: none unless the shapes overlap."""
    push = record(a, b).mtv
    length = hypot(*push) if push else 0.0
    return ((push.x / length, push.y / length), length) if push and length else None


def by_push(push: Push) -> Test:
    """Return the test of a method that gives a push: a contact where the push goes outwards."""

    def test(a: Polygon, b: Polygon) -> Contact:
        """Return the contact of one pair."""
        x, y = push(a, b)
        depth = hypot(x, y)
        cx, cy = (sum(v[d] for v in b.corners) / 4 - sum(v[d] for v in a.corners) / 4 for d in (0, 1))
        is_deep = depth > 0 and x * cx + y * cy > 0  # a gap would push B towards A
        return ((x / depth, y / depth), depth) if is_deep else None

    return test


TESTS: dict[str, Test] = {
    "exact": exact_contact,
    "float64": by_push(sat_push(np.float64, unit=True)),
    "float32": by_push(sat_push(np.float32, unit=True)),
    "boxes": by_push(box_push),
}


def cells(settings: Settings) -> list[Cell]:
    """Return a cell for each panel of the chart."""
    seconds = 2 if settings.quick else 10
    return [Cell(f"stack-{test}-{away:.0f}", measure, (test, away, seconds)) for _, test, away, _ in PANELS]


def measure(test: str, away: float, seconds: int) -> JsonRow:
    """Return how far the top box has sunk in metres and the energy in joules, for each step."""
    frames = simulate(TESTS[test], BOXES, round(seconds / STEP), away)
    late = frames[len(frames) // 2 :]
    sunk = [frame.sunk for frame in late]
    return {"test": test, "away": away, "seconds": seconds,
            "sunk": [float(f"{frame.sunk:.6g}") for frame in frames],
            "energy": [float(f"{frame.energy:.6g}") for frame in frames],
            "sunk_at_end": sunk[-1], "jitter": max(sunk) - min(sunk),
            "largest_energy": max(frame.energy for frame in late)}  # fmt: skip


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """Return the chart of small panels: sinking and energy over time, by method, near and far."""
    rows: list[JsonRow] = [row for name, row in found.items() if name.startswith("stack-")]
    by = {(row["test"], row["away"]): row for row in rows}
    exact, fine, coarse = (by[test, FAR] for test in ("exact", "float64", "float32"))
    title = (
        f"A stack {FAR / 1e3:,.0f} km out rests as still with float64 (jitter {in_metres(fine['jitter'])}) as with "
        f"exact tests ({in_metres(exact['jitter'])}); float32 moves it by {in_metres(coarse['jitter'])}"
    )
    lines = (
        f"How far the top one of {BOXES} boxes is below its place, over {rows[0]['seconds']} s. Dotted: the truth, at "
        f"rest. The solver leaves {SLOP * 1e3:g} mm of depth to each contact. Jitter: how far it moves in the second "
        "half.",
    )
    head = head_height(title, lines, WIDTH)
    size = WIDTH, head + 330

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw two rows of four panels: near the origin, and far away."""
        draw_headline(fig, theme, title, *lines)
        wide, tall = 102.0, 104.0
        for k, (name, test, away, role) in enumerate(PANELS):
            row, left, bottom = by[test, away], 70 + (k % 4) * 112, 196 - (k // 4) * 152
            ax = add_axes(fig, (left / WIDTH, bottom / size[1], wide / WIDTH, tall / size[1]), theme)
            xs = np.arange(1, len(row["sunk"]) + 1) * STEP
            shade = theme.roles[role]
            ax.plot(xs, np.clip(np.array(row["sunk"]) * 1e3, *LIMITS), color=shade, lw=1.4)
            ax.axhline(0, color=theme.roles["ink"], lw=1, ls=(0, (1, 2.2)))
            ax.set(xlim=(0, row["seconds"]), ylim=LIMITS[::-1])
            ax.set_title(name, loc="left", fontsize=TEXT_POINTS, color=theme.text.get(role, shade), fontweight="bold")
            words = f"jitter {in_metres(row['jitter'])}\n{row['largest_energy']:.0e} J"
            ax.text(
                0.98, 0.04, words, transform=ax.transAxes, ha="right", fontsize=TEXT_POINTS, color=theme.roles["ink"]
            )
            ax.set_yticks([0, 20, 40], ["0", "20", "40 mm"] if k % 4 == 0 else ["", "", ""])
            ax.set_xticks([row["seconds"] / 2], [f"{row['seconds'] / 2:g} s" if k > 3 else ""])
            if k % 4 == 0:
                ax.set_ylabel("at the origin" if k < 4 else "1,000 km away", fontsize=TEXT_POINTS, fontweight="bold")
        note = (
            f"Lines end at {LIMITS[0]:g} mm and {LIMITS[1]:g} mm. J: the largest energy in the second half, in joules."
        )
        fig.text(6 / WIDTH, 10 / size[1], note, fontsize=TEXT_POINTS, color=theme.roles["guide"])

    text = f"{title}. "
    for row in rows:
        where = f"{row['away'] / 1e3:,.0f} km away" if row["away"] else "at the origin"
        text += f"{row['test']}, {where}: sunk by {row['sunk_at_end'] * 1e3:.3g} mm at the end, jitter "
        text += f"{in_metres(row['jitter'])}, largest energy in the second half {row['largest_energy']:.1e} J. "
    fall = GRAVITY * STEP
    text += f"In one step without a contact a box gains {fall:.2g} m/s, so each false miss is seen as energy."
    return [Chart("resting-stack", title, size, draw, rows, text)]


LIMITS = -20.0, 60.0  # mm, of the panels

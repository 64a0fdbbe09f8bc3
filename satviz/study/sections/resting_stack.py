"""A stack that rests: what a test of contact does to a pile of boxes, over time.

Question: does a stack need exact answers to stay still?  Workload: five boxes of 1 kg on a slope, with a small solver
(`workloads/stack.py`), beside the origin and 1,000 km away.  Methods: satviz (`trace.mtv`), SAT with normals of length
1 in float64 and in float32, and upright boxes.  The truth is a stack at rest: no energy, and not sunk by more than the
depth that the solver leaves to the contacts.  The claim is refuted if the float64 stack moves visibly more than the
exact one or sinks by more than this depth, or if the float32 stack far away does not.
"""

from collections.abc import Sequence
from math import hypot
from typing import Any

import numpy as np
from matplotlib.figure import Figure

from ...engine.shapes import Polygon
from ...engine.trace import record
from ...pictures import Theme
from ...render.chart import Chart, JsonRow, add_axes, add_text
from ..harness.cells import Cell, Settings
from ..workloads.stack import GRAVITY, SLOP, STEP, Contact, Test, simulate
from .mtv_by_method import Push, box_push, sat_push
from .speed_against_accuracy import in_metres

BOXES, FAR = 5, 1e6  # metres
METHODS = {  # test: (name, colour role)
    "exact": ("satviz", "exact"), "float64": ("SAT, float64", "float"),
    "float32": ("SAT, float32", "tolerance"), "boxes": ("upright boxes", "shortcut"),
}  # fmt: skip
TENTH = 6  # steps of a tenth of a second
APART = 1 / 3  # metres between stacks of one place, so that their coordinates round in other ways
PLACES = {0.0: "origin", FAR: "1,000 km"}
VISIBLE = 1e-3  # metres of jitter that are seen
LIMITS = -20.0, 60.0  # mm, of the panels
MOST_ENERGY, LINEAR_ENERGY = 1e4, 1e-6  # joules: the highest that is drawn, and below which the scale is linear


def exact_contact(a: Polygon, b: Polygon) -> Contact:
    """Return satviz's (unit normal from A to B, depth) of an overlap, from the MTV; None unless the shapes overlap."""
    push = record(a, b).mtv
    length = hypot(*push) if push else 0.0
    return ((push.x / length, push.y / length), length) if push and length else None


def by_push(push: Push) -> Test:
    """Return a Test, which finds a contact along the push of a method where that points from A to B, else None."""

    def test(a: Polygon, b: Polygon) -> Contact:
        """Return (unit normal from A to B, depth), or None."""
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
    """Return a cell for each method and place."""
    size = (2, 1) if settings.quick else (10, 6)
    return [Cell(f"stack-{test}-{away:.0f}", measure, (test, away, *size)) for test in METHODS for away in PLACES]


def measure(test: str, away: float, seconds: int, stacks: int) -> JsonRow:
    """Return how far the top box has sunk in metres, and the energy in joules, for each tenth of a second.

    `test`: a name in TESTS; `away`: metres from the origin; `stacks`: how many stand there, `APART` from each other.
    An energy is the largest of its tenth of a second.  `jitter` (the range of the sunk heights) and `largest_energy`
    are taken over the second half of the run.  All figures are of the first stack; `jitters` are those of all.
    """
    runs = [simulate(TESTS[test], BOXES, round(seconds / STEP), away + k * APART) for k in range(stacks)]
    frames, half = runs[0], len(runs[0]) // 2
    late = frames[half:]
    jitters = [max(frame.sunk for frame in run[half:]) - min(frame.sunk for frame in run[half:]) for run in runs]
    return {"test": test, "away": away, "seconds": seconds, "jitters": jitters,
            "sunk": [float(f"{frame.sunk:.4g}") for frame in frames[TENTH - 1 :: TENTH]],
            "energy": [float(f"{max(frame.energy for frame in frames[k : k + TENTH]):.3g}")
                       for k in range(0, len(frames), TENTH)],
            "sunk_at_end": frames[-1].sunk, "jitter": jitters[0],
            "largest_energy": max(frame.energy for frame in late)}  # fmt: skip


def rows(found: dict[str, Any]) -> dict[str, list[JsonRow]]:
    """Return {stem of the chart: its rows}, one for each method and place; found: the results by cell name."""
    return {"resting-stack": [row for name, row in found.items() if name.startswith("stack-")]}


def _span(lengths: Sequence[float]) -> str:
    """Return the least and the largest of these lengths in words."""
    return " to ".join(dict.fromkeys((in_metres(min(lengths)), in_metres(max(lengths)))))


def chart(rows: Sequence[JsonRow], settings: Settings) -> Chart:
    """Return the chart of small panels: sinking and energy over time, by method, near and far."""
    by = {(row["test"], row["away"]): row for row in rows}
    seconds = rows[0]["seconds"]
    exact, fine, coarse = (by[test, FAR]["jitters"] for test in ("exact", "float64", "float32"))
    how, than = ("less still", "than") if max(fine) - max(exact) > VISIBLE else ("as still", "as")
    title = (
        f"A stack {FAR / 1e3:,.0f} km out rests {how} with float64 (jitter {_span(fine)}) {than} with "
        f"exact tests ({_span(exact)}); with float32 its jitter is {_span(coarse)}"
    )
    lines = (
        f"{BOXES} boxes over {seconds} s. Left: how far the top one is below its place, in mm. Right: kinetic energy "
        "in joules. Dotted: the truth, at rest. Below: the jitter and the largest energy of the second half. The title "
        f"has the jitters of {len(exact)} stacks; one of them is drawn.",
    )
    height = 30 + 118.0 * len(METHODS) + 40

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw a row of four panels for each method: sinking and energy, at the origin and far away."""
        wide, tall, ink = 70.0, 60.0, theme.roles["ink"]
        columns = [(what, away) for what in ("sunk", "energy") for away in PLACES]
        for k, (what, away) in enumerate(columns):
            left = 30 + 80 * k + 24 * (k > 1)
            words = f"{'sunk' if what == 'sunk' else 'energy'},\n{PLACES[away]}"
            add_text(fig, left + wide / 2, height - 18, words, ha="center", va="center",
                     color=theme.roles["guide"], linespacing=1.05)  # fmt: skip
            for n, (test, (name, role)) in enumerate(METHODS.items()):
                row, shade = by[test, away], theme.roles[role]
                top = height - 40 - 118 * n
                if k == 0:
                    bold = theme.text.get(role, shade)
                    add_text(fig, 6, top - 8, name, va="center", color=bold, fontweight="bold")
                ax = add_axes(fig, (left, top - 20 - tall, wide, tall), theme)
                xs = np.arange(1, len(row[what]) + 1) * STEP * TENTH
                ax.axhline(0, color=ink, lw=1, ls=(0, (1, 2.2)))
                ax.set(xlim=(0, seconds))
                if what == "sunk":
                    ax.plot(xs, np.clip(np.array(row["sunk"]) * 1e3, *LIMITS), color=shade, lw=1.4)
                    ax.set(ylim=LIMITS[::-1])
                    ax.set_yticks([0, 40], ["0", "40"] if k == 0 else ["", ""])
                    words = in_metres(row["jitter"])
                else:
                    ax.plot(xs, np.minimum(row["energy"], MOST_ENERGY), color=shade, lw=1.2)
                    ax.set_yscale("symlog", linthresh=LINEAR_ENERGY, linscale=0.3)
                    ax.set(ylim=(-LINEAR_ENERGY / 2, MOST_ENERGY))
                    ax.set_yticks([0, 1e-3, 1], ["0", "10⁻³", "1"] if k == 2 else ["", "", ""])
                    ax.minorticks_off()
                    words = f"{row['largest_energy']:.0e} J"
                ax.set_xticks([])
                ax.set_xlabel(words, labelpad=3)
        note = f"Cut off: depths beyond −{-LIMITS[0]:g} and {LIMITS[1]:g} mm, energies beyond {MOST_ENERGY:,.0f} J."
        add_text(fig, 6, 10, note, color=theme.roles["guide"])

    text = f"{title}. "
    for row in rows:
        where = f"{row['away'] / 1e3:,.0f} km away" if row["away"] else "at the origin"
        text += f"{row['test']}, {where}: sunk by {row['sunk_at_end'] * 1e3:,.1f} mm at the end, jitter "
        text += f"{in_metres(row['jitter'])} (in all stacks {_span(row['jitters'])}), "
        text += f"largest energy in the second half {row['largest_energy']:.1e} J. "
    text += (
        f"The solver leaves {SLOP * 1e3:g} mm of depth to each of {BOXES} contacts, so a stack may rest anywhere down "
    )
    text += f"to {BOXES * SLOP * 1e3:g} mm; the first steps decide where. "
    fall = GRAVITY * STEP
    text += f"In one step without a contact a box gains {fall:.2g} m/s, so each missed hit is seen as energy."
    return Chart("resting-stack", title, lines, height, draw, rows, text)


CHARTS = {"resting-stack": chart}

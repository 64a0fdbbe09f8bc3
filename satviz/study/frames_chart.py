"""The benchmark's frames as a chart: time from raw arrays to all colliding pairs against the number of shapes."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import chain, groupby
from textwrap import wrap
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ..pictures import Theme
from ..render.chart import TEXT_LETTER, TEXT_LINE, WIDTH, Chart, add_axes, add_text, label_points
from .bench import PLAIN_SAT, TimingRow
from .bench_table import faster_from, spread_of, wrong_counts
from .harness.chart import label_ends, set_time_ticks
from .harness.timings import Spread, least_of
from .methods import ENGINES
from .methods.scene_methods import DIFFERENCES

AXES, PANEL = 220.0, 310.0  # points: the height of the axes of one work, and of all that it takes but its sentences
SHADES = {"satviz numba": "gap", "satviz numpy": "A"}  # short programs are as B, libraries grey
DASHES = {
    "brute force": ":",
    "short sweep": (0, (1, 2, 4, 2)),
    "STRtree": "--",
    "prepared STRtree": (0, (5, 1, 1, 1)),
    "Box2D": "-.",
    "cKDTree": (0, (3, 1)),
}
TICKS = 10, 1000, 100_000
BETWEEN = 6  # points on a line between two sizes that labels keep off
SHORT_PROGRAMS = "brute force", "sort and sweep", "short sweep"  # the other rivals are libraries

EndLabel = tuple[float, float, str, str]  # x, y, text, colour
Times = Mapping[str, Mapping[int, Spread]]  # the times of one work in ns, by method and by number of shapes


def frames_chart(rows: Sequence[TimingRow], warning: str) -> Chart:
    """Return the chart of the sections "frames" and "arrays"; `warning`: why their times are only rough, or empty."""
    works = {work: times_of(rows, work) for work in dict.fromkeys(r.work for r in rows if r.section == "frames")}
    fastest = {work: fastest_by_size(times) for work, times in works.items()}
    below = {work: [crossings(times, m) for m in sorted(ENGINES) if m in times] for work, times in works.items()}
    differences = [words for method, words in DIFFERENCES.items() if any(method in times for times in works.values())]
    note = " ".join([*differences, *_stopped_early(works)])
    reading = " ".join(f"{work.capitalize()}. {fastest[work]} {' '.join(said)}" for work, said in below.items())
    counted = (
        f"Wrong answers {whose}: {wrong}."
        for whose, own in (
            ("of satviz, both engines together", [r for r in rows if r.method.startswith(tuple(ENGINES))]),
            ("of the others, all together", [r for r in rows if not r.method.startswith(tuple(ENGINES))]),
        )
        if (wrong := wrong_counts(own))
    )
    title, subtitle = headline_of(works)
    reading = " ".join([reading, *_notes_of_arrays(rows), note, *counted])

    all_times = [spread.middle for times in works.values() for own in times.values() for spread in own.values()]
    low, high = min(all_times), max(all_times)
    above = {work: wrapped(fastest[work]) for work in works}
    beneath = {work: [line for said in below[work] for line in wrapped(said)] for work in works}
    ending = wrapped(note)
    tall = len(works) * PANEL + TEXT_LINE * len([*ending, *chain(*above.values(), *beneath.values())]) + 30

    def draw(fig: Figure, theme: Theme) -> None:
        """Draw the charts of all works below each other, each between its sentences, and the note at the bottom."""
        up = tall - 8
        for work, times in works.items():
            _write_lines(fig, theme, up, [work.capitalize()], fontweight="bold")
            _write_lines(fig, theme, up - TEXT_LINE, above[work])
            up -= TEXT_LINE * (1 + len(above[work])) + 8
            ax = add_axes(fig, (56, up - AXES, 186, AXES), theme)
            _draw_times(ax, theme, times, (low / 1.5, high * 3))
            _write_lines(fig, theme, up - AXES - 40, beneath[work])
            up -= PANEL - TEXT_LINE - 8 + TEXT_LINE * len(beneath[work])
        _write_lines(fig, theme, up, ending)

    own = [row._asdict() for row in rows]
    return Chart("frames", title, [subtitle], tall, draw, own, reading, warning)


def wrapped(text: str) -> list[str]:
    """Return the lines of a text, wrapped to the chart's width."""
    return wrap(text, int((WIDTH - 12) / TEXT_LETTER))


def headline_of(works: Mapping[str, Times]) -> tuple[str, str]:
    """Return (title, subtitle): where the best engine passes all libraries, and how it compares to short programs.

    Only sizes at which a rival was timed count; the title ends with the largest size at which all libraries were.
    """
    engine = next(name for name in sorted(ENGINES) if all(name in times for times in works.values()))
    starts, lasts, ratios = list[int | None](), list[int](), list[float]()
    for times in works.values():
        own = times[engine]
        libraries = [times[m] for m in times if not m.startswith((*ENGINES, *SHORT_PROGRAMS))]
        starts += [faster_from(own, library) for library in libraries]
        lasts += [max(own.keys() & library.keys(), default=0) for library in libraries]
        programs = [times[m] for m in SHORT_PROGRAMS if m in times]
        ratios += [min(p[n].middle for p in programs if n in p) / t.middle for n, t in own.items()
                   if any(n in p for p in programs)]  # fmt: skip
    known = [start for start in starts if start is not None]
    than = ""
    if known and known == starts and max(known) <= min(lasts):
        than = f" is faster than each library here, {_from_to(sorted({max(known), min(lasts)}))} shapes"
    subtitle = "Time of one frame, from arrays to all colliding pairs. satviz is exact"
    against = (
        f"; the fastest short program in floats (orange) takes {min(ratios):.1f} to {max(ratios):.1f} times as "
        f"long as {engine}"
        if ratios
        else ""
    )
    return f"{engine}{than or ' beside the fastest methods'}", f"{subtitle}{against}."


def times_of(rows: Sequence[TimingRow], work: str) -> Times:
    """Return the times {method: {number of shapes: spread in ns}} of one kind of work in the section of frames."""
    found: dict[str, dict[int, Spread]] = {}
    for row in rows:
        if (row.section, row.work) == ("frames", work):
            found.setdefault(row.method, {})[row.size] = Spread(*(1e3 * t for t in spread_of(row)))
    return found


def fastest_by_size(times: Times) -> str:
    """Return a sentence with the method of one work that is the fastest, by range of sizes.

    Sizes are left out at which several methods cannot be told apart.
    """
    sizes = sorted({size for own in times.values() for size in own})
    at = [least_of({method: own[size] for method, own in times.items() if size in own}) for size in sizes]
    runs = [(methods, [sizes[k] for k in run]) for methods, run in groupby(range(len(sizes)), at.__getitem__)]
    known: dict[str, list[str]] = {}
    for methods, run in runs:
        if len(methods) == 1:
            known.setdefault(methods[0], []).append(_from_to(run))
    if not known:
        return "At no size is one method clearly the fastest."
    parts = [f"{method} {' and '.join(ranges)}" for method, ranges in known.items()]
    if any(len(methods) > 1 for methods, _ in runs):
        parts.append("at other sizes it is not clear")
    return f"Fastest: {'; '.join(parts)}."


def crossings(times: Times, engine: str) -> str:
    """Return a sentence that says from which size on an engine is faster or slower than each rival.

    A rival that cannot be told apart from it at the largest size of both is named last.
    """
    found: dict[str, dict[str, list[str]]] = {"faster than": {}, "slower than": {}, "not told apart from": {}}
    for rival, other in times.items():
        own = times[engine]
        sizes = sorted(own.keys() & other.keys())
        if rival.startswith(tuple(ENGINES)) or not sizes:
            continue
        if (start := faster_from(own, other)) is not None:
            words = "faster than"
        elif (start := faster_from(other, own)) is not None:
            words = "slower than"
        else:
            words, start = "not told apart from", sizes[-1]
        ends_early = sizes[-1] < max(own)
        where = "" if start > sizes[0] else f"up to {sizes[-1]:,}" if ends_early else "at all sizes"
        where = where or (f"at {start:,}" if start == sizes[-1] else f"from {start:,} on")
        found[words].setdefault(where, []).append(rival)
    parts = [f"{words} " + ", ".join(f"{' and '.join(rivals)} {where}" for where, rivals in by.items())
             for words, by in found.items() if by]  # fmt: skip
    return f"{engine}: {'; '.join(parts)}." if parts else f"{engine}: timed alone."


def _stopped_early(works: Mapping[str, Times]) -> Iterator[str]:
    """Yield a sentence for the methods that were not timed up to the largest size: where each of them ends."""
    ends: dict[str, int] = {}
    for times in works.values():
        ends |= {method: max(own) for method, own in times.items()}
    for last in sorted({*ends.values()} - {max(ends.values())}):
        yield f"Timed up to {last:,} shapes only: {', '.join(m for m, end in ends.items() if end == last)}."


def _from_to(sizes: Sequence[int]) -> str:
    """Return the first and the last of these numbers of shapes in words: "10 to 1,000", or "at 10"."""
    return f"{sizes[0]:,} to {sizes[-1]:,}" if len(sizes) > 1 else f"at {sizes[0]:,}"


def _notes_of_arrays(rows: Sequence[TimingRow]) -> Iterator[str]:
    """Yield sentences: the time of `hits` from raw arrays beside plain SAT, and the cost of one large or far box."""
    arrays = [row for row in rows if row.section == "arrays"]
    times = {row.method: row for row in arrays}
    if (plain := times.get(PLAIN_SAT)) is not None:
        said = (f"{m} {times[m].time:.0f} ({times[m].time / plain.time:.1f} times)" for m in ENGINES if m in times)
        yield f"{plain.work.capitalize()}, from arrays, ns a pair: {PLAIN_SAT} {plain.time:.0f}, {', '.join(said)}."
    parts = [
        f"{row.method} {row.time / base.time:.2f}"
        for engine in ENGINES
        if (base := times.get(f"{engine}, plain"))
        for row in arrays
        if row.method.startswith(f"{engine}, ") and row is not base
    ]
    if parts:
        (work,) = {row.work for row in arrays if row.method.endswith(", plain")}
        yield f"{work.capitalize()}, as a multiple of the same without it: {'; '.join(parts)}."


def _draw_times(ax: Axes, theme: Theme, times: Times, limits: tuple[float, float]) -> None:
    """Draw the lines of one work, satviz's on top, each with its name at its end; limits: least and largest ns."""
    last = max(size for own in times.values() for size in own)
    ends, inner = list[EndLabel](), list[EndLabel]()
    points = list[tuple[float, float]]()
    for method, own in times.items():
        sizes, strong = sorted(own), method in ENGINES
        role = "B" if method in SHORT_PROGRAMS else SHADES.get(method.removesuffix(", moved"), "guide")
        values = [own[size].middle for size in sizes]
        ax.plot(sizes, values, ls=DASHES.get(method, "-"), color=theme.roles[role], lw=2.6 if strong else 1.3,
                marker="o" if strong else None, ms=4, zorder=3 if strong else 2)  # fmt: skip
        label = sizes[-1], values[-1], method, theme.text.get(role, theme.roles[role])
        (ends if sizes[-1] == last else inner).append(label)
        along = np.linspace(0, len(sizes) - 1, BETWEEN * (len(sizes) - 1) + 1)
        at, logs = np.arange(len(sizes)), (np.log(sizes), np.log(values))
        on_line = list(zip(*(np.exp(np.interp(along, at, log)).tolist() for log in logs)))
        points += on_line if sizes[-1] == last else on_line[:-1]  # the end of another line is where its own label is
    ax.set(xscale="log", yscale="log", ylim=limits)
    ax.set_xticks(TICKS, [f"{n:,}" for n in TICKS])
    ax.set_xlabel("shapes")
    ax.minorticks_off()
    set_time_ticks(ax.yaxis, limits)
    label_ends(ax, ends)
    label_points(ax, inner, theme, points)


def _write_lines(fig: Figure, theme: Theme, up: float, lines: Sequence[str], **style: Any) -> None:
    """Write lines of text below each other; up: the top of the first, in points above the figure's lower edge."""
    for k, line in enumerate(lines):
        add_text(fig, 6, up - k * TEXT_LINE, line, color=theme.roles["ink"], va="top", **style)

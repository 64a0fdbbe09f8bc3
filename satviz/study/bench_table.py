"""The text that `satviz bench` prints: the measured rows as a table, the wrong answers, and warnings about times."""

from collections.abc import Mapping, Sequence

import numpy as np

from .bench import CHECKED_BY, TimingRow
from .harness.timings import BUSY_SPREAD, Spread


def bench_table(rows: list[TimingRow]) -> str:
    """Return the rows as text, section by section: each time beside its ratio to shapely's time for the same work."""
    lines = []
    for section in dict.fromkeys(row.section for row in rows):
        own = [row for row in rows if row.section == section]
        lines += _lines_by_size(own) if any(row.size for row in own) else _lines_by_method(own)
        lines.append("")
    return "\n".join(lines)


def _lines_by_method(rows: list[TimingRow]) -> list[str]:
    """Return a block of lines for each work: a heading, then one line for each method, the fastest first."""
    lines = []
    for work in dict.fromkeys(row.work for row in rows):
        block = sorted((row for row in rows if row.work == work), key=lambda row: row.time)
        shapely_time = next((row.time for row in block if row.method == "shapely"), None)
        checked = max(row.checked for row in block)
        unit = block[0].unit if block[0].section != "pairs" else "ns a pair"
        heading = f"{work:40}{unit:>14}{'quartiles':>20}{'x shapely':>11}"
        lines.append(heading + (f"   wrong of {checked:,}" if checked else ""))
        for row in block:
            ratio = f"{shapely_time / row.time:.1f}" if shapely_time else ""
            wrong = f"{row.wrong:8}" if row.checked else ""
            lines.append(f"  {row.method:38}{row.time:14.1f}{row.low:10.1f}{row.high:10.1f}{ratio:>11}{wrong}")
        lines.append("")
    return lines[:-1]


def _lines_by_size(rows: list[TimingRow]) -> list[str]:
    """Return one line for each work and method: its time at each size, and the exponent of its growth."""
    sizes = list(dict.fromkeys(row.size for row in rows))
    section, unit = rows[0].section, rows[0].unit
    lines = [f"{section + ', ' + unit:52}" + "".join(f"{n:>10,}" for n in sizes) + f"{'growth':>8}"]
    for work, method in dict.fromkeys((row.work, row.method) for row in rows):
        times = {row.size: row.time for row in rows if (row.work, row.method) == (work, method)}
        line = "".join(f"{times[n]:10.1f}" if n in times else f"{'':10}" for n in sizes)
        lines.append(f"  {work + ', ' + method:50}{line}{growth_exponent(times):8.2f}")
    return [*lines, f"  wrong: {wrong}"] if (wrong := wrong_counts(rows)) else lines


def wrong_counts(rows: Sequence[TimingRow]) -> str:
    """Return a text with the wrong and the checked answers by kind of check; empty if nothing was checked."""
    parts = []
    for by, words in CHECKED_BY.items():
        own = [row for row in rows if row.by == by]
        if own:
            wrong, checked = sum(row.wrong for row in own), sum(row.checked for row in own)
            parts.append(f"{wrong:,} of {checked:,} {words}")
    return ", ".join(parts)


def growth_exponent(times: Mapping[int, float]) -> float:
    """Return the exponent k of times ~ size**k over the last three sizes (least squares); NaN for a single size."""
    last = sorted(times)[-3:]
    if len(last) == 1:
        return float("nan")
    x, y = np.log(last), np.log([times[n] for n in last])
    return float(((x - x.mean()) * (y - y.mean())).sum() / ((x - x.mean()) ** 2).sum())


def spread_of(row: TimingRow) -> Spread:
    """Return the time of a row with its quartiles."""
    return Spread(row.time, row.low, row.high)


def faster_from(own: Mapping[int, Spread], rival: Mapping[int, Spread]) -> int | None:
    """Return the smallest size from which on `own` is faster than the rival; None if it is not at the largest."""
    start = None
    for size in sorted(own.keys() & rival.keys()):
        start = None if not own[size].is_below(rival[size]) else size if start is None else start
    return start


def busy_warning(rows: list[TimingRow]) -> str:
    """Return a warning if more than a quarter of the times have quartiles far apart; otherwise an empty string."""
    timed = [row for row in rows if row.section not in ("memory", "starts")]
    spread = [row for row in timed if row.high - row.low > BUSY_SPREAD * row.time]
    if len(spread) * 4 <= len(timed):
        return ""
    count = f"{len(spread)} of {len(timed)}"
    return f"rough figures: {count} have quartiles more than {BUSY_SPREAD:.0%} apart; the machine was busy"


def numba_break_even(rows: list[TimingRow]) -> str:
    """Return a sentence: what numba's start costs a new process, and after how many pairs its speed repays that."""
    ns = {row.method: row.time for row in rows if (row.section, row.work) == ("pairs", "triangles")}
    ms = {row.method: row.time for row in rows if row.section == "starts"}
    saved, cost = ns["satviz numpy"] - ns["satviz numba"], ms["satviz numba"] - ms["satviz numpy"]
    if saved <= 0:
        return f"numba starts {cost:.0f} ms later and saved nothing on triangles here"
    pays = f"it pays from {cost / saved:.1f} million pairs on"
    return f"numba starts {cost:.0f} ms later and saves {saved:.0f} ns a pair of triangles: {pays}"

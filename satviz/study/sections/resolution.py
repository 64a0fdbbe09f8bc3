"""Speed against resolution: up to which gamma each method was found wrong, and what it takes a pair.

gamma is how hard a pair is for floats, whatever made it hard; so this measure says how good a method is,
where a rate of wrong answers says how its workload was made.
"""

from collections.abc import Sequence
from functools import partial
from math import log2
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ...pictures import Theme
from ..lab.cells import Cell, Settings
from ..lab.chart import TEXT, Chart, axes, colour, headline, label_ends, label_points, table, time_ticks, told, wilson
from ..lab.machine import installed
from ..lab.times import rough, timed
from ..methods import COMPILED, NUMPY, PYTHON, asked, methods, mistakes, truths, wrong
from ..pairs.hard import EXTREME, KINDS, OCTAVES, hard, octave, touching
from ..pairs.workloads import ngons

Row = dict[str, Any]
Key = tuple[str, str]  # language, name
KILOMETRE = 2.0**-53 * 1e3  # what gamma 1 is, as a gap in metres, where coordinates reach a kilometre
ATOM = 1e-10  # metres
ANY = 2.0 ** (max(OCTAVES) - 1)  # wrong up to here is wrong at any gamma
EVERY = (*KINDS, EXTREME)
NEVER, PROVED, LOOSE = "none wrong seen", "exact by construction", "wrong at any distance"


def cells(settings: Settings) -> list[Cell]:
    """For each kind of hardness, and for exact touching and ordinary pairs, what is counted; and the times."""
    each, many = (12, 400) if settings.quick else (120, 10_000)
    found = [Cell(f"hard-{_slug(kind.name)}", count_hard, (i, each, settings)) for i, kind in enumerate(EVERY)]
    found += [Cell(f"count-{work}", count, (work, many, settings)) for work in ("touching", "ordinary")]
    sizes = (
        {COMPILED: 30_000, NUMPY: 4000, PYTHON: 200}
        if settings.quick
        else {COMPILED: 100_000, NUMPY: 20_000, PYTHON: 1000}
    )
    rounds = 5 if settings.quick else 21
    return [*found, Cell("resolution-times", take_times, (sizes, rounds, settings), timed=True)]


def count_hard(kind: int, each: int, settings: Settings) -> list[Row]:
    """Each method on one kind: how many pairs of each octave of gamma were wrong, and the largest gamma of those."""
    a, b, gamma = hard(EVERY[kind], settings.rng("hard", EVERY[kind].name), each)
    right, bins = truths(a, b), np.clip(octave(gamma) - OCTAVES.start, 0, len(OCTAVES) - 1)
    rows = []
    for method, said in asked(methods(), a, b):
        bad = wrong(said, right)
        row: Row = {"kind": EVERY[kind].name, "language": method.language, "method": method.name}
        row |= {
            "family": method.family,
            "pairs": len(a),
            "wrong": int(bad.sum()),
            "gamma": float(max(gamma[bad], default=0)),
        }
        row["pairs_by_octave"] = np.bincount(bins, minlength=len(OCTAVES)).tolist()
        row["wrong_by_octave"] = np.bincount(bins[bad], minlength=len(OCTAVES)).tolist()
        rows.append(row)
    return rows


def count(work: str, n: int, settings: Settings) -> list[Row]:
    """Each method on exactly touching or on ordinary pairs."""
    rng = settings.rng(work)
    a, b = touching(rng, n) if work == "touching" else _ordinary(rng, n)
    right, rows = truths(a, b), []
    for method, said in asked(methods(), a, b):
        found = mistakes(said, right)
        row = {"language": method.language, "method": method.name, "pairs": n, "wrong": sum(found.values()), **found}
        rows.append(row)
    return rows


def _ordinary(rng: np.random.Generator, n: int) -> tuple[Any, Any]:
    return ngons(rng, n, 4, 1.2), ngons(rng, n, 4, 1.2)


def take_times(sizes: dict[str, int], rounds: int, settings: Settings) -> list[Row]:
    """Nanoseconds a pair of ordinary 4-gons that are ready, in turn within each round, language by language."""
    rows = []
    for language, n in sizes.items():
        a, b = _ordinary(settings.rng("times"), n)
        mine = {m.name: m for m in methods() if m.language == language}
        jobs = {name: partial(m.hits, m.prepare(a), m.prepare(b)) for name, m in mine.items()}
        for name, times in timed(jobs, rounds, dict.fromkeys(jobs, n)).items():
            rows.append({"language": language, "method": name, **times})
    return rows


def charts(found: dict[str, Any], settings: Settings) -> list[Chart]:
    """The main one; the rates behind it; the kinds of hardness apart; and the interpreted methods."""
    interpreted = _interpreted(rows(found), settings)
    if not installed("numba"):
        return [interpreted]
    return [main_chart(rows(found), settings), _rates(found), _kinds(found), interpreted]


def rows(found: dict[str, Any]) -> list[Row]:
    """A row a method: the largest gamma wrong over all kinds but the extreme sizes, and its time."""
    ordinary, touches, times = (
        {_key(row): row for row in found[name]} for name in ("count-ordinary", "count-touching", "resolution-times")
    )
    counted = [row for kind in KINDS for row in found[f"hard-{_slug(kind.name)}"]]
    each = np.sum([found[f"hard-{_slug(kind.name)}"][0]["pairs_by_octave"] for kind in KINDS], axis=0)[2:-1]
    made = []
    for key in dict.fromkeys(map(_key, counted)):
        mine = [row for row in counted if _key(row) == key]
        gamma = max(row["gamma"] for row in mine)
        touch, plain, time = touches[key], ordinary[key], times[key]
        bad = sum(row["wrong"] for row in mine)
        row = {"language": key[0], "method": key[1], "family": mine[0]["family"], "gamma": gamma}
        row |= {"pairs": sum(row["pairs"] for row in mine), "wrong": bad, "least_an_octave": int(each.min())}
        row |= {"touching": touch["pairs"], "touching_wrong": touch["wrong"]}
        row |= {"ordinary": plain["pairs"], "ordinary_wrong": plain["wrong"]}
        clean = not bad and not touch["wrong"]
        row["lane"] = LOOSE if gamma > ANY else "" if not clean else PROVED if row["family"] == "exact" else NEVER
        made.append({**row, **{k: round(time[k], 3) for k in ("ns", "ns_low", "ns_high")}})
    return made


def _key(row: Row) -> Key:
    return row["language"], row["method"]


def _slug(name: str) -> str:
    return name.replace(" ", "-")


# -- the main chart ----------------------------------------------------------------------------------

LENGTHS = {"1 mm": 1e-3, "1 µm": 1e-6, "1 nm": 1e-9, "1 pm": 1e-12}
WIDE, ROW, SCALE = 640.0, 17.0, 190.0  # points


def main_chart(rows: Sequence[Row], settings: Settings) -> Chart:
    """The compiled ones, from their rows alone."""
    mine = [row for row in rows if row["language"] == COMPILED]
    gap = _floats(mine) * KILOMETRE
    small = "gaps smaller than an atom" if 0 < gap < ATOM else f"gaps below {_length(_floats(mine))}"
    title = f"In a scene of 1 km, SAT in plain floats errs only at {small}"
    return _scatter("speed-against-accuracy", title, mine, settings)


def _interpreted(rows: Sequence[Row], settings: Settings) -> Chart:
    mine = [{**row, "method": f"{row['method']}, {row['language']}"} for row in rows if row["language"] != COMPILED]
    least = {
        language: told(
            min(
                (row["ns"] for row in rows if row["language"] == language and row["method"] == "SAT, raw normals"),
                default=0.0,
            )
        )
        for language in (COMPILED, NUMPY, PYTHON)
    }
    title = f"SAT by language: {', '.join(f'{time} {language}' for language, time in least.items())}; its errors stay"
    return _scatter("interpreted", title, mine, settings)


def _floats(rows: Sequence[Row]) -> float:
    """The largest gamma at which SAT in float64 was wrong."""
    return max(
        (row["gamma"] for row in rows if row["family"] == "float SAT" and "float32" not in row["method"]), default=0.0
    )


def _length(gamma: float) -> str:
    """The gap in a scene a kilometre across."""
    metres = gamma * KILOMETRE
    for size, unit in (1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm"), (1e-12, "pm"):
        if metres >= size:
            return f"{metres / size:.2g} {unit}"
    return f"{metres / 1e-12:.1g} pm"


def _scatter(stem: str, title: str, rows: Sequence[Row], settings: Settings) -> Chart:
    """Lanes for what gamma cannot rank, and between them what was wrong up to some gamma, to scale."""
    lanes = {
        name: sorted((r for r in rows if r["lane"] == name), key=lambda r: r["ns"])
        for name in (LOOSE, "", NEVER, PROVED)
    }
    tall = {name: SCALE if not name else 24 + ROW * len(mine) for name, mine in lanes.items() if mine}
    head, foot = 66.0, 42.0
    size = WIDE, head + foot + sum(tall.values()) + 10 * (len(tall) - 1)
    limits = min(r["ns"] for r in rows) / 1.6, max(r["ns"] for r in rows) * 14
    n = rows[0]

    def draw(fig: Figure, theme: Theme) -> None:
        under = (
            "further left: faster; further down: finer; bars: quartiles of the time",
            f"{n['pairs']:,} pairs made hard in {len(KINDS)} ways, at least {n['least_an_octave']:,} an octave of gap, "
            f"and {n['touching']:,} that touch",
        )
        headline(fig, theme, title, *under)
        top = size[1] - head
        for name, mine in lanes.items():
            if not mine:
                continue
            top -= tall[name]
            ax = axes(fig, (86 / WIDE, top / size[1], (WIDE - 100) / WIDE, tall[name] / size[1]), theme)
            ax.set(xscale="log", xlim=limits)
            last = name == [key for key in lanes if lanes[key]][-1]
            time_ticks(ax.xaxis, limits, words=last)
            if last:
                ax.set_xlabel("time a pair of ordinary 4-gons, shapes made ready beforehand")
            if name:
                _lane(ax, theme, name, mine)
            else:
                _levels(ax, theme, mine)
            top -= 10

    return Chart(stem, title, size, draw, list(rows), _reading(rows), rough(rows, settings))


def _lane(ax: Axes, theme: Theme, name: str, rows: Sequence[Row]) -> None:
    """A line each, no order of quality."""
    ax.set(yticks=[], ylim=(24 + ROW * len(rows), 0))
    ax.spines["left"].set_visible(False)
    words = {LOOSE: "wrong at\nany gap", NEVER: "none wrong\nseen", PROVED: "exact by\nconstruction"}[name]
    ax.annotate(
        words,
        (0, 0.5),
        (-8, 0),
        xycoords="axes fraction",
        textcoords="offset points",
        ha="right",
        va="center",
        color=theme.roles["ink"],
        fontsize=TEXT,
        annotation_clip=False,
    )
    for i, row in enumerate(rows):
        y, shade = 12 + ROW * (i + 0.5), colour(theme, row["family"])
        ax.plot([row["ns_low"], row["ns_high"]], [y, y], color=shade, lw=1)
        ax.plot([row["ns"]], [y], "D" if name == PROVED else "o", color=shade, ms=6)
        text = row["method"]
        if name == LOOSE:
            text += (
                f": {row['ordinary_wrong'] / row['ordinary']:.0%} of ordinary pairs wrong"
                if row["ordinary_wrong"]
                else ""
            )
        ax.annotate(
            text,
            (row["ns_high"], y),
            (6, 0),
            textcoords="offset points",
            va="center_baseline",
            fontsize=TEXT,
            color=colour(theme, row["family"], text=True),
            parse_math=False,
            annotation_clip=False,
        )


def _levels(ax: Axes, theme: Theme, rows: Sequence[Row]) -> None:
    """What was wrong up to some gamma."""
    ax.set(ylim=(-5, max(OCTAVES) + 1))
    ax.set_yticks([log2(metres / KILOMETRE) for metres in LENGTHS.values()], list(LENGTHS))
    ax.set_ylabel("wrong up to this gap\nin a scene of 1 km", fontsize=TEXT)
    atom, guide = log2(ATOM / KILOMETRE), theme.roles["guide"]
    ax.axhline(atom, color=guide, lw=0.8, ls=(0, (1, 2.2)))
    ax.annotate(
        "an atom",
        (1, atom),
        (0, 2),
        xycoords=ax.get_yaxis_transform(),
        textcoords="offset points",
        ha="right",
        va="bottom",
        color=guide,
        fontsize=TEXT,
    )
    labels = []
    for row in rows:
        y, shade = log2(row["gamma"]) if row["gamma"] else -4.0, colour(theme, row["family"])
        ax.plot([row["ns_low"], row["ns_high"]], [y, y], color=shade, lw=1)
        ax.plot([row["ns"]], [y], "o", color=shade, ms=6.5)
        labels.append((row["ns"], y, row["method"], colour(theme, row["family"], text=True)))
    label_points(ax, labels, theme)


def _reading(rows: Sequence[Row]) -> str:
    n = rows[0]
    text = f"{len(rows)} methods on {n['pairs']:,} pairs made hard in {len(KINDS)} ways (at least "
    text += f"{n['least_an_octave']:,} an octave of gamma) and {n['touching']:,} that touch exactly. "
    for row in sorted((r for r in rows if r["lane"] == ""), key=lambda r: -r["gamma"]):
        upto = f"wrong up to gamma {row['gamma']:.2g} ({_length(row['gamma'])} in a kilometre)"
        touch = f", and at {row['touching_wrong']:,} of the touches" if row["touching_wrong"] else ""
        text += f"{row['method']}: {upto}{touch}; {told(row['ns'])}. "
    for name in (LOOSE, NEVER, PROVED):
        mine = [f"{r['method']} ({told(r['ns'])})" for r in rows if r["lane"] == name]
        text += f"{name[0].upper()}{name[1:]}: {', '.join(mine)}. " if mine else ""
    return text.strip()


# -- the rates behind it -----------------------------------------------------------------------------

# the curves: how each is called, and where its name stands (octave, share)
SHOWN = {
    "AABB": ("AABB", 31, 0.66),
    "SAT, float32": ("SAT, float32", 29.2, 0.25),
    "SAT, 1e-9 counts as a hit": ("gaps of 1e-9 count as hits", 8.2, 0.68),
    "SAT, 1e-9 counts as a miss": ("overlaps of 1e-9 count as misses", 8.2, 0.3),
    "SAT, unit normals": ("SAT, unit normals", 1.4, 0.24),
    "SAT, raw normals": ("SAT, raw normals", 1.4, 0.15),
    "turns, floats": ("turns, floats", 1.4, 0.08),
    "satviz": ("satviz: none wrong", 8.2, 0.03),
}
DASHED = "SAT, 1e-9 counts as a miss", "SAT, raw normals"


def _rates(found: dict[str, Any]) -> Chart:
    """The share of wrong answers by octave of gamma, exact touching in a lane of its own."""
    touches = {_key(row): row for row in found["count-touching"]}
    made: list[Row] = []
    for name in SHOWN:
        key = (COMPILED, name)
        mine = [row for kind in KINDS for row in found[f"hard-{_slug(kind.name)}"] if _key(row) == key]
        if not mine:
            continue
        pairs, bad = (np.sum([row[k] for row in mine], axis=0).tolist() for k in ("pairs_by_octave", "wrong_by_octave"))
        facts = {"method": name, "family": mine[0]["family"]}
        made.append({**facts, "octave": "touching", "pairs": touches[key]["pairs"], "wrong": touches[key]["wrong"]})
        made += [{**facts, "octave": k, "pairs": p, "wrong": w} for k, p, w in zip(OCTAVES, pairs, bad, strict=True)]
    for row in made:
        row["share"] = row["wrong"] / max(row["pairs"], 1)
        row["low"], row["high"] = wilson(row["wrong"], row["pairs"])
    least = min(row["pairs"] for row in made[:-1])
    title = "Each method has a resolution: above it it is always right, below it it tosses a coin"

    def draw(fig: Figure, theme: Theme) -> None:
        under = f"share of wrong answers by hardness, {least:,} pairs or more an octave; bands: 95 % intervals"
        headline(fig, theme, title, under)
        touch = axes(fig, (0.07, 0.15, 0.06, 0.68), theme)
        ax = axes(fig, (0.4, 0.15, 0.585, 0.68), theme)
        ends = []
        for name, (words, x, y) in SHOWN.items():
            mine = [row for row in made if row["method"] == name]
            if not mine:
                continue
            shade, ink = colour(theme, mine[0]["family"]), colour(theme, mine[0]["family"], text=True)
            style = "--" if name in DASHED else "-"
            last = max((k for k, row in enumerate(mine) if k and row["wrong"]), default=0)
            curve = mine[1:] if name == "satviz" else mine[1 : last + 2]
            xs = [row["octave"] + 0.5 for row in curve]
            if name != "satviz":
                lows, highs = ([row[key] for row in curve] for key in ("low", "high"))
                ax.fill_between(xs, lows, highs, color=shade, alpha=0.15, lw=0)
            ax.plot(xs, [row["share"] for row in curve], color=shade, ls=style, lw=1.8)
            ax.text(x, y, words, color=ink, fontsize=TEXT, parse_math=False)
            touch.plot([0, 0], [mine[0]["low"], mine[0]["high"]], color=shade, lw=1)
            touch.plot([0], [mine[0]["share"]], "o", color=shade, ms=6, clip_on=False)
            ends.append((0, mine[0]["share"], words.split(":")[0], ink))
        for each in (touch, ax):
            each.set(ylim=(-0.03, 1.03))
            each.set_yticks([0, 0.25, 0.5, 0.75, 1], ["0", "25 %", "50 %", "75 %", "100 %"])
        ax.set_yticklabels([])
        touch.set(xlim=(-1, 1), xticks=[])
        touch.set_xlabel("touching exactly", labelpad=12)
        none = [text for _, share, text, _ in ends if not share]
        zeros = [f"0 {', '.join(none[i : i + 2])}" for i in range(0, len(none), 2)]
        ends = [(x, y, f"{y:.0%} {text}", ink) for x, y, text, ink in ends if y]
        label_ends(touch, [*ends, *((0, 0.0, words, theme.roles["guide"]) for words in zeros)], gap=15)
        ax.set(xlim=(-2.5, max(OCTAVES) + 1), xlabel="gamma: the turn that decides, in roundings")
        ax.set_xticks(range(0, 36, 5), [f"$2^{{{k}}}$" for k in range(0, 36, 5)])

    text = ""
    for name in SHOWN:
        mine = [row for row in made if row["method"] == name]
        if mine:
            last = [row["octave"] for row in mine[1:] if row["wrong"]]
            upto = f"wrong up to gamma 2^{max(last) + 1}" if last else "never wrong"
            text += f"{name}: {upto}, and at {mine[0]['wrong']:,} of {mine[0]['pairs']:,} touches. "
    return Chart("wrong-by-gamma", title, (860.0, 400.0), draw, made, text.strip())


# -- the kinds apart ---------------------------------------------------------------------------------

BREAKING = (
    "satviz", "turns, adaptive", "turns, floats", "GJK", "shapely", "satviz, no filter", "SAT, raw normals",
    "SAT, unit normals", "SAT, 1e-9 counts as a hit", "SAT, float32",
)  # fmt: skip


def _kinds(found: dict[str, Any]) -> Chart:
    """A row a kind and a column a method: the largest gamma at which it was wrong."""
    every = {
        (row["kind"], row["method"]): row
        for kind in EVERY
        for row in found[f"hard-{_slug(kind.name)}"]
        if row["language"] == COMPILED
    }
    names = [name for name in BREAKING if (EXTREME.name, name) in every]
    made = [
        {
            "kind": kind.name,
            "method": name,
            **{k: every[kind.name, name][k] for k in ("family", "gamma", "wrong", "pairs")},
        }
        for kind in EVERY
        for name in names
    ]
    plain = [
        row["gamma"]
        for row in made
        if row["family"] == "float SAT" and row["kind"] != EXTREME.name and "float32" not in row["method"]
    ]
    most = 2.0 ** int(np.ceil(log2(max(plain, default=1.0))))
    title = f"Whatever makes a pair hard, float64 SAT errs only below gamma {most:g}; extreme sizes apart"
    wide = 78.0
    size = 170 + wide * len(names), 132 + 30.0 * len(EVERY)

    def draw(fig: Figure, theme: Theme) -> None:
        headline(
            fig,
            theme,
            title,
            "the largest gamma at which an answer was wrong, by method and kind of hardness; darker is worse",
        )
        ax = axes(fig, (160 / size[0], 16 / size[1], wide * len(names) / size[0], 30.0 * len(EVERY) / size[1]), theme)

        def cell(y: int, x: int) -> tuple[str, str, float]:
            row = every[EVERY[y].name, names[x]]
            much = (log2(row["gamma"]) + 6) / 42 if row["gamma"] else 0.0
            return _up(row["gamma"]) if row["gamma"] else "none", colour(theme, row["family"]), max(0.0, min(1.0, much))

        labels = [name.replace(", ", ",\n").replace("counts as a", "\ncounts as a") for name in names]
        table(ax, theme, labels, [kind.name for kind in EVERY], cell)

    worst: list[str] = []
    for name in names:
        collapse = [row["gamma"] for row in made if row["method"] == name and row["kind"] != EXTREME.name]
        worst.append(f"{name} {max(collapse):.2g}" if max(collapse) else f"{name} none")
    extreme = [row["method"] for row in made if row["kind"] == EXTREME.name and not row["wrong"]]
    text = (
        f"The largest gamma found wrong over {len(KINDS)} kinds of hardness: {', '.join(worst)}. Extreme sizes (2^400 "
        "and more, either way) do not follow gamma: products of coordinates leave the range of floats there, so what "
        f"is lost is everything and not some roundings; never wrong there: {', '.join(extreme) or 'none'}. A fixed "
        "tolerance is no number of roundings either: far from the origin the same 1e-9 is a smaller gamma. All shapes "
        "are ones that float32 can hold: where its grid is coarser than a shape, no gamma can tell."
    )
    return Chart("kinds-of-hardness", title, size, draw, made, text)


def _up(gamma: float) -> str:
    """A power of two that is no smaller."""
    return f"$2^{{{int(np.ceil(log2(gamma)))}}}$"

"""Redraw the guides' charts from their stored rows, after the code that writes their texts has changed.

    python tests/refresh_charts.py [DIR]

DIR is where `satviz study --out` or `satviz bench --chart` has stored new rows, which are copied first: those of all
charts of a study into `satviz/study/stored_run.json`, those of a bench into `figures`.  Nothing is measured.  Titles
and readings are worked out again, and both SVGs are drawn.  Then the guides get the alternative texts of these charts,
and the sentences that have measured numbers.
"""

import json
import re
import sys
from pathlib import Path

from satviz.pictures import THEMES
from satviz.render.chart import Chart, theme_suffix
from satviz.study import bench_chart, frames_chart
from satviz.study.bench import TimingRow
from satviz.study.bench_table import spread_of
from satviz.study.harness.timings import Spread, format_ratio, interval_in_words, least_of, ratio_interval
from satviz.study.methods import ENGINES
from satviz.study.run import SECTIONS
from satviz.study.sections.pose_error import STEP_ANGLES
from satviz.study.sections.speed_against_accuracy import in_metres
from satviz.study.stored_run import STORED_RUN, stored_charts, stored_run
from satviz.study.workloads.adversary import LEAST_SIDE, MOST_ACROSS

ROOT = Path(__file__).parent.parent
FIGURES, GUIDES = ROOT / "figures", ROOT / "satviz" / "guides"
READ_ALOUD = {"frames": 2, "bench": 1}  # sentences of the reading in an alternative text, below 450 letters in all
BENCH_CHARTS = {"bench": bench_chart.bench_chart, "frames": frames_chart.frames_chart}
STUDY_STEMS = "speed-against-accuracy", "decision-table", "pose-error"  # shown in the guides


def load(path: Path) -> dict:
    return json.loads(path.read_text(encoding="utf-8"))


def bench_rows(*stems: str) -> list[TimingRow]:
    """Return the stored rows of these charts of the bench."""
    return [TimingRow(**row) for stem in stems for row in load(FIGURES / f"{stem}.json")["rows"]]


def charts() -> dict[str, Chart]:
    """Return each chart of the guides by its stem, made from the stored rows."""
    found = stored_charts()
    drawn = {stem: found[stem] for stem in STUDY_STEMS}
    for stem, draw in BENCH_CHARTS.items():
        drawn[stem] = draw(bench_rows(stem), load(FIGURES / f"{stem}.json")["rough"])
    return drawn


def store_study(folder: Path) -> None:
    """Store the rows of all charts of a study in one file, a row on a line."""
    stems = [stem for section in SECTIONS for stem in section.CHARTS]
    found = {stem: load(folder / f"{stem}.json") for stem in stems}
    facts = {key: found[stems[0]][key] for key in ("made_by", "settings", "machine")}
    assert all(data[key] == facts[key] for data in found.values() for key in facts)
    lines = [f' "{key}": {json.dumps(value)},' for key, value in facts.items()]
    rows = [f'  "{stem}": [\n   ' + ",\n   ".join(map(json.dumps, data["rows"])) + "\n  ]"
            for stem, data in found.items()]  # fmt: skip
    STORED_RUN.write_text("\n".join(["{", *lines, ' "rows": {', ",\n".join(rows), " }", "}", ""]), encoding="utf-8")


def alternative_text(chart: Chart) -> str:
    """Return the title of a chart; for a chart of the bench also the beginning of its reading."""
    return " ".join([f"{chart.title}.", *re.split(r"(?<=\.) ", chart.reading)[: READ_ALOUD.get(chart.stem, 0)]])


def measured_sentences() -> list[str]:
    """Return each part of a sentence in the guides that was measured, with its numbers in braces."""
    run, numpy, numba = stored_run(), *ENGINES
    of = {row["method"]: row for row in run["rows"]["speed-against-accuracy"]}
    exact, raw, unit = (of[name] for name in ("satviz", "SAT, raw normals", "SAT, unit normals"))
    answer, whole = (format_ratio(ratio_interval(exact[key], raw[key])) for key in ("ns_runs", "whole_runs"))
    of_others = prices_of_few_corners(run["rows"])
    found = [
        f"It has 4-gons whose sides are at least {{{in_metres(LEAST_SIDE)}}} and which are at most "
        f"{{{in_metres(MOST_ACROSS)}}} across. The gap",
        f"`satviz bench` measured medians of {{{min(of_others):.1f} to {max(of_others):.1f}}} times for the answers "
        "alone.",
        f"with steps of {{{STEP_ANGLES[0]} to {STEP_ANGLES[1]}}} radians, as in this chart",
        f"shapely was wrong about a gap of {{{in_metres(of['shapely']['metres'])}}}, where",
        f"wrong up to {{{in_metres(raw['metres'])}}} with raw normals, and up to {{{in_metres(unit['metres'])}}} with",
        f"and was wrong up to {{{in_metres(of['SAT, float32']['metres'])}}}. With",
        f"exact answers take {{{answer}}} as long",
        f"In brackets is {{{interval_in_words(len(raw['ns_runs']))}}}.",
        f"From bare arrays satviz takes {{{whole}}} as long",
        f"Its processor is: {{{run['machine']['processor']}}}, with SIMD registers of {{{run['machine']['SIMD']}}}.",
    ]
    times = {(r.section, r.work, r.size, r.method): r.time for r in bench_rows("bench")}
    start = "starts", "the first answer of a new process", 0
    pays = {work: (times[*start, numba] - times[*start, numpy])
            / (times["pairs", work, 0, numpy] - times["pairs", work, 0, numba])
            for work in ("triangles", "mixed, 3 to 8 corners")}  # fmt: skip
    found.append(
        f"with up to {{{pays['triangles']:.2g}}} million pairs of triangles, or "
        f"{{{pays['mixed, 3 to 8 corners']:.2g}}} million pairs of polygons with 3 to 8 corners"
    )
    ratios = {key: time / times[shapely] for key, time in times.items()
              if key[3] in ENGINES and (shapely := (*key[:3], "shapely")) in times}  # fmt: skip
    spreads = {(r.section, r.work, r.size, r.method): spread_of(r) for r in bench_rows("bench")}
    assert all(own.is_below(spreads[*key[:3], "shapely"]) for key, own in spreads.items() if key in ratios
               and key[3] == numba)  # fmt: skip
    _, _, corners, _ = most = max(ratios, key=ratios.__getitem__)
    found.append(f"it takes up to {{{ratios[most]:.1f}}} times as long, for polygons with {{{corners}}} corners.")
    frames = {(r.work, r.size, r.method): spread_of(r) for r in bench_rows("frames") if r.section == "frames"}
    trees = [(key, time) for key, time in frames.items() if key[2].endswith("STRtree")]
    assert all(frames[work, size, numba].is_below(time) for (work, size, _), time in trees)
    behind = [size for (work, size, _), time in trees if not frames[work, size, numpy].is_below(time)]
    found.append(f"The NumPy engine is faster than STRtree at all these sizes above {{{max(behind):,}}} shapes.")
    short = {key[:2] for key in frames if fastest(frames, key[:2]) <= set(frames_chart.SHORT_PROGRAMS)}
    few = min(size for work, size, _ in frames if (work, size) not in short)
    last = max(size for _, size, _ in frames if size < few)
    boxes = max(size for work, size, _ in frames if work == "boxes" and (work, size) not in short)
    again = min(size for work, size, _ in frames if work == "boxes" and size > boxes)
    return [*found, f"For up to {{{last:,}}} shapes, a short program that answers in floats is the fastest; for boxes "
            f"also from {{{again:,}}} on."]  # fmt: skip


def prices_of_few_corners(study: dict[str, list[dict]]) -> list[float]:
    """Return satviz's time with numba as a multiple of plain SAT's, where few of the pairs nearly touch.

    study: the stored rows by chart.  The pairs have 3 to 8 corners, and are others than those of the main chart.
    """
    price = {row["method"]: row for row in study["price-of-exactness"] if (row["what"], row["much"]) == ("touching", 0)}
    few = {(row["corners"], row["method"]): row for row in study["corners"] if row["corners"] <= 8}
    pairs = [(price["satviz"], price["SAT, raw normals"])]
    pairs += [(row, few[corners, "SAT, every corner"]) for (corners, name), row in few.items() if name == "satviz"]
    found = [ratio_interval(*(row["ns_runs"] for row in pair))[0] for pair in pairs]
    times = {(row.work, row.method): row.time for row in bench_rows("bench") if row.section == "pairs"}
    works = "triangles", "boxes", "8-gons"
    return found + [times[work, "satviz numba"] / times[work, "SAT in numba"] for work in works]


def fastest(frames: dict[tuple[str, int, str], Spread], scene: tuple[str, int]) -> set[str]:
    """Return the fastest methods for a scene (work, number of shapes), whose intervals overlap."""
    return set(least_of({key[2]: time for key, time in frames.items() if key[:2] == scene}))


def with_numbers(text: str, drawn: dict[str, Chart]) -> str:
    """Return a guide's text with the alternative texts of these charts and with the measured numbers."""
    for stem, chart in drawn.items():
        alt = re.compile(rf'(<img src="../../figures/{stem}\.svg"[^>]* alt=")[^"]*')
        text = alt.sub(lambda found, chart=chart: found[1] + alternative_text(chart), text)
    for sentence in measured_sentences():
        words = ".+?".join(map(re.escape, re.split(r"\{.*?\}", sentence)))
        text = re.sub(words, lambda _, sentence=sentence: re.sub("[{}]", "", sentence), text)
    return text


def main(folder: Path | None = None) -> None:
    if folder and (folder / f"{STUDY_STEMS[0]}.json").is_file():
        store_study(folder)
    for stem in BENCH_CHARTS:
        if folder and (folder / f"{stem}.json").is_file():
            (FIGURES / f"{stem}.json").write_bytes((folder / f"{stem}.json").read_bytes())
    drawn = charts()
    for path in GUIDES.glob("*.md"):
        path.write_text(with_numbers(path.read_text(encoding="utf-8"), drawn), encoding="utf-8")
    for stem, chart in drawn.items():
        if stem in BENCH_CHARTS:
            data = load(FIGURES / f"{stem}.json") | {"title": chart.title, "reading": chart.reading}
            (FIGURES / f"{stem}.json").write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")
        for theme in THEMES.values():
            (FIGURES / f"{stem}{theme_suffix(theme)}.svg").write_bytes(chart.encode("svg", theme))


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

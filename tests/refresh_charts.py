"""Redraw the guides' charts from their stored rows, after the code that writes their texts has changed.

    python tests/refresh_charts.py [DIR]

DIR is where `satviz study --out` or `satviz bench --chart` has stored new rows, which are copied first: those of all
charts of a study into `satviz/study/stored_run.json`, those of a bench into `figures`.  Nothing is measured.  Titles
and readings are worked out again, and both SVGs are drawn.  The alternative texts of the guides are the titles, and
what a reading begins with: a test says where they differ.
"""

import json
import sys
from pathlib import Path

from satviz.pictures import THEMES
from satviz.study import bench_chart, frames_chart
from satviz.study.bench import TimingRow
from satviz.study.harness.chart import Chart, theme_suffix
from satviz.study.run import SECTIONS
from satviz.study.stored_run import STORED_RUN, stored_charts

FIGURES = Path(__file__).parent.parent / "figures"
BENCH_CHARTS = {"bench": bench_chart.bench_chart, "frames": frames_chart.frames_chart}
STUDY_STEMS = "speed-against-accuracy", "decision-table", "pose-error"  # shown in the guides


def load(path: Path) -> dict:
    return json.loads(path.read_text(encoding="utf-8"))


def bench_rows(*stems: str) -> list[TimingRow]:
    """The stored rows of these charts of the bench."""
    return [TimingRow(**row) for stem in stems for row in load(FIGURES / f"{stem}.json")["rows"]]


def charts() -> dict[str, Chart]:
    """Each chart of the guides by its stem, from what is stored."""
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


def main(folder: Path | None = None) -> None:
    if folder and (folder / f"{STUDY_STEMS[0]}.json").is_file():
        store_study(folder)
    for stem in BENCH_CHARTS:
        if folder and (folder / f"{stem}.json").is_file():
            (FIGURES / f"{stem}.json").write_bytes((folder / f"{stem}.json").read_bytes())
    for stem, chart in charts().items():
        if stem in BENCH_CHARTS:
            data = load(FIGURES / f"{stem}.json") | {"title": chart.title, "reading": chart.reading}
            (FIGURES / f"{stem}.json").write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")
        for theme in THEMES.values():
            (FIGURES / f"{stem}{theme_suffix(theme)}.svg").write_bytes(chart.encode("svg", theme))


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

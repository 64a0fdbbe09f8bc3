"""Redraw the guides' charts from their stored rows, after the code that writes their texts has changed.

    python tests/refresh_charts.py [DIR]

DIR is where `satviz bench --chart` or `satviz study --out` has stored new rows, which are copied first.  Nothing is
measured.  Title and reading are worked out again, and both SVGs are drawn.  The README's alternative texts
are the titles, and what a reading begins with: a test says where they differ.
"""

import json
import sys
from pathlib import Path
from shutil import copyfile

from satviz.pictures import THEMES
from satviz.study import bench_chart, frames_chart
from satviz.study.bench import TimingRow
from satviz.study.harness.cells import Settings
from satviz.study.harness.chart import Chart, theme_suffix
from satviz.study.sections import decision_table, pose_error, speed_against_accuracy

FIGURES = Path(__file__).parent.parent / "figures"
STEMS = "speed-against-accuracy", "decision-table", "pose-error", "bench", "frames"


def stored(stem: str) -> dict:
    """What was measured, and the texts that were made from it."""
    return json.loads((FIGURES / f"{stem}.json").read_text(encoding="utf-8"))


def charts() -> dict[str, Chart]:
    """Each chart of the README by its stem, from what is stored."""
    speed, table, pose, bench, frames = map(stored, STEMS)
    settings = Settings(**speed["settings"])
    return {
        "speed-against-accuracy": speed_against_accuracy.main_chart(speed["rows"], settings),
        "decision-table": decision_table.table_chart(table["rows"], table["rough"]),
        "pose-error": pose_error.charts({"pose": pose["rows"]}, settings)[0],
        "bench": bench_chart.bench_chart([TimingRow(**row) for row in bench["rows"]], bench["rough"]),
        "frames": frames_chart.frames_chart([TimingRow(**row) for row in frames["rows"]], frames["rough"]),
    }


SPEED, BENCH, IN_README = stored("speed-against-accuracy"), stored("bench"), charts()


def main(folder: Path | None = None) -> None:
    for stem in IN_README:
        if folder and (folder / f"{stem}.json").is_file():
            copyfile(folder / f"{stem}.json", FIGURES / f"{stem}.json")
    for stem, chart in charts().items():
        data = stored(stem) | {"title": chart.title, "reading": chart.reading}
        (FIGURES / f"{stem}.json").write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")
        for theme in THEMES.values():
            (FIGURES / f"{stem}{theme_suffix(theme)}.svg").write_bytes(chart.encode("svg", theme))


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

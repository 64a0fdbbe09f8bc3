"""Redraw the README's charts from their stored rows, after the code that writes their texts has changed.

    python tests/refresh_charts.py

Nothing is measured.  Title and reading are worked out again, and both SVGs are drawn.  The README's alternative texts
are the titles, and what a reading begins with: a test says where they differ.
"""

import json
from pathlib import Path

from satviz.pictures import THEMES
from satviz.study import bench_chart
from satviz.study.bench import TimingRow
from satviz.study.harness.cells import Settings
from satviz.study.harness.chart import Chart, theme_suffix
from satviz.study.sections import speed_against_accuracy

FIGURES = Path(__file__).parent.parent / "figures"


def stored(stem: str) -> dict:
    """What was measured, and the texts that were made from it."""
    return json.loads((FIGURES / f"{stem}.json").read_text(encoding="utf-8"))


SPEED, BENCH = stored("speed-against-accuracy"), stored("bench")
IN_README: dict[str, Chart] = {
    "speed-against-accuracy": speed_against_accuracy.main_chart(SPEED["rows"], Settings(**SPEED["settings"])),
    "bench": bench_chart.bench_chart([TimingRow(**row) for row in BENCH["rows"]], BENCH["rough"]),
}


def main() -> None:
    for stem, chart in IN_README.items():
        data = stored(stem) | {"title": chart.title, "reading": chart.reading}
        (FIGURES / f"{stem}.json").write_text(json.dumps(data, indent=1) + "\n", encoding="utf-8")
        for theme in THEMES.values():
            (FIGURES / f"{stem}{theme_suffix(theme)}.svg").write_bytes(chart.encode("svg", theme))


if __name__ == "__main__":
    main()

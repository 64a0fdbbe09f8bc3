"""The full run of the study that is stored with the package: the rows of its charts, and where they were measured."""

import json
from pathlib import Path
from typing import Any

from ..render.chart import Chart
from .harness.cells import Settings
from .run import charts_of

STORED_RUN = Path(__file__).with_name("stored_run.json")


def stored_run() -> dict[str, Any]:
    """Return the stored run: its `settings`, the `machine`, and the `rows` of every chart by its stem."""
    found: dict[str, Any] = json.loads(STORED_RUN.read_text(encoding="utf-8"))
    return found


def stored_charts() -> dict[str, Chart]:
    """Return the charts of the stored run by their stems, drawn from nothing but its rows."""
    run = stored_run()
    return {chart.stem: chart for chart in charts_of(run["rows"], Settings(**run["settings"]))}

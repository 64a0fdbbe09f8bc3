"""satviz study: every section's cells, then its charts and their readings, into one folder."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from types import ModuleType
from typing import Any

from ..render.files import MADE_BY, check, write
from . import accuracy, continuity, cost, doing_less, failures, moving, stability
from .cells import Settings, results
from .chart import Chart, save
from .machine import machine

SECTIONS: tuple[ModuleType, ...] = (accuracy, stability, continuity, moving, failures, cost, doing_less)
KEPT = "cells"  # the folder of finished cells, inside the study's own


def study(
    settings: Settings,
    out: Path,
    *,
    sections: Sequence[ModuleType] | None = None,
    executor: Executor | None = None,
    progress: Callable[[int, int, str], None] = lambda done, total, name: None,
    force: bool = False,
) -> list[Path]:
    """Do what is not done yet, then write the charts, their numbers and study.md; returns the files written.

    Finished cells stay in `out`/cells, so an interrupted study goes on where it was.
    `executor` takes the cells that do not measure time.  `progress(done, total, name)`
    is told of each finished cell.  FileExistsError for a chart's file that satviz did
    not make, unless `force`.
    """
    sections = SECTIONS if sections is None else sections
    check(out / "study.md", force=force)
    cells = [cell for section in sections for cell in section.cells(settings)]
    found: dict[str, Any] = {}
    for cell, result in results(cells, out / KEPT, executor):
        found[cell.name] = result
        progress(len(found), len(cells), cell.name)
    facts = {"settings": settings._asdict(), "machine": machine()}
    written = []
    made = charts(found, sections)
    for chart in made:
        written += save(chart, out, facts, ("svg",) if settings.quick else ("svg", "png"), force=force)
    write(out / "study.md", _words(made, settings).encode(), force=force)
    return [*written, out / "study.md"]


def charts(found: dict[str, Any], sections: Sequence[ModuleType]) -> list[Chart]:
    """Every chart of the sections from the cells' results by name."""
    return [chart for section in sections for chart in section.charts(found)]


def _words(made: Sequence[Chart], settings: Settings) -> str:
    """The charts with their readings, as one page of Markdown."""
    versions = ", ".join(f"{name} {version}" for name, version in machine().items())
    lines = ["# The study", "", f"{MADE_BY}: {'quick run' if settings.quick else 'full run'}, seed {settings.seed}."]
    lines += [f"Measured with {versions}.", ""]
    for chart in made:
        lines += [f"## {chart.title}", "", f"![{chart.title}]({chart.stem}.svg)", "", chart.reading, ""]
        lines += [f"Numbers: [{chart.stem}.csv]({chart.stem}.csv), [{chart.stem}.json]({chart.stem}.json)", ""]
    return "\n".join(lines)


@contextmanager
def executor(kind: str | None) -> Iterator[Executor | None]:
    """None, "threads", "processes", or the cluster whose scheduler has that address (extra `cluster`)."""
    if kind is None:
        yield None
    elif kind in ("threads", "processes"):
        with (ThreadPoolExecutor if kind == "threads" else ProcessPoolExecutor)() as pool:
            yield pool
    else:
        try:
            from distributed import Client
        except ImportError:
            raise ValueError(f'a cluster ({kind}) needs the extra: python -m pip install "satviz[cluster]"') from None
        try:
            client = Client(kind, timeout=10)
        except (OSError, ValueError) as error:
            raise ValueError(f"no dask scheduler at {kind!r} ({error}); or choose threads or processes") from None
        with client, client.get_executor() as pool:
            yield pool

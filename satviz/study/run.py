"""satviz study: every section's cells, then its charts and their readings, into one folder."""

from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from signal import SIG_DFL, SIGINT, signal
from types import ModuleType
from typing import Any

from ..batch.chunks import check_executor
from ..optional_imports import extra_needed
from ..safe_write import MADE_BY, check, folder, write
from .harness.cells import Failure, Settings, results
from .harness.chart import Chart, save
from .harness.machine import machine
from .sections import changes, corners, maps, order, price, resolution, resting, reuse

SECTIONS: tuple[ModuleType, ...] = (resolution, price, reuse, corners, changes, resting, order, maps)
KEPT = "cells"  # the folder of finished cells, inside the study's own
MOST_NAMED = 5  # of the failed cells


class CellsFailed(RuntimeError):
    """Some cells failed, so their sections have no charts; all else was written."""


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
    is told of each finished cell.  FileExistsError for a file that satviz did not make,
    unless `force`; CellsFailed at the end, if any did.
    """
    check_executor(executor)
    sections = SECTIONS if sections is None else sections
    folder(out)
    check(out / "study.md", force=force)
    cells = [cell for section in sections for cell in section.cells(settings)]
    found: dict[str, Any] = {}
    failed: dict[str, Failure] = {}
    for cell, result in results(cells, out / KEPT, executor, force=force):
        (failed if isinstance(result, Failure) else found)[cell.name] = result
        progress(len(found) + len(failed), len(cells), cell.name)
    facts = {"settings": settings._asdict(), "machine": machine()}
    written: list[Path] = []
    whole = [section for section in sections if not any(cell.name in failed for cell in section.cells(settings))]
    made = charts(found, whole, settings)
    for chart in made:
        written += save(chart, out, facts, ("svg",) if settings.quick else ("svg", "png"), force=force)
    write(out / "study.md", _words(made, failed, settings).encode(), force=force)
    if failed:
        raise CellsFailed(f"{_count(failed)}, so charts are missing in {out}: {_named(failed)}")
    return [*written, out / "study.md"]


def _count(failed: dict[str, Failure]) -> str:
    return "1 cell failed" if len(failed) == 1 else f"{len(failed)} cells failed"


def _named(failed: dict[str, Failure]) -> str:
    """The first of them with their errors."""
    names = [f"{name} ({failure.why})" for name, failure in list(failed.items())[:MOST_NAMED]]
    return ", ".join(names) + (f" and {len(failed) - MOST_NAMED} more" if len(failed) > MOST_NAMED else "")


def charts(found: dict[str, Any], sections: Sequence[ModuleType], settings: Settings) -> list[Chart]:
    """Every chart of the sections from the cells' results by name."""
    return [chart for section in sections for chart in section.charts(found, settings)]


def _words(made: Sequence[Chart], failed: dict[str, Failure], settings: Settings) -> str:
    """The charts with their readings, as one page of Markdown."""
    versions = ", ".join(f"{name} {version}" for name, version in machine().items())
    lines = ["# The study", "", f"{MADE_BY}: {'quick run' if settings.quick else 'full run'}, seed {settings.seed}."]
    lines += [f"Measured with {versions}.", ""]
    lines += [f"{_count(failed)}, so charts are missing: {_named(failed)}.", ""] if failed else []
    for chart in made:
        stamp = f" ({chart.rough})" if chart.rough else ""
        lines += [f"## {chart.title}", "", f"![{chart.title}]({chart.stem}.svg)", "", f"{chart.reading}{stamp}", ""]
        lines += [f"Numbers: [{chart.stem}.csv]({chart.stem}.csv), [{chart.stem}.json]({chart.stem}.json)", ""]
    return "\n".join(lines)


@contextmanager
def executor(kind: str | None) -> Iterator[Executor | None]:
    """None, "threads", "processes", or the cluster whose scheduler has that address (extra `cluster`)."""
    if kind is None:
        yield None
    elif kind == "threads":
        with ThreadPoolExecutor() as pool:
            yield pool
    elif kind == "processes":
        # Ctrl-C reaches the workers too: they just end, and this process says what there is to say
        with ProcessPoolExecutor(initializer=signal, initargs=(SIGINT, SIG_DFL)) as pool:
            yield pool
    else:
        try:
            from distributed import Client
        except ImportError:
            raise ValueError(extra_needed(f"a cluster ({kind})", "cluster")) from None
        try:
            client: Any = Client(kind, timeout=10)  # type: ignore[no-untyped-call]
        except (OSError, ValueError) as error:
            raise ValueError(f"no dask scheduler at {kind!r} ({error}); or choose threads or processes") from None
        with client, client.get_executor() as pool:
            yield pool

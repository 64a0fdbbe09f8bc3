"""satviz study: run the cells of every section, then write the charts and their readings into one folder."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor, ProcessPoolExecutor, ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from signal import SIG_DFL, SIGINT, signal
from types import ModuleType
from typing import Any

from ..batch.chunks import check_executor
from ..optional_imports import extra_needed
from ..render.chart import Chart, JsonRow, save_chart
from ..safe_write import MADE_BY, check, make_folder, write
from .harness.cells import Failure, Settings, run_cells
from .harness.machine import machine_facts
from .sections import (
    axis_order,
    corner_count,
    decision_table,
    exactness_cost,
    margin_strips,
    mtv_by_method,
    pose_error,
    resting_stack,
    speed_against_accuracy,
)

SECTIONS: tuple[ModuleType, ...] = (
    speed_against_accuracy,
    decision_table,
    exactness_cost,
    margin_strips,
    pose_error,
    mtv_by_method,
    resting_stack,
    corner_count,
    axis_order,
)
CELLS_FOLDER = "cells"  # the folder of the finished cells, inside the folder of the study
MAX_NAMED_FAILURES = 5  # failed cells that an error line names


class CellsFailed(RuntimeError):
    """Raised when some cells failed: their sections have no charts, and everything else was written."""


def study(
    settings: Settings,
    out: Path,
    *,
    sections: Sequence[ModuleType] | None = None,
    executor: Executor | None = None,
    progress: Callable[[int, int, str], None] = lambda done, total, name: None,
    force: bool = False,
) -> list[Path]:
    """Run the cells that are not finished, write the charts, their numbers and study.md, and return the files written.

    Finished cells stay in `out`/cells, so an interrupted study continues where it stopped.  `executor` runs the cells
    that do not measure time.  `progress(done, total, name)` is called after each finished cell.  Raise FileExistsError
    for a file that satviz did not make, unless `force`, and CellsFailed at the end if a cell failed.
    """
    check_executor(executor)
    sections = SECTIONS if sections is None else sections
    make_folder(out)
    check(out / "study.md", force=force)
    cells = [cell for section in sections for cell in section.cells(settings)]
    found: dict[str, Any] = {}
    failed: dict[str, Failure] = {}
    for cell, result in run_cells(cells, out / CELLS_FOLDER, executor, force=force):
        (failed if isinstance(result, Failure) else found)[cell.name] = result
        progress(len(found) + len(failed), len(cells), cell.name)
    facts = {"settings": settings._asdict(), "machine": machine_facts()}
    written: list[Path] = []
    whole = [section for section in sections if not any(cell.name in failed for cell in section.cells(settings))]
    made = charts_of(all_rows(found, whole), settings, whole)
    for chart in made:
        written += save_chart(chart, out, facts, ("svg",) if settings.quick else ("svg", "png"), force=force)
    write(out / "study.md", _study_page(made, failed, settings).encode(), force=force)
    if failed:
        raise CellsFailed(
            f"{_failed_count(failed)}, so charts are missing in {out}: {_failed_names(failed)}. "
            "Run the command again: finished cells are kept"
        )
    return [*written, out / "study.md"]


def _failed_count(failed: dict[str, Failure]) -> str:
    """Return "1 cell failed" or "N cells failed"."""
    return "1 cell failed" if len(failed) == 1 else f"{len(failed)} cells failed"


def _failed_names(failed: dict[str, Failure]) -> str:
    """Return the names of the first failed cells with their errors."""
    names = [f"{name} ({failure.why})" for name, failure in list(failed.items())[:MAX_NAMED_FAILURES]]
    return ", ".join(names) + (
        f" and {len(failed) - MAX_NAMED_FAILURES} more" if len(failed) > MAX_NAMED_FAILURES else ""
    )


def all_rows(found: dict[str, Any], sections: Sequence[ModuleType]) -> dict[str, list[JsonRow]]:
    """Return the rows of every chart by its stem; `found`: results by cell name, with all cells of these sections."""
    return {stem: rows for section in sections for stem, rows in section.rows(found).items()}


def charts_of(
    rows: Mapping[str, Sequence[JsonRow]], settings: Settings, sections: Sequence[ModuleType] = SECTIONS
) -> list[Chart]:
    """Return the charts of the sections that have rows, drawn from nothing but these."""
    return [draw(rows[stem], settings) for section in sections for stem, draw in section.CHARTS.items()
            if rows.get(stem)]  # fmt: skip


def _study_page(made: Sequence[Chart], failed: dict[str, Failure], settings: Settings) -> str:
    """Return the page study.md: every chart with its reading, as Markdown."""
    versions = ", ".join(f"{name} {version}" for name, version in machine_facts().items())
    lines = ["# The study", "", f"{MADE_BY}: {'quick run' if settings.quick else 'full run'}, seed {settings.seed}."]
    lines += [f"Measured with {versions}.", ""]
    lines += [f"{_failed_count(failed)}, so charts are missing: {_failed_names(failed)}.", ""] if failed else []
    for chart in made:
        stamp = f" ({chart.warning})" if chart.warning else ""
        lines += [f"## {chart.title}", "", f"![{chart.title}]({chart.stem}.svg)", "", f"{chart.reading}{stamp}", ""]
        lines += [f"Numbers: [{chart.stem}.csv]({chart.stem}.csv), [{chart.stem}.json]({chart.stem}.json)", ""]
    return "\n".join(lines)


@contextmanager
def open_executor(kind: str | None) -> Iterator[Executor | None]:
    """Yield the executor of that kind, or None, and close it at the end.

    `kind`: None for no executor, "threads", "processes", or the address of a dask scheduler (extra `cluster`).
    Raise ValueError where there is no scheduler at the address, or dask is not installed.
    """
    if kind is None:
        yield None
    elif kind == "threads":
        with ThreadPoolExecutor() as pool:
            yield pool
    elif kind == "processes":
        # Ctrl-C reaches the workers too: they end silently, and this process prints the message
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
            raise ValueError(
                f"no dask scheduler at {kind!r} ({error}): check the address, or choose threads or processes"
            ) from None
        with client, client.get_executor() as pool:
            yield pool

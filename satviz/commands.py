"""What each command does: a thin call of the public face."""

import argparse
import os
import sys
import warnings
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

from . import safe_write
from .optional_imports import needs
from .terminal import interrupts_ignored, out, out_json, say, stop_if_interrupted, visible

if TYPE_CHECKING:
    from .engine.trace import Trace
    from .pictures import Picture
    from .scenes.scenefile import Scene

    Job = tuple[str, str, Callable[[], Picture | list[Picture] | bytes]]  # stem, form, what makes it

Row = TypeVar("Row")


MOST_STEPS = 120  # that `draw` makes a file each of without being asked


class Refused(Exception):
    """Bad input: one clear line and exit code 2."""


class Failed(Exception):
    """The work itself failed: one clear line and exit code 1."""


def _load(args: argparse.Namespace) -> "Scene":
    """The scene by name or file, with the options of the command line."""
    from dataclasses import replace

    from .scenes.named import names, scene
    from .scenes.scenefile import load

    is_file = any(c in args.scene for c in "./\\") or os.path.exists(args.scene)
    known = names()
    if args.scene not in known and not is_file:
        raise Refused(f"no scene {args.scene!r}{_did_you_mean(args.scene, known)}, or give a file")
    found = scene(args.scene) if args.scene in known else load(args.scene)
    return replace(found, axes=args.axes or found.axes, every_axis=args.every_axis or found.every_axis)


def _did_you_mean(name: str, known: Iterable[str]) -> str:
    from difflib import get_close_matches

    near = get_close_matches(name, known, n=1)
    return f": did you mean {near[0]}?" if near else f": choose one of {', '.join(known)}"


def figures(args: argparse.Namespace) -> int:
    """Write the figures asked for, in one theme."""
    from .pictures.figures import FIGURES, Figure

    wanted: Sequence[Figure] = FIGURES
    if args.only:
        known = {key: f for f in FIGURES for key in (f.name, f.stem, str(f.number), f"{f.number:02}")}
        for name in args.only:
            if name not in known:
                raise Refused(f"no figure {name!r}{_did_you_mean(name, known)}")
        wanted = [figure for figure in FIGURES if figure in [known[name] for name in args.only]]
    jobs = [(figure.stem, form, figure.picture) for figure in wanted for form in dict.fromkeys(args.format)]
    return _write(args, jobs)


def draw(args: argparse.Namespace) -> int:
    """Draw every step of a scene, or of a long run its contact sheet, in each format asked for; print its link."""
    from .pictures import Picture, picture, steps
    from .pictures.caption import captioned
    from .pictures.comparison import refused_picture
    from .pictures.sheet import sheet
    from .scenes.named import refused_case

    formats = [form for form in dict.fromkeys(args.format) if form != "link"]
    if "link" in args.format:
        _link(args)
    if not formats:
        return 0
    if case := refused_case(args.scene):
        if args.axes or args.every_axis or args.sheet or args.steps:
            raise Refused(
                f"{case.name} has no run, since its outlines are refused: leave out --axes, --every-axis, "
                "--sheet and --steps"
            )
        drawn, name = refused_picture(case), case.name
        makes: dict[str, Callable[[], Picture | list[Picture] | bytes]]
        makes = {"gif": lambda: [drawn], "html": lambda: _page(name, "")}
        return _write(args, [(name, form, makes.get(form, lambda: drawn)) for form in formats])
    scene = _load(args)
    trace = scene.record()
    try:
        picture(trace, 0)
    except ValueError as error:
        raise Refused(str(error)) from None
    count = len(steps(trace))
    jobs: list[Job] = []

    def finished(step: int) -> Picture:
        drawn = picture(trace, step, title=scene.title)
        return captioned([drawn])[0] if args.caption else drawn

    for form in formats:
        if form == "gif":
            jobs.append((scene.name, form, lambda: captioned([picture(trace, i) for i in range(count)])))
            continue
        if form == "html":
            jobs.append((scene.name, form, lambda: _page(trace, scene.title)))
            continue
        if args.sheet or (count > MOST_STEPS and not args.steps):
            jobs.append((f"{scene.name}-sheet", form, lambda: sheet(trace, title=scene.title)))
            continue
        for i in range(count):
            stem = f"{scene.name}-{i:0{len(str(count - 1))}}"
            jobs.append((stem, form, partial(finished, i)))
    done = _write(args, jobs)
    if count > MOST_STEPS and not (args.steps or args.sheet) and any("-sheet" in stem for stem, *_ in jobs):
        out(f"one sheet instead of a picture of each of the {count} steps (--steps makes those)")
    return done


def _link(args: argparse.Namespace) -> None:
    """Print the link that opens the scene on a site."""
    from .scenes.link import link

    out(link(_load(args), site=args.site or ""))


def _page(what: "Trace | str", title: str) -> bytes:
    from .render.page import page

    try:
        return page(what, title=title).encode()
    except ValueError as error:
        raise Refused(str(error)) from None


def notebook(args: argparse.Namespace) -> int:
    """Copy the walkthrough beside the reader, not yet run, and open it."""
    from importlib.util import find_spec

    from .site.shipped import shipped_notebooks

    sources = shipped_notebooks()
    safe_write.folder(args.out)
    for source in sources:
        copy, data = args.out / source.name, _not_yet_run(source.read_bytes())
        if os.path.lexists(copy) and not _holds(copy, data) and not args.force:
            say(f"{copy} was changed and is left alone (overwrite it with --force)")
        else:
            safe_write.write(copy, data, force=True)
        stop_if_interrupted()
    out(f"{len(sources)} notebooks in {visible(str(args.out))}")
    if args.no_open:
        return 0
    if not find_spec("jupyterlab") or not find_spec("anywidget"):
        raise Refused(needs("opening the walkthrough", "jupyter"))
    return _jupyterlab(args.out)


def _not_yet_run(data: bytes) -> bytes:
    """A notebook without its outputs.

    JupyterLab trusts none that it did not make: a picture would be its text, and each answer stands below its question.
    """
    import json

    notebook = json.loads(data)
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            cell["outputs"], cell["execution_count"] = [], None
    return (json.dumps(notebook, indent=1, ensure_ascii=False) + "\n").encode()


def _holds(path: Path, data: bytes) -> bool:
    return path.is_file() and not path.is_symlink() and path.read_bytes() == data


def _jupyterlab(folder: Path) -> int:
    """Run it until it ends; an interrupt is its own matter, as it asks whether to stop."""
    import subprocess

    with (
        subprocess.Popen([sys.executable, "-m", "jupyterlab", str(folder.absolute())]) as process,
        interrupts_ignored(),
    ):
        return process.wait()


def _write(args: argparse.Namespace, jobs: Sequence["Job"]) -> int:
    """Draw and write each job (stem, form, picture maker); the dark theme's files say so in their names."""
    from .pictures import THEMES as LOOKS
    from .pictures import Picture
    from .render.files import animate, encode

    theme = LOOKS[args.theme]
    suffix = "" if theme.name == "light" else f"-{theme.name}"
    # a page has both themes
    paths = [args.out / f"{stem}{suffix if form != 'html' else ''}.{form}" for stem, form, _ in jobs]
    safe_write.folder(args.out)
    for path in paths:
        safe_write.check(path, force=args.force)
    with warnings.catch_warnings(record=True) as said:
        for path, (stem, form, make) in zip(_progress(paths), jobs, strict=True):
            made = make()
            if isinstance(made, Picture):
                made = encode(made, form, theme, stem=stem + suffix)
            data = made if isinstance(made, bytes) else animate(made, theme)
            safe_write.write(path, data, force=args.force)
    for line in dict.fromkeys(str(warning.message) for warning in said):
        say(line)
    out(f"{len(paths)} {'file' if len(paths) == 1 else 'files'} in {visible(str(args.out))}")
    return 0


def _progress(paths: Sequence[Path]) -> Iterator[Path]:
    """A bar on stderr, none where that is no terminal."""
    from tqdm import tqdm

    with tqdm(paths, unit="file", disable=None, leave=False, file=sys.stderr) as bar:
        for path in bar:
            bar.set_postfix_str(path.name)
            yield path
            stop_if_interrupted()


def trace(args: argparse.Namespace) -> int:
    """Print the record of a scene, as a table or as JSON."""
    from shutil import get_terminal_size

    from .engine import describe

    trace = _load(args).record()
    width = get_terminal_size().columns if sys.stdout.isatty() else None
    out_json(trace.to_json(indent=1)) if args.json else out(describe.table(trace, width))
    return 0


def advise(args: argparse.Namespace) -> int:
    """Say which model is the least that is right for a scene or for many shapes, and draw what each costs."""
    import json

    from .advice.advising import advise
    from .advice.report import price

    if Path(args.scene).suffix == ".npz":
        from .advice.shapesfile import load

        shapes, pairs = load(Path(args.scene))
        try:
            advice = advise(shapes, pairs=pairs)
        except (ValueError, IndexError) as error:
            raise Refused(f"{args.scene}: {error}") from None
    else:
        scene = _load(args)
        advice = advise(scene.a, scene.b)
    if args.json:
        prices = {name: p and p._asdict() for name, p in advice.prices().items()} if args.chart else None
        data = json.loads(advice.to_json())
        out_json(json.dumps(data | {"prices": prices} if prices else data, indent=1, allow_nan=False))
    else:
        out("\n".join(filter(None, (str(advice), price(advice.model, advice.facts, advice.prices())))))
    if args.chart:
        try:
            drawn = advice.chart()
        except ValueError as error:
            raise Refused(str(error)) from None
        safe_write.folder(args.chart)
        for theme in ("light", "dark"):
            for form in ("svg", "png"):
                path = args.chart / f"advice{'' if theme == 'light' else '-dark'}.{form}"
                safe_write.write(path, drawn.encode(form, theme), force=args.force)
                say(f"wrote {path}")
    return 0


def bench(args: argparse.Namespace) -> int:
    """Time satviz beside its peers; print the table, and draw the chart if asked."""
    import json

    from tqdm import tqdm

    from .study.bench import bench, busy, planned, table, when_numba_pays
    from .study.harness.machine import machine, missing

    pairs, rounds = (2000, 3) if args.quick else (args.pairs, args.rounds)
    rows = []
    for row in tqdm(bench(planned(pairs, rounds, args.seed)), unit="row", disable=None, leave=False, file=sys.stderr):
        rows.append(row)
        stop_if_interrupted()
    warning = "quick figures are rough: a table for keeps takes minutes" if args.quick else busy(rows)
    if args.json:
        facts = {"machine": machine(), "missing": missing(), "pairs": pairs, "rounds": rounds, "warning": warning}
        out_json(json.dumps({**facts, "rows": [row._asdict() for row in rows]}, indent=1))
    else:
        out(table(rows))
        if "numba" not in missing():
            out(when_numba_pays(rows))
        if missing():
            out(f"not installed, so left out: {', '.join(missing())}")
        out(", ".join(f"{name} {what}" for name, what in machine().items()))
    if warning:
        say(warning)
    if args.chart:
        from .study.bench_chart import chart
        from .study.harness.chart import save

        for path in save(chart(rows, warning), args.chart, {"machine": machine()}, ("svg", "png"), force=args.force):
            say(f"wrote {path}")
    return 0


def study(args: argparse.Namespace) -> int:
    """Run the sections asked for, and write their tables and charts."""
    from tqdm import tqdm

    from .study.harness.cells import Settings
    from .study.run import CellsFailed, executor, study

    with ExitStack() as stack:
        try:
            pool = stack.enter_context(executor(args.executor))
        except ValueError as error:
            raise Refused(str(error)) from None
        bar = stack.enter_context(tqdm(unit="cell", disable=None, leave=False, file=sys.stderr))

        def progress(done: int, total: int, name: str) -> None:
            bar.total = total
            bar.set_postfix_str(name, refresh=False)
            bar.update(done - bar.n)
            stop_if_interrupted()

        try:
            files = study(Settings(args.quick, args.seed), args.out, executor=pool, progress=progress, force=args.force)
        except CellsFailed as error:
            raise Failed(str(error)) from None
    out(f"{len(files)} files in {visible(str(args.out))}: begin with {visible(str(files[-1]))}")
    return 0


def reference(args: argparse.Namespace) -> int:
    """Write the pages of the reference."""
    from .site.reference import reference

    try:
        files = [(args.out / path, data) for path, data in reference()]
    except ImportError as error:
        raise Failed(str(error)) from None
    safe_write.folder(args.out)
    for path, _ in files:
        safe_write.check(path, force=args.force)
    for path, data in files:
        safe_write.write(path, data, force=args.force)
    out(f"open {visible(str(args.out / 'index.html'))}")
    return 0


def site(args: argparse.Namespace) -> int:
    """Write the site, and serve it if asked."""
    from .site.build import PythonMissing, site

    try:
        files, lacks = site(pyodide=args.pyodide, live=not args.still)
        made = {args.out / path: data for path, data in files}
    except ImportError as error:
        raise Failed(str(error)) from None
    except PythonMissing as error:
        raise Refused(str(error)) from None
    safe_write.folder(args.out)
    for path in made:
        safe_write.check(path, force=args.force)
    for path, data in made.items():
        safe_write.write(path, data, force=args.force)
        stop_if_interrupted()
    for line in lacks:
        say(line)
    sent = sum(map(len, made.values())) / 1e6
    out(f"{len(made)} files ({sent:.1f} MB) in {visible(str(args.out))}")
    return _serve(args.out) if args.open else 0


def _serve(folder: Path) -> int:
    """Serve the folder until Ctrl-C."""
    import webbrowser

    from .site.serving import server

    with server(folder) as serving:
        address = f"http://127.0.0.1:{serving.server_address[1]}/"
        out(f"serving {address} until Ctrl-C")
        webbrowser.open(address)
        serving.serve_forever()
    return 0


def scenes(args: argparse.Namespace) -> int:
    """List the built-in scenes, or those where shortcuts fail."""
    if args.failing:
        from .scenes.failing import FAILURE_CASES

        out("\n".join(map(str, FAILURE_CASES)))
        return 0
    from .scenes.article import SCENES

    width = max(len(scene.name) for scene in SCENES)
    for scene in SCENES:
        out(f"{scene.name:{width}}  {scene.title}")
    return 0

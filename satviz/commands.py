"""The commands, as calls of the public functions.

A command takes the options of its command line, prints its result and returns the exit code.
"""

import argparse
import os
import sys
import warnings
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import ExitStack
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from . import safe_write
from .optional_imports import extra_needed
from .terminal import interrupts_ignored, out, out_json, say, stop_if_interrupted, visible

if TYPE_CHECKING:
    from .pictures import Picture
    from .pictures.moves import Animation
    from .scenes.resolve import Resolved
    from .scenes.scenefile import Scene

    Pictures = Callable[[], Sequence[Picture]]  # draws the pictures of a file when they are needed
    File = tuple[str, str, Callable[[], Sequence[Picture] | Animation | str]]  # stem, format, what makes its content

MAX_STEP_FILES = 120  # a longer run is drawn as one sheet unless --steps asks for a file of each step
MAX_STEM = 80  # letters of a handout's file name
ExitCode = int  # 0 done, 1 failed, 2 bad input


class Refused(Exception):
    """The input is bad: `main` prints its message in one line and returns exit code 2."""


class Failed(Exception):
    """The work itself failed: `main` prints its message in one line and returns exit code 1."""


def _resolve(name: str, axes: str | None = None, every_axis: bool = False) -> "Resolved":
    """Return what a built-in name, a file's path or a link stands for; Refused for an unknown name.

    `axes`, `every_axis`: replace those of a scene if given.
    """
    from dataclasses import replace

    from .scenes.link import parse_fragment
    from .scenes.named import did_you_mean, names
    from .scenes.resolve import Resolved, resolve
    from .scenes.scenefile import Scene, load

    given: Scene | str = name
    if name.startswith(("http://", "https://")):
        given = parse_fragment(name.partition("#")[2])[0]
    elif name not in (known := names()):
        if not any(c in name for c in "./\\") and not os.path.exists(name):
            raise Refused(f"there is no scene and no file {name!r}{did_you_mean(name, known)}")
        given = load(name)
    found = resolve(given)
    if not isinstance(scene := found.given, Scene):
        return found
    return Resolved(replace(scene, axes=axes or scene.axes, every_axis=every_axis or scene.every_axis))


def figures(args: argparse.Namespace) -> ExitCode:
    """Write the figures that --only selects, or all, in one theme."""
    from .pictures.figures import FIGURES, STRIP, Figure
    from .scenes.named import did_you_mean

    wanted: Sequence[Figure] = FIGURES
    if args.only:
        known = {key: f for f in (*FIGURES, STRIP) for key in (f.name, f.stem, str(f.number), f"{f.number:02}")}
        for name in args.only:
            if name not in known:
                raise Refused(f"there is no figure {name!r}{did_you_mean(name, [f.name for f in (*FIGURES, STRIP)])}")
        wanted = [figure for figure in (*FIGURES, STRIP) if figure in [known[name] for name in args.only]]
    forms = dict.fromkeys(args.format)

    def draw(figure: Figure) -> "list[Picture]":
        """Return a list of the figure's one picture."""
        return [figure.picture()]

    return _write(args, [(f.stem, form, partial(draw, f)) for f in wanted for form in forms])


class _Drawable(NamedTuple):
    """What `draw` makes files of: still pictures, the frames of an animation, and a page."""

    name: str  # the stem of the animation's and the page's file
    stills: "Sequence[tuple[str, Pictures]]"  # the stem of each file, and its one picture
    frames: "Callable[[], Animation]"
    page: Callable[[], str]
    note: str = ""  # printed where still pictures were written


def draw(args: argparse.Namespace) -> ExitCode:
    """Draw steps of a scene, or of a long run its contact sheet, in each format; print its link and its iframe."""
    from .render.formats import FORMATS, STILL_FORMATS

    found = _resolve(args.scene, args.axes, args.every_axis)
    _print_link_and_frame(args, found)
    forms = [form for form in dict.fromkeys(args.format) if form not in ("link", "embed")]
    if not forms:
        return 0
    drawable = _drawable_refused(args, found) if found.refused else _drawable_run(args, found)
    files: list[File] = []
    for form in forms:
        if form == "html":
            files.append((drawable.name, form, partial(_page, drawable)))
        elif FORMATS[form].animated:
            files.append((drawable.name, form, drawable.frames))
        else:
            files += [(stem, form, make) for stem, make in drawable.stills]
    done = _write(args, files)
    if drawable.note and set(forms) & set(STILL_FORMATS):
        out(drawable.note)
    return done


def _print_link_and_frame(args: argparse.Namespace, found: "Resolved") -> None:
    """Print the link of a scene and the HTML of an iframe with it, each if its format is asked for."""
    from .pictures.stages import step_range
    from .render.embed import embed
    from .scenes.link import link
    from .widgets.goals import evaluate_goal

    if not {"link", "embed"} & set(args.format):
        return
    if args.goal:
        evaluate_goal(args.goal, found.scene)  # refuses a goal that the scene cannot have
    asked = step_range(found.trace, args.step) if args.step else None
    first, last = asked or (None, None)
    if "link" in args.format:
        _print_link(args, link(found, site=args.site or "", step=first, predict=args.predict, goal=args.goal))
    if "embed" in args.format:
        part = asked if first != last else None
        frame = embed(
            found, site=args.site, play=args.play or first is not None, predict=args.predict, challenge=args.goal,
            steps=part, theme=args.theme, show=args.show, step=None if part else first,
        )  # fmt: skip
        out(frame.rstrip("\n"))


def _print_link(args: argparse.Namespace, address: str) -> None:
    """Print a link; say what to do with it where it is not a whole address."""
    out(address)
    if not args.site:
        say("this address is relative to a site: add the site with --site URL, or serve one with satviz site --open")


def _drawable_refused(args: argparse.Namespace, found: "Resolved") -> _Drawable:
    """Return the drawing of a scene whose outlines are refused; Refused for options that need a run."""
    from .pictures import picture
    from .pictures.moves import animation
    from .render.page import page

    options = "axes", "every_axis", "sheet", "step", "steps", "sweep", "difference", "predict"
    if any(getattr(args, name) for name in options):
        raise Refused(
            f"{args.scene} has no run, since its outlines are refused: leave out --axes, --every-axis, "
            "--sheet, --step, --steps, --sweep, --difference and --predict"
        )
    drawn = picture(found)
    return _Drawable(
        args.scene,
        [(args.scene, lambda: [drawn])],
        lambda: animation([drawn], speed=args.speed or 1.0),
        lambda: page(found),
    )


def _drawable_run(args: argparse.Namespace, found: "Resolved") -> _Drawable:
    """Return a run's drawings, as --sheet, --steps and --caption ask for; Refused if it cannot be drawn."""
    from .pictures import picture
    from .pictures.caption import add_captions
    from .pictures.difference_steps import difference_steps
    from .pictures.moves import animation, turning
    from .pictures.sheet import sheet
    from .pictures.stages import step_range, steps_of
    from .pictures.turning_axis import sweep
    from .render.page import page

    scene, trace = found.scene, found.trace
    try:
        picture(trace, 0)
    except ValueError as error:
        raise Refused(str(error)) from None
    first, last = step_range(trace, args.step)
    count = len(steps_of(trace))
    captioned: Callable[[Sequence[Picture]], Sequence[Picture]] = add_captions if args.caption else list

    def still(step: int) -> "Sequence[Picture]":
        """Return a list of the picture of one step, captioned with its sentence under --caption.

        Several steps have one frame; a step that is drawn alone is cut to what it shows.
        """
        alone = args.step is not None and first == last
        return captioned([picture(trace, step, title=scene.title, by_itself=alone)])

    every: Sequence[Picture] = ()
    if args.sweep or args.difference:
        every = (sweep if args.sweep else difference_steps)(trace, title=scene.title)

    def frames() -> "Animation":
        """Return the animation of the run, of the axis that turns or of how B - A is made; sentences are below."""
        if args.sweep:
            return turning(add_captions(every), speed=args.speed or 1.0)
        drawn = every or [picture(trace, s) for s in range(first, last + 1)]
        return animation(add_captions(drawn, brief=True), speed=args.speed or 1.0)

    whole_page = partial(
        page, trace, title=scene.title, predict=args.predict, sweep=args.sweep, difference=args.difference,
        speed=args.speed or 1.0,
    )  # fmt: skip

    if every:
        name = f"{scene.name}-{'sweep' if args.sweep else 'difference'}"
        digits = len(str(len(every) - 1))
        own = [(f"{name}-{n:0{digits}}", partial(captioned, [drawn])) for n, drawn in enumerate(every)]
        return _Drawable(name, own, frames, whole_page)

    if not args.sheet and (last - first < MAX_STEP_FILES or args.steps):
        digits = len(str(count - 1))
        stills = [(f"{scene.name}-{step:0{digits}}", partial(still, step)) for step in range(first, last + 1)]
        return _Drawable(scene.name, stills, frames, whole_page)
    whole = [(f"{scene.name}-sheet", lambda: [sheet(trace, title=scene.title)])]
    note = "" if args.sheet else f"one sheet instead of a picture of each of the {count} steps (--steps makes those)"
    return _Drawable(scene.name, whole, frames, whole_page, note)


def _page(drawable: _Drawable) -> str:
    """Return the HTML page; Refused where the run has too many steps for a page."""
    try:
        return drawable.page()
    except ValueError as error:
        raise Refused(str(error)) from None


def _write(args: argparse.Namespace, files: "Sequence[File]") -> ExitCode:
    """Make and write each file once all are known to be writable; print warnings; return exit code 0.

    `files`: (stem, format, function that makes the content) of each.  The names of dark files end in -dark; a page
    has both themes.
    """
    from .pictures import THEMES
    from .pictures.moves import Animation
    from .render.chart import theme_suffix
    from .render.files import encode_frames

    theme = THEMES[args.theme or "light"]
    suffix = theme_suffix(theme)
    paths: list[Path] = [args.out / f"{stem}{'' if form == 'html' else suffix}.{form}" for stem, form, _ in files]
    safe_write.make_folder(args.out)
    for path in paths:
        safe_write.check(path, force=args.force)
    with warnings.catch_warnings(record=True) as caught:
        for path, (_, form, make) in zip(_progress(paths), files, strict=True):
            made = make()
            if isinstance(made, str):
                data = made.encode()
            else:
                pictures, times = made if isinstance(made, Animation) else (made, None)
                data = encode_frames(pictures, form, theme, stem=path.stem, times=times)
            safe_write.write(path, data, force=args.force)
    for line in dict.fromkeys(str(warning.message) for warning in caught):
        say(line)
    out(f"{len(paths)} {'file' if len(paths) == 1 else 'files'} in {visible(str(args.out))}")
    return 0


def _progress(paths: Sequence[Path]) -> Iterator[Path]:
    """Yield the paths beside a bar on standard error, where that is a terminal; stop at an interrupt."""
    from tqdm import tqdm

    with tqdm(paths, unit="file", disable=None, leave=False, file=sys.stderr) as bar:
        for path in bar:
            bar.set_postfix_str(path.name)
            yield path
            stop_if_interrupted()


def handout(args: argparse.Namespace) -> ExitCode:
    """Write the questions of chapters and scenes as one HTML file to print, and their solutions as another."""
    from .lessons.chapter_text import chapters
    from .lessons.handout import chapter_named, handout

    given: list[Scene | str] = []
    for name in args.what:
        chapter = chapter_named(name)
        if not chapter and name.isdecimal() and not os.path.exists(name):
            raise Refused(f"there is no chapter {name}: the chapters are 1 to {len(chapters())}")
        given.append(chapter.title.split()[0] if chapter else _resolve(name).scene)
    try:
        texts = [handout(*given, paper=args.paper, solutions=solutions) for solutions in (False, True)]
    except ImportError as error:
        raise Failed(str(error)) from None
    stem = "-".join(["handout", *(each if isinstance(each, str) else each.name for each in given)])[:MAX_STEM]
    files = {f"{stem}.html": texts[0].encode(), f"{stem}-solutions.html": texts[1].encode()}
    _write_all(args, files)
    for path in files:
        out(visible(str(args.out / path)))
    return 0


def notebook(args: argparse.Namespace) -> ExitCode:
    """Copy the walkthrough's notebooks, without outputs, to a folder, and open them in JupyterLab."""
    from importlib.util import find_spec

    from .lessons.shipped import shipped_notebooks

    sources = shipped_notebooks()
    safe_write.make_folder(args.out)
    for source in sources:
        copy, data = args.out / source.name, _not_yet_run(source.read_bytes())
        same = copy.is_file() and not copy.is_symlink() and copy.read_bytes() == data
        if os.path.lexists(copy) and not same and not args.force:
            say(f"{copy} was changed and is left alone (overwrite it with --force)")
        else:
            safe_write.write(copy, data, force=True)
        stop_if_interrupted()
    out(f"{len(sources)} notebooks in {visible(str(args.out))}")
    if args.no_open:
        return 0
    if not find_spec("jupyterlab") or not find_spec("anywidget"):
        raise Refused(extra_needed("opening the walkthrough", "jupyter"))
    return _jupyterlab(args.out)


def _not_yet_run(data: bytes) -> bytes:
    """Return the file of a notebook without its outputs.

    JupyterLab trusts no output that it did not make: it would show a picture as text.  Besides, an output would
    answer the question above it at once.
    """
    import json

    notebook = json.loads(data)
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            cell["outputs"], cell["execution_count"] = [], None
    return (json.dumps(notebook, indent=1, ensure_ascii=False) + "\n").encode()


def _jupyterlab(folder: Path) -> ExitCode:
    """Run JupyterLab until it ends, and return its exit code.

    Ctrl-C is left to JupyterLab, which asks whether to stop.
    """
    import subprocess

    with (
        subprocess.Popen([sys.executable, "-m", "jupyterlab", str(folder.absolute())]) as process,
        interrupts_ignored(),
    ):
        return process.wait()


def trace(args: argparse.Namespace) -> ExitCode:
    """Print the trace of a scene, as a table or as JSON."""
    from shutil import get_terminal_size

    trace = _resolve(args.scene, args.axes, args.every_axis).trace
    width = get_terminal_size().columns if sys.stdout.isatty() else None
    out_json(trace.to_json(indent=1)) if args.json else out(trace.table(width=width, sums=args.sums))
    return 0


def explain(args: argparse.Namespace) -> ExitCode:
    """Print the shapes in a text with their relations, or one pair in another form; exit code 2 without an answer."""
    from .scenes.minimal_test import LANGUAGES
    from .scenes.paste.pasted import paste

    found = paste(_text_of(args.file), args.as_)
    number = args.pair - 1
    if args.to in (None, "json", "wkt"):
        said = found.report(sentence=bool(found.traces))  # without an answer the sentence is the error line
        out_json(found.to_json()) if args.to == "json" else out(found.wkt if args.to == "wkt" else said)
    elif number >= len(found.pairs):
        raise Refused(f"there is no pair {args.pair}: {found.sentence}")
    elif args.to == "link":
        _print_link(args, found.link(number, site=args.site))
    elif args.to in LANGUAGES:
        out(found.test(args.to, number))
    elif args.to == "scene":
        out_json(found.scene(number).to_json())
    else:
        from .pictures import picture
        from .render.files import encode

        out(encode(picture(found.pairs[number].trace, -1), "svg", stem="pasted").decode())
    if not found.traces:
        say(found.sentence)
        return 2
    return 0


def _text_of(name: str) -> str:
    """Return the text of a file, of a scene by its name or link, or of standard input for "-"; Refused for no text."""
    from .scenes.named import names
    from .scenes.paste.tokens import MAX_CHARS

    if name.startswith(("http://", "https://")) or (name in names() and not os.path.exists(name)):
        return _resolve(name).scene.to_json()
    limit = 4 * MAX_CHARS + 1  # the bytes of a text that is not too long
    if name == "-":
        raw = sys.stdin.buffer.read(limit)
    else:
        with open(name, "rb") as file:
            raw = file.read(limit)
    try:
        return raw.decode("utf-16" if raw[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig")
    except UnicodeDecodeError:
        raise Refused(f"{'standard input' if name == '-' else name} is not UTF-8 text: save it as UTF-8") from None


def advise(args: argparse.Namespace) -> ExitCode:
    """Print the simplest model that is right for a scene or for many shapes; with --chart draw each model's cost."""
    import json

    from .advice.advising import advise
    from .advice.report import cost_line

    if Path(args.scene).suffix == ".npz":
        from .advice.shapesfile import load_shapes

        shapes, pairs = load_shapes(Path(args.scene))
        try:
            recommendation = advise(shapes, pairs=pairs)
        except (ValueError, IndexError) as error:
            raise Refused(f"{args.scene}: {error}") from None
    else:
        recommendation = advise(*_resolve(args.scene).shapes)
    if args.json:
        costs = {name: c and c._asdict() for name, c in recommendation.costs().items()} if args.chart else None
        data = json.loads(recommendation.to_json())
        out_json(json.dumps(data | {"costs": costs} if costs else data, indent=1, allow_nan=False))
    else:
        cost = cost_line(recommendation.model, recommendation.summary, recommendation.costs())
        out("\n".join(filter(None, (str(recommendation), cost))))
    if args.chart:
        try:
            chart = recommendation.chart()
        except ValueError as error:
            raise Refused(str(error)) from None
        from .pictures import THEMES
        from .render.chart import theme_suffix

        safe_write.make_folder(args.chart)
        for theme in THEMES.values():
            for form in ("svg", "png"):
                path = args.chart / f"advice{theme_suffix(theme)}.{form}"
                safe_write.write(path, chart.encode(form, theme), force=args.force)
                say(f"wrote {path}")
    return 0


def bench(args: argparse.Namespace) -> ExitCode:
    """Time satviz beside its peers and print the table; with --chart draw the charts."""
    import json

    from tqdm import tqdm

    from .study.bench import bench, plan_bench
    from .study.bench_table import bench_table, busy_warning, numba_break_even
    from .study.harness.machine import machine_facts, missing_peers

    if args.chart:
        safe_write.make_folder(args.chart)  # before minutes of work
    pairs, rounds = (2000, 3) if args.quick else (args.pairs, args.rounds)
    rows = []
    for row in tqdm(
        bench(plan_bench(pairs, rounds, args.seed)), unit="row", disable=None, leave=False, file=sys.stderr
    ):
        rows.append(row)
        stop_if_interrupted()
    warning = "quick figures are rough: leave out --quick for better ones" if args.quick else busy_warning(rows)
    if args.json:
        data = {"machine": machine_facts(), "missing": missing_peers(), "pairs": pairs, "rounds": rounds}
        out_json(json.dumps(data | {"warning": warning, "rows": [row._asdict() for row in rows]}, indent=1))
    else:
        out(bench_table(rows))
        if "numba" not in missing_peers():
            out(numba_break_even(rows))
        if missing_peers():
            out(f"not installed, so left out: {', '.join(missing_peers())}")
        out(", ".join(f"{name} {what}" for name, what in machine_facts().items()))
    if warning:
        say(warning)
    if args.chart:
        from .render.chart import save_chart
        from .study.bench import FRAME_SECTIONS
        from .study.bench_chart import bench_chart
        from .study.frames_chart import frames_chart

        of_frames = [row for row in rows if row.section in FRAME_SECTIONS]
        others = [row for row in rows if row.section not in FRAME_SECTIONS]
        facts = {"machine": machine_facts()}
        for chart in frames_chart(of_frames, warning), bench_chart(others, warning):
            for path in save_chart(chart, args.chart, facts, ("svg", "png"), force=args.force):
                say(f"wrote {path}")
    return 0


def study(args: argparse.Namespace) -> ExitCode:
    """Run the study's cells that are not finished, and write its charts and tables into --out."""
    from tqdm import tqdm

    from .study.harness.cells import Settings
    from .study.run import CellsFailed, open_executor, study

    with ExitStack() as stack:
        try:
            pool = stack.enter_context(open_executor(args.executor))
        except ValueError as error:
            raise Refused(str(error)) from None
        bar = stack.enter_context(tqdm(unit="cell", disable=None, leave=False, file=sys.stderr))

        def progress(done: int, total: int, name: str) -> None:
            """Show in the bar how many cells are done and the latest cell's name; stop at an interrupt."""
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


def reference(args: argparse.Namespace) -> ExitCode:
    """Write the HTML pages of the API reference into --out."""
    from .site.reference import reference

    try:
        files = dict(reference())
    except ImportError as error:
        raise Failed(str(error)) from None
    _write_all(args, files)
    out(f"open {visible(str(args.out / 'index.html'))}")
    return 0


def site(args: argparse.Namespace) -> ExitCode:
    """Write the site; with --open serve it, with --zip write it as one file."""
    from .site.build import PythonMissing, site

    try:
        pages, lacks = site(pyodide=args.pyodide, live=not args.still, url=args.url)
        files = dict(pages)
    except ImportError as error:
        raise Failed(str(error)) from None
    except PythonMissing as error:
        raise Refused(str(error)) from None
    if args.zip:
        return _write_archive(args, files, lacks)
    _write_all(args, files)
    for line in lacks:
        say(line)
    megabytes = sum(map(len, files.values())) / 1e6
    out(f"{len(files)} files ({megabytes:.1f} MB) in {visible(str(args.out))}")
    return _serve(args.out) if args.open else 0


def _write_archive(args: argparse.Namespace, files: Mapping[str, bytes], lacks: Sequence[str]) -> ExitCode:
    """Write the site as one zip beside the folder that it would have, print what it `lacks`; return exit code 0."""
    from .lessons.chapter_text import chapters
    from .site.hosting import archive

    path = args.out.with_name(f"{args.out.name}.zip")
    safe_write.check(path, force=args.force)
    data = archive(files, chapters())
    safe_write.write(path, data, force=args.force)
    for line in lacks:
        say(line)
    out(f"{visible(str(path))} ({len(data) / 1e6:.1f} MB, {len(files)} files)")
    return 0


def _write_all(args: argparse.Namespace, files: Mapping[str, bytes]) -> None:
    """Write files, given as path in --out -> bytes, after checking that all of them can be written."""
    safe_write.make_folder(args.out)
    for path in files:
        safe_write.check(args.out / path, force=args.force)
    for path, data in files.items():
        safe_write.write(args.out / path, data, force=args.force)
        stop_if_interrupted()


def _serve(folder: Path) -> ExitCode:
    """Serve the folder on this machine and open it in a browser, until Ctrl-C."""
    import webbrowser

    from .site.serving import server

    with server(folder) as serving:
        address = f"http://127.0.0.1:{serving.server_address[1]}/"
        out(f"serving {address} until Ctrl-C")
        webbrowser.open(address)
        serving.serve_forever()
    return 0


def scenes(args: argparse.Namespace) -> ExitCode:
    """Print the built-in scenes, or with --failing those where shortcuts fail."""
    if args.json:
        from .scenes.minimal_test import scenes_json

        out_json(scenes_json())
        return 0
    if args.failing:
        from .scenes.failing import FAILURE_CASES

        out("\n".join(map(str, FAILURE_CASES)))
        return 0
    from .scenes.article import SCENES

    width = max(len(scene.name) for scene in SCENES)
    for scene in SCENES:
        out(f"{scene.name:{width}}  {scene.title}")
    return 0


def check(args: argparse.Namespace) -> ExitCode:
    """Check a function or a program and print the report; with --out draw the counterexample; return 1 if wrong."""
    import json

    from .checking.asking import Asker, CalledInProcess, form_named
    from .checking.checker import check_asker
    from .checking.mistakes import SYMPTOMS, mistakes_with
    from .checking.options import Options
    from .checking.programs import START_SECONDS, Program, function_of
    from .scenes.failing import NAMED

    if args.symptom:
        found = mistakes_with(args.symptom)
        if not found:
            raise Refused(f"no known symptom is like {args.symptom!r}: choose one of {'; '.join(SYMPTOMS)}")
        out("\n".join(str(NAMED[name]) for name in found))
        return 0
    try:
        wanted = Options(
            returns=args.returns, kinds=args.kinds or Options.kinds, touching=args.touching, tolerance=args.tolerance,
            whole_numbers=args.whole_numbers, clockwise=not args.counter_clockwise,
            seed=args.seed, seconds=args.seconds,
        )  # fmt: skip
        asker: Asker
        if args.command:
            asker = Program(args.command, args.call_seconds)
        else:
            asker = CalledInProcess(function_of(args.target), form_named(args.form), args.call_seconds, START_SECONDS)
    except ValueError as error:
        raise Refused(str(error)) from None
    checked = check_asker(asker, wanted)
    out_json(json.dumps(checked.data(), indent=1, ensure_ascii=False)) if args.json else out(str(checked))
    if args.out and checked.counterexample:
        drawn = checked.picture()
        _write(args, [("counterexample", form, lambda: [drawn]) for form in ("svg", "png")])
    return 0 if checked.right else 1

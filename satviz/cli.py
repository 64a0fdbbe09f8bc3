"""The command line: its commands, their options and exit codes."""

import argparse
import reprlib
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any, NoReturn

from . import __version__, commands
from .checking.answers import EXPECTED as RETURNED
from .checking.answers import TOUCHING_AS
from .checking.forms import FORMS
from .checking.pairs import KINDS as PAIR_KINDS
from .commands import Failed, Refused
from .engine.geometry import InvalidScene
from .render.formats import FORMATS, STILL_FORMATS
from .scenes.embedding import VIEW_PARTS
from .scenes.link import GOALS
from .scenes.minimal_test import LANGUAGES
from .scenes.paste.boxes import ALL_CHOICES
from .terminal import interrupted, open_streams, out, remembering_interrupts, say

MAX_SPEED = 20.0

THEMES = ("light", "dark")
PAPERS = ("A4", "letter")
EXPLAIN_FORMS = ("json", "scene", "wkt", "link", "svg", *LANGUAGES)
DRAW_FORMATS = (*FORMATS, "html", "link", "embed")  # a page of the run; its link and a frame with it are printed
PRINTED_FORMATS = {"link", "embed"}


def _whole_number(least: int, most: int) -> Callable[[str], int]:
    """Return a parser of whole numbers from `least` to `most`."""

    def number(text: str) -> int:
        """Return the number in the text; ArgumentTypeError if it is not a whole number in range."""
        try:
            value = int(text)
        except ValueError:
            value = None
        if value is None or not least <= value <= most:
            raise argparse.ArgumentTypeError(f"{reprlib.repr(text)} is not a whole number from {least} to {most}")
        return value

    return number


SEED = _whole_number(0, 2**63 - 1)


def _folder(text: str) -> Path:
    """Return the path of a folder; ArgumentTypeError for an empty text, which Path takes for this folder."""
    if not text:
        raise argparse.ArgumentTypeError("the folder's name is empty: write . for the current folder")
    return Path(text)


class Parser(argparse.ArgumentParser):
    """A parser that reports a fault in one line, as every command does."""

    def error(self, message: str) -> NoReturn:
        """Print a usage fault in one line, with where to read on, and exit with 2."""
        say(f"{message} (try {self.prog} --help)")
        raise SystemExit(2)

    def _print_message(self, message: str, file: object = None) -> None:
        """Print help and version by `terminal.out`, which reports a stream that cannot be written."""
        out(message.rstrip("\n"))  # the help and the version, which argparse would lose where they cannot be written


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command and return its exit code: 0 done, 1 failed, 2 bad input, 130 interrupted."""
    open_streams()
    with remembering_interrupts(to_the_end=argv is None):
        try:
            args = _parser().parse_args(argv)
            if clash := args.clash(args):
                raise Refused(clash)
            vars(args).update({name: value for name, value in args.usual.items() if getattr(args, name) is None})
            code: int = args.run(args)
        except BaseException as error:
            # whatever an interrupt was turned into on its way
            code = 130 if interrupted() or isinstance(error, KeyboardInterrupt) else _report_failure(error)
        if code == 130 or interrupted():
            say("interrupted; the files named above are complete")
            return 130
    return code


def _report_failure(error: BaseException) -> int:
    """Print an error in one line and return its exit code; 0 where the reader of a pipe has gone.

    SystemExit and, under `python -X dev`, a fault of satviz are raised again.
    """
    if isinstance(error, BrokenPipeError):
        return 0  # the reader has gone: nothing left to say
    if isinstance(error, (Refused, InvalidScene)):
        say(str(error))
        return 2
    if isinstance(error, OSError):
        say(f"{error.filename}: {error.strerror}" if error.filename else str(error))
        return 2
    if isinstance(error, Failed):
        say(str(error))
    elif isinstance(error, MemoryError):
        say("not enough memory: give fewer or smaller inputs")
    elif isinstance(error, Exception) and not sys.flags.dev_mode:
        say(f"{type(error).__name__}: {error} (an internal error; run python -X dev -m satviz ... to see where)")
    else:
        raise error
    return 1


def _parser() -> argparse.ArgumentParser:
    """Return the parser of all commands."""
    parser = Parser(prog="satviz", description="2D collision detection by the Separating Axis Theorem, made visible.")
    parser.add_argument("--version", action="version", version=f"satviz {__version__}")
    # clash: says which options cannot be given together; usual: what holds where an option was not given
    parser.set_defaults(clash=lambda args: None, usual={})
    command = parser.add_subparsers(required=True, metavar="COMMAND")

    figures = command.add_parser("figures", help="make the article's twenty figures")
    _add_output_options(figures, "figures", STILL_FORMATS)
    figures.add_argument(
        "--only",
        metavar="NAME",
        action="append",
        help="only this figure, by name or number; may be repeated (sat-strip: figures 6 to 14 in one)",
    )
    figures.set_defaults(run=commands.figures)

    trace = command.add_parser("trace", help="print every test of a scene as a table")
    _add_scene_options(trace)
    trace.add_argument("--json", action="store_true", help="print the whole trace as JSON")
    trace.add_argument("--sums", action="store_true", help="print also how the ends of the ranges are computed")
    trace.set_defaults(
        run=commands.trace,
        clash=lambda args: "--sums adds to the table: leave out --json" if args.sums and args.json else None,
    )

    explain = command.add_parser(
        "explain",
        help="read shapes from any text, and say whether they touch or overlap, and why",
        epilog="The text may be WKT, GeoJSON, JSON, or lines in Python, JavaScript, C, C++, C#, Java, Rust, Scala or "
        "GDScript. No code is run. If the text can be read in two ways, both are listed with their results.",
    )
    explain.add_argument(
        "file", metavar="FILE", help="a file with the text, a scene's name or link, or - for standard input"
    )
    explain.add_argument(
        "--as",
        dest="as_",
        action="append",
        default=[],
        metavar="READING",
        help=f"the reading to take where several are possible: {', '.join(ALL_CHOICES)}; may be given several times",
    )
    explain.add_argument(
        "--to", choices=EXPLAIN_FORMS, help="print only this, to send it on (default: the explanation)"
    )
    explain.add_argument(
        "--pair", type=_whole_number(1, 10_000), default=1, metavar="N", help="the pair for --to (default: 1)"
    )
    explain.add_argument("--site", default="", metavar="URL", help="the address of the site for --to link")
    wrong_site = "--site is the address of a link: give it with --to link"
    explain.set_defaults(
        run=commands.explain, clash=lambda args: wrong_site if args.site and args.to != "link" else None
    )

    draw = command.add_parser("draw", help="draw every step of a scene")
    _add_scene_options(draw)
    _add_output_options(draw, "satviz-out", DRAW_FORMATS)
    draw.add_argument(
        "--caption",
        action="store_true",
        help="put each sentence under its picture (a page and a sheet always have it; a GIF has a few words instead)",
    )
    draw.add_argument("--site", metavar="URL", help="the address of the site for --format link and embed")
    which = draw.add_mutually_exclusive_group()
    which.add_argument(
        "--sweep", action="store_true", help="draw an axis that turns through 180 degrees, instead of the steps"
    )
    which.add_argument("--difference", action="store_true", help="draw how B - A is made, instead of the steps")
    which.add_argument("--sheet", action="store_true", help="draw the whole run in one picture, a row for each axis")
    which.add_argument(
        "--steps",
        action="store_true",
        help=f"draw every step; without it, a run of more than {commands.MAX_STEP_FILES} steps gets a sheet",
    )
    which.add_argument(
        "--step",
        type=_step_range,
        metavar="N[-M]",
        help="draw only this step, or the steps from N to M; the first is 0, and the word last means the last one",
    )
    draw.add_argument("--predict", action="store_true", help="ask the reader for each result (page, link, frame)")
    draw.add_argument("--goal", choices=GOALS, help="set this challenge (link, frame)")
    draw.add_argument("--play", action="store_true", help="step through the run (frame)")
    draw.add_argument("--show", action="append", choices=VIEW_PARTS, help="show this part too (frame); may be repeated")
    draw.add_argument(
        "--speed",
        type=_speed,
        metavar="TIMES",
        help="the speed of a GIF or a page: 2 is twice as fast, 0.25 leaves time to read (default: 1)",
    )
    usual = {"out": Path("satviz-out"), "format": ["svg"], "show": []}  # a frame is not light where nothing is said
    draw.set_defaults(run=commands.draw, clash=_clash_of_draw, usual=usual)

    advise = command.add_parser(
        "advise",
        help="find the simplest model that is right for a scene, with its proof and its cost",
        epilog="A file of many shapes is an .npz with coords (M, 2) and offsets (N + 1), polygons one after another, "
        "or centers (K, 2) and radii (K), circles numbered after the polygons, or both. An array pairs (P, 2) selects "
        "pairs; without it, all pairs whose boxes meet are tested.",
    )
    advise.add_argument("scene", metavar="SCENE", help="a built-in scene's name, a scene file, or an .npz of shapes")
    advise.add_argument("--json", action="store_true", help="print the result as JSON; with --chart it has the costs")
    advise.add_argument(
        "--chart", type=_folder, metavar="DIR", help="draw time against wrong answers, into this folder"
    )
    advise.add_argument("--force", action="store_true", help="overwrite files that satviz did not make")
    advise.set_defaults(run=commands.advise, axes=None, every_axis=False, clash=_clash_of_chart)

    check = command.add_parser(
        "check",
        help="find the smallest scene where your own function is wrong",
        epilog='A program reads one pair a line, {"a": [[x, y], ...], "b": [[x, y], ...]}, and writes one answer '
        'a line: true or false, "apart", "touching" or "overlapping", a depth, a move [x, y], null, or '
        "[true, [x, y]].  It must flush each line.",
    )
    check.add_argument("target", nargs="?", metavar="FILE.py[:function]", help="a function of two shapes")
    check.add_argument("--command", metavar="COMMAND", help='a program in any language, such as "node mine.js"')
    check.add_argument(
        "--symptom", metavar="WORDS", help='list the known mistakes that look like this: "falls through"'
    )
    check.add_argument("--returns", choices=RETURNED, help="what it returns (default: found from its first answers)")
    check.add_argument(
        "--kinds", action="append", choices=PAIR_KINDS, help="pairs to test; may be repeated (default: boxes, convex)"
    )
    check.add_argument("--form", choices=FORMS, default="points", help="how a function gets shapes (default: points)")
    check.add_argument("--touching", choices=TOUCHING_AS, default="hit", help="the right answer for touching shapes")
    check.add_argument("--tolerance", type=float, default=0.0, metavar="X", help="skip gaps and overlaps up to X")
    check.add_argument("--whole-numbers", action="store_true", help="test only pairs in whole numbers")
    check.add_argument("--counter-clockwise", action="store_true", help="give all vertices counter-clockwise")
    check.add_argument("--seed", type=SEED, default=1, metavar="N", help="seed of the random pairs (default: 1)")
    check.add_argument("--seconds", type=float, default=5.0, metavar="S", help="seconds for all calls (default: 5)")
    check.add_argument("--call-seconds", type=float, default=2.0, metavar="S", help="seconds for one call (default: 2)")
    check.add_argument("--json", action="store_true", help="print the result as JSON")
    check.add_argument("--out", type=_folder, metavar="DIR", help="draw the counterexample, into this folder")
    check.add_argument("--theme", choices=THEMES, default="light", help="(default: light)")
    check.add_argument("--force", action="store_true", help="overwrite files that satviz did not make")
    check.set_defaults(run=commands.check, clash=_clash_of_check)

    handout = command.add_parser(
        "handout",
        help="write questions to print for a class, and their solutions on another sheet",
        epilog="A scene has its picture, empty number lines and a table to fill in. The files are HTML in black and "
        "white: print them, or save them as PDF, from any browser.",
    )
    handout.add_argument(
        "what",
        nargs="+",
        metavar="CHAPTER|SCENE",
        help="a chapter (2 or 2-sat), a scene's name, a scene file or a link",
    )
    handout.add_argument("--paper", choices=PAPERS, default="A4", help="(default: A4)")
    _add_folder(handout, "--out", "satviz-handout")
    handout.add_argument("--force", action="store_true", help="overwrite files that satviz did not make")
    handout.set_defaults(run=commands.handout)

    notebook = command.add_parser("notebook", help="copy the walkthrough's notebooks and open them in JupyterLab")
    _add_folder(notebook, "out", "satviz-notebooks", nargs="?")
    notebook.add_argument("--no-open", action="store_true", help="copy them, but do not open them")
    notebook.add_argument("--force", action="store_true", help="overwrite notebooks that were changed")
    notebook.set_defaults(run=commands.notebook)

    bench = command.add_parser("bench", help="time satviz beside its peers and count the wrong answers of each")
    bench.add_argument(
        "--pairs",
        type=_whole_number(1, 10**8),
        metavar="N",
        help="pairs per workload; scenes grow with them (default: 100000)",
    )
    bench.add_argument(
        "--rounds", type=_whole_number(1, 10**6), metavar="N", help="rounds; times are medians (default: 9)"
    )
    bench.add_argument("--seed", type=SEED, default=1, metavar="N", help="seed of the random pairs (default: 1)")
    bench.add_argument("--quick", action="store_true", help="make a shorter run: half a minute, rough figures")
    bench.add_argument("--json", action="store_true", help="print the figures, the machine and the versions as JSON")
    bench.add_argument("--chart", type=_folder, metavar="DIR", help="draw the figures as well, into this folder")
    bench.add_argument("--force", action="store_true", help="overwrite files that satviz did not make")
    bench.set_defaults(run=commands.bench, clash=_clash_of_bench, usual={"pairs": 100_000, "rounds": 9})

    study = command.add_parser("study", help="chart speed against accuracy, and what exactness costs")
    study.add_argument("--quick", action="store_true", help="make fewer and smaller runs, half a minute, and no PNG")
    _add_folder(study, "--out", "satviz-study", "the folder ")
    study.add_argument("--seed", type=SEED, default=1, metavar="N", help="seed of all random numbers (default: 1)")
    study.add_argument(
        "--executor",
        metavar="WHERE",
        help="where to run work that is not timed: threads, processes, or a dask scheduler's address",
    )
    study.add_argument("--force", action="store_true", help="overwrite files that satviz did not make")
    study.set_defaults(run=commands.study)

    reference = command.add_parser("reference", help="write a reference of all public names, with examples")
    _add_folder(reference, "--out", "satviz-reference")
    reference.add_argument("--force", action="store_true", help="overwrite files that satviz did not make")
    reference.set_defaults(run=commands.reference)

    site = command.add_parser("site", help="write the site: drag scenes and read the chapters in any browser")
    _add_folder(site, "out", "satviz-site", nargs="?")
    site.add_argument("--open", action="store_true", help="serve it on this machine and open it, until Ctrl-C")
    site.add_argument("--zip", action="store_true", help="write DIR.zip, a package for a learning platform, instead")
    site.add_argument("--url", default="", metavar="URL", help="the site's future address, for sitemap and previews")
    site.add_argument("--pyodide", type=_folder, metavar="DIR", help="folder with Pyodide's core (else npm fetches it)")
    site.add_argument("--still", action="store_true", help="leave out Python: then shapes cannot be dragged")
    site.add_argument("--force", action="store_true", help="overwrite files that satviz did not make")
    site.set_defaults(run=commands.site, clash=_clash_of_site)

    scenes = command.add_parser("scenes", help="list the built-in scenes")
    scenes.add_argument("--json", action="store_true", help="print every scene with its expected answer as JSON")
    scenes.add_argument("--failing", action="store_true", help="list those where shortcuts fail, and the right answers")
    twice = "--json lists the failing scenes too: leave out --failing"
    scenes.set_defaults(run=commands.scenes, clash=lambda args: twice if args.json and args.failing else None)
    return parser


def _add_folder(parser: argparse.ArgumentParser, name: str, default: str, about: str = "", **more: Any) -> None:
    """Add the argument `name` for the folder that a command writes to; `more`: further arguments of `add_argument`."""
    words = f"{about}(default: {default})"
    parser.add_argument(name, type=_folder, default=Path(default), metavar="DIR", help=words, **more)


def _add_scene_options(parser: argparse.ArgumentParser) -> None:
    """Add SCENE and its options to a command that takes a scene."""
    from .engine.axes import NAMED
    from .scenes.failing import SHORTCUTS

    parser.add_argument("scene", metavar="SCENE", help="a built-in scene's name, a scene file, or a link to a scene")
    named = f"which axes to test: {', '.join(NAMED)}, or a shortcut by name (satviz scenes --failing)"
    parser.add_argument("--axes", choices=(*NAMED, *SHORTCUTS), metavar="NAME", help=named)
    parser.add_argument("--every-axis", action="store_true", help="go on past the first separating axis")


def _add_output_options(parser: argparse.ArgumentParser, out: str, formats: Sequence[str]) -> None:
    """Add the options of commands that write files; `out`: the default folder, `formats`: choices."""
    parser.add_argument("--out", type=_folder, metavar="DIR", help=f"the folder to write to (default: {out})")
    parser.add_argument("--format", action="append", choices=formats, help="format; may be repeated (default: svg)")
    parser.add_argument("--theme", choices=THEMES, help="(default: light)")
    parser.add_argument("--force", action="store_true", help="overwrite files that satviz did not make")
    parser.set_defaults(usual={"out": Path(out), "format": ["svg"], "theme": "light"})


def _speed(text: str) -> float:
    """Return a speed from the command line; ArgumentTypeError if it is not a number from 0.05 to 20."""
    try:
        speed = float(text)
    except ValueError:
        speed = 0.0
    if not 1 / MAX_SPEED <= speed <= MAX_SPEED:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a speed: give a number from {1 / MAX_SPEED:g} to {MAX_SPEED:g}"
        )
    return speed


def _step_range(text: str) -> tuple[int, int]:
    """Return the first and the last step of "5", "3-8" or "last", which is -1; ArgumentTypeError for anything else."""
    first, dash, last = text.partition("-")
    if not first or (dash and (not last or first == "last")):
        raise argparse.ArgumentTypeError(f"{text!r} is not a step: give a number such as 5, two such as 3-8, or last")
    number = _whole_number(0, 10**6 - 1)
    begin, end = (-1 if each == "last" else number(each) for each in (first, last if dash else first))
    if -1 < end < begin:
        raise argparse.ArgumentTypeError(f"{text!r} ends before it begins: write the smaller number first")
    return begin, end


def _clash_of_draw(args: argparse.Namespace) -> str | None:
    """Return an error line if options of `draw` cannot be given together; otherwise None."""
    formats = set(args.format or ["svg"])
    if args.site is not None and not formats & PRINTED_FORMATS:
        return "--site is the address of a link or a frame: give it with --format link or embed"
    if args.site == "":
        return "--site is empty: expected an address such as https://example.org/satviz/, or no --site"
    if "embed" in formats and args.site is None:
        return "--format embed needs the address of your site: give --site URL"
    if clash := _clash_of_frame(args, formats):
        return clash
    if args.sheet and (others := formats - {*STILL_FORMATS, *PRINTED_FORMATS}):
        apart = " or ".join(sorted(others))
        return f"--sheet makes one picture ({', '.join(STILL_FORMATS)}): give --format {apart} in another run"
    if args.speed is not None and not formats & {"gif", "html"}:
        return "--speed is for an animation or a page: give it with --format gif or html"
    files = formats - PRINTED_FORMATS
    of_files = ["out", "force", "caption", "sheet", "steps", "sweep", "difference"] + ["theme"] * (
        "embed" not in formats
    )
    if not files and (given := _first_given(args, *of_files)):
        printed = "a line" if "link" in formats else "a frame"
        return f"--format {min(formats)} prints {printed}: {given} is for files, so add the format of a file"
    if files == {"html"} and args.theme and "embed" not in formats:
        return "a page follows its reader's theme: leave out --theme, or add the format of a picture"
    return None


def _clash_of_frame(args: argparse.Namespace, formats: set[str]) -> str | None:
    """Return an error line if an option for pages, links or iframes does not fit the `formats`; otherwise None."""
    takes = {"predict": {"html", *PRINTED_FORMATS}, "goal": PRINTED_FORMATS, "play": {"embed"}, "show": {"embed"}}
    for name, forms in takes.items():
        if getattr(args, name) and not formats & forms:
            return f"--{name} is not for these formats: give it with --format {' or '.join(sorted(forms))}"
    if args.goal and (given := _first_given(args, "predict", "play", "step")):
        return f"a challenge has no steps, and {given} is for steps: leave out one of them"
    if args.step and formats == {"html"}:
        return "a page has all steps: leave out --step, or add the format of a picture"
    if args.step and args.step[0] != args.step[1] and formats == {"link"}:
        return "a link opens one step: give --step one number, or --format embed"
    return None


def _clash_of_chart(args: argparse.Namespace) -> str | None:
    """Return an error line if --force is given and nothing is written; otherwise None."""
    return "--force overwrites files: give it with --chart" if args.force and not args.chart else None


def _clash_of_bench(args: argparse.Namespace) -> str | None:
    """Return an error line if options of `bench` cannot be given together; otherwise None."""
    if args.quick and (given := _first_given(args, "pairs", "rounds")):
        return f"--quick sets the pairs and the rounds: give it without {given}"
    return _clash_of_chart(args)


def _clash_of_check(args: argparse.Namespace) -> str | None:
    """Return None if exactly one of a file, --command and --symptom is given; otherwise an error line."""
    if sum(map(bool, (args.target, args.command, args.symptom))) != 1:
        return 'give exactly one: FILE.py:function, --command "node mine.js" or --symptom WORDS'
    return None


def _clash_of_site(args: argparse.Namespace) -> str | None:
    """Return an error line if options of `site` cannot be given together; otherwise None."""
    if args.zip and args.open:
        return "--open serves a folder, and --zip writes a file: leave out one of them"
    return "--still leaves out Python: leave out --pyodide" if args.still and args.pyodide else None


def _first_given(args: argparse.Namespace, *names: str) -> str | None:
    """Return the first of the named options that was given, with its dashes ("--out"); None if none was."""
    return next((f"--{name}" for name in names if getattr(args, name)), None)

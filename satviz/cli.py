"""satviz figures | trace | draw | study | notebook | scenes | bench: what the command line understands."""

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NoReturn

from . import __version__, commands
from .commands import Refused
from .geometry import InvalidScene

THEMES = ("light", "dark")
FIGURE_FORMATS = ("svg", "png", "pdf")
DRAW_FORMATS = (*FIGURE_FORMATS, "gif", "html")


class Parser(argparse.ArgumentParser):
    """Says what is wrong in one line, as every command does."""

    def error(self, message: str) -> NoReturn:
        print(f"satviz: {message} (try {self.prog} --help)", file=sys.stderr)
        raise SystemExit(2)


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command; 0 done, 2 bad input, 130 interrupted."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")  # a label that the terminal cannot show is no reason to fail
    args = _parser().parse_args(argv)
    try:
        return args.run(args)
    except (Refused, InvalidScene, FileExistsError) as error:
        message = str(error)
    except OSError as error:
        if isinstance(error, BrokenPipeError):
            sys.stderr.close()  # the reader has gone: nothing left to say
            return 0
        message = f"{error.filename or 'file'}: {error.strerror or error}"
    except KeyboardInterrupt:
        print("satviz: interrupted; files already named are whole", file=sys.stderr)
        return 130
    print(f"satviz: {message}", file=sys.stderr)
    return 2


def _parser() -> argparse.ArgumentParser:
    parser = Parser(prog="satviz", description="2D collision detection by the Separating Axis Theorem, made visible.")
    parser.add_argument("--version", action="version", version=f"satviz {__version__}")
    command = parser.add_subparsers(required=True, metavar="COMMAND")

    figures = command.add_parser("figures", help="make the article's twenty figures")
    _output(figures, "figures", FIGURE_FORMATS)
    figures.add_argument(
        "--only", metavar="NAME", action="append", help="only this figure, by name or number; may be repeated"
    )
    figures.set_defaults(run=commands.figures)

    trace = command.add_parser("trace", help="print every test of a scene as a table")
    _scene(trace)
    trace.add_argument("--json", action="store_true", help="print the whole trace as JSON")
    trace.set_defaults(run=commands.trace)

    draw = command.add_parser("draw", help="draw every step of a scene")
    _scene(draw)
    _output(draw, "satviz-out", DRAW_FORMATS)
    draw.add_argument(
        "--caption", action="store_true", help="put each sentence under its picture (a GIF always has it)"
    )
    draw.set_defaults(run=commands.draw)

    notebook = command.add_parser("notebook", help="copy the walkthrough's notebooks and open them in JupyterLab")
    notebook.add_argument(
        "out", nargs="?", type=Path, default=Path("satviz-notebooks"), metavar="DIR", help="(default: satviz-notebooks)"
    )
    notebook.add_argument("--no-open", action="store_true", help="copy them only")
    notebook.add_argument("--force", action="store_true", help="overwrite notebooks that were changed")
    notebook.set_defaults(run=commands.notebook)

    bench = command.add_parser("bench", help="time satviz beside its peers and count the wrong answers of each")
    bench.add_argument(
        "--pairs", type=_count, default=100_000, metavar="N", help="pairs a workload, boxes a layout (default: 100000)"
    )
    bench.add_argument(
        "--rounds", type=_count, default=9, metavar="N", help="rounds to take the median of (default: 9)"
    )
    bench.add_argument("--seed", type=int, default=1, metavar="N", help="of the random pairs (default: 1)")
    bench.add_argument("--json", action="store_true", help="print the figures, the machine and the versions as JSON")
    bench.set_defaults(run=commands.bench)

    study = command.add_parser("study", help="chart speed against accuracy, and stability where methods fail")
    study.add_argument("--quick", action="store_true", help="fewer and smaller runs, about a minute, and no PNG")
    study.add_argument(
        "--out", type=Path, default=Path("satviz-study"), metavar="DIR", help="the folder (default: satviz-study)"
    )
    study.add_argument("--seed", type=_seed, default=1, metavar="N", help="of all that is random (default: 1)")
    study.add_argument(
        "--executor", metavar="WHERE", help="threads, processes, or a dask scheduler's address, for what is not timed"
    )
    study.add_argument("--force", action="store_true", help="overwrite files that satviz did not make")
    study.set_defaults(run=commands.study)

    scenes = command.add_parser("scenes", help="list the built-in scenes")
    scenes.add_argument("--failing", action="store_true", help="those where shortcuts fail, and what is right")
    scenes.set_defaults(run=commands.scenes)
    return parser


def _count(text: str) -> int:
    value = int(text)
    if value < 1:
        raise argparse.ArgumentTypeError(f"{text} is not a positive number")
    return value


def _seed(text: str) -> int:
    value = int(text)
    if value < 0:
        raise argparse.ArgumentTypeError(f"{text} is negative")
    return value


def _scene(parser: argparse.ArgumentParser) -> None:
    from .axes import NAMED

    parser.add_argument("scene", metavar="SCENE", help="a built-in scene's name or a scene file")
    parser.add_argument("--axes", choices=NAMED, metavar="NAME", help=f"which axes to test: {', '.join(NAMED)}")
    parser.add_argument("--every-axis", action="store_true", help="go on past the first separating axis")


def _output(parser: argparse.ArgumentParser, out: str, formats: Sequence[str]) -> None:
    parser.add_argument(
        "--out", type=Path, default=Path(out), metavar="DIR", help=f"the folder to write to (default: {out})"
    )
    parser.add_argument("--format", action="append", choices=formats, help="may be given several times (default: svg)")
    parser.add_argument("--theme", choices=THEMES, default="light")
    parser.add_argument("--force", action="store_true", help="overwrite files that satviz did not make")

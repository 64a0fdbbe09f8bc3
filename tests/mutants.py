"""What no test would notice: small faults sown into the exact core one at a time, and the tests run against each.

    python -m pip install 'mutmut>=3.8' && python tests/mutants.py exact axes:240 batch/signs

prints a table and every mutant that survived; without names it goes through the whole
core.  tests/mutants.md holds the last table and, for each survivor that changes nothing,
the reason: those are known and only counted.  mutmut makes most of the mutants; it is run
by a parent that has loaded the large libraries once and forks a child a mutant.
Strings, messages (all of a raise), annotations and docstrings are left as they are.
"""

import ast
import gc
import importlib
import json
import os
import re
import resource
import signal
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator
from importlib.machinery import SourceFileLoader
from importlib.util import spec_from_file_location
from pathlib import Path

import libcst as cst
import libcst.matchers as m
from libcst.metadata import MetadataWrapper, PositionProvider
from mutmut.mutation import mutators

HERE = Path(__file__).parent
ROOT = HERE.parent / "satviz"
NOTES = HERE / "mutants.md"
AT_ONCE = 2
LOADED_ONCE = ["hypothesis.strategies", "matplotlib", "numba", "numpy", "pytest", "shapely.geometry"]
TESTS = {  # which test files judge a module; within them those that killed before, then the quickest, go first
    "exact": ["exact", "trace"],
    "geometry": ["shapes", "trace"],
    "outline": ["shapes"],
    "shapes": ["shapes", "trace"],
    "concave": ["concave"],
    "verdict": ["verdict", "trace"],
    "axes": ["axes", "trace"],
    "sat": ["trace", "pictures"],
    "escape": ["trace"],
    "certificate": ["trace"],
    "trace": ["trace", "pictures"],
    "tracefile": ["trace"],
    **{f"batch/{path.stem}": ["batch"] for path in sorted((ROOT / "batch").glob("[!_]*.py"))},
}

# -- the mutants -----------------------------------------------------------------------------------

ORDER = cst.LessThan, cst.LessThanEqual, cst.GreaterThan, cst.GreaterThanEqual
SWAPS = {
    **{way: [other for other in ORDER if other is not way] for way in ORDER},
    cst.Equal: [cst.NotEqual, cst.LessThanEqual, cst.GreaterThanEqual],
    cst.Add: [cst.Multiply],
    cst.Subtract: [cst.Multiply],
    cst.Multiply: [cst.Add],
    cst.Break: [cst.Continue],
}
TWINS = {"min": "max", "max": "min", "any": "all", "all": "any"}
NEEDLESS = "abs", "sorted", "set", "float", "int"  # calls that might as well be left out


def numbers(node: cst.BaseNumber) -> Iterator[cst.CSTNode]:
    """One more or less; a bound far from 1 is brought to 1 or done away with."""
    value = node.evaluated_value
    far = isinstance(value, float) and not 1e-9 < abs(value) < 1e9
    for other in (1.0, 0.0 if value < 1 else 1e999) if far else (value - 1, value + 1):
        literal = repr(other).replace("inf", "1e999")
        yield cst.parse_expression(f"({literal})" if other < 0 else literal)


def names(node: cst.Name) -> Iterator[cst.CSTNode]:
    if node.value in TWINS:
        yield node.with_changes(value=TWINS[node.value])


def swaps(node: cst.CSTNode) -> Iterator[cst.CSTNode]:
    return (other() for other in SWAPS.get(type(node), ()))


def calls(node: cst.Call) -> Iterator[cst.CSTNode]:
    if m.matches(node.func, m.OneOf(*map(m.Name, NEEDLESS))) and len(node.args) == 1:
        yield node.args[0].value.with_changes(lpar=[cst.LeftParen()], rpar=[cst.RightParen()])


def arguments(node: cst.Call) -> Iterator[cst.CSTNode]:
    """Without its last argument or one that has a name; zip's strict is only a check."""
    for i, arg in enumerate(node.args):
        named = arg.keyword and arg.keyword.value
        if len(node.args) > 1 and named != "strict" and (named or i == len(node.args) - 1):
            yield node.with_changes(args=[*node.args[:i], *node.args[i + 1 :]])


def signs(node: cst.UnaryOperation) -> Iterator[cst.CSTNode]:
    yield node.expression


def conditions(node: cst.If | cst.CompIf) -> Iterator[cst.CSTNode]:
    for value in "True", "False":
        yield node.with_changes(test=cst.Name(value, lpar=[cst.LeftParen()], rpar=[cst.RightParen()]))


def removal(node: cst.SimpleStatementLine) -> Iterator[cst.CSTNode]:
    kept = m.Import() | m.ImportFrom() | m.Pass() | m.Expr(m.SimpleString() | m.ConcatenatedString())
    if not m.matches(node, m.SimpleStatementLine([kept | m.AnnAssign(value=None)])):
        yield node.with_changes(body=[cst.Pass()])


def bare(node: cst.FunctionDef | cst.ClassDef) -> Iterator[cst.CSTNode]:
    if node.decorators:
        yield node.with_changes(decorators=[])


REPLACED = cst.BaseNumber, cst.BaseString, cst.Assign, cst.Call
OPERATORS = [
    *(pair for pair in mutators.mutation_operators if pair[0] not in REPLACED),
    (cst.BaseNumber, numbers),
    (cst.Name, names),
    (cst.CSTNode, swaps),
    (cst.Call, calls),
    (cst.Call, arguments),
    (cst.UnaryOperation, signs),
    ((cst.If, cst.CompIf), conditions),
    (cst.SimpleStatementLine, removal),
    ((cst.FunctionDef, cst.ClassDef), bare),
]
ALIAS = m.SimpleStatementLine([m.Assign(value=m.Subscript() | m.BinaryOperation(operator=m.BitOr()))])
WORDS = m.Annotation() | m.Decorator() | m.FormattedString() | m.SimpleString() | m.Raise()
CHECK = m.Arg(keyword=m.Name("strict"))


def mutants(path: Path) -> Iterator[tuple[int, str, str]]:
    """(line, what changed, mutated source) of each; those that are no Python or the same program are left out."""
    text = path.read_text(encoding="utf-8")
    wrapper = MetadataWrapper(cst.parse_module(text), unsafe_skip_copy=True)
    tree, places = wrapper.module, wrapper.resolve(PositionProvider)
    for statement in tree.body:
        if m.matches(statement, ALIAS):
            continue
        code = tree.code_for_node(statement)
        seen = {ast.dump(ast.parse(code))}
        for node in inner(statement):
            for kind, operator in OPERATORS:
                for other in operator(node) if isinstance(node, kind) else ():
                    changed = tree.code_for_node(statement.deep_replace(node, other))
                    try:
                        program = ast.dump(ast.parse(changed))
                    except SyntaxError:
                        continue
                    if program not in seen:
                        seen.add(program)
                        whole = text.replace(code, changed, 1)
                        yield places[node].start.line, difference(text, whole), whole


def inner(node: cst.CSTNode) -> Iterator[cst.CSTNode]:
    """The node and all below, but for words."""
    if not m.matches(node, WORDS | CHECK):
        yield node
        for child in node.children:
            yield from inner(child)


def difference(old: str, new: str) -> str:
    """function: `old lines` → `new lines`."""
    old, new = (re.sub("  # .*", "", source).splitlines() for source in (old, new))
    while old and new and old[-1] == new[-1]:
        old.pop(), new.pop()
    same = next((i for i, (p, q) in enumerate(zip(old, new)) if p != q), min(len(old), len(new)))
    inside = [found[1] for line in old[: same + 1] if (found := re.match(r" *(?:def|class) (\w+)", line))]
    where = inside[-1] if inside and (old[same:] or [" "])[0].startswith((" ", "def", "class", "@")) else "module"
    was, now = (" ".join(map(str.strip, lines[same:])) for lines in (old, new))
    return f"{where}: `{was}` → `{now}`"


# -- the judging -----------------------------------------------------------------------------------


class Sown(SourceFileLoader):
    """Imports one module of satviz from other source."""

    def __init__(self, path: Path, source: str):
        self.module = ".".join(("satviz", *path.relative_to(ROOT).with_suffix("").parts))
        self.source = source
        super().__init__(self.module, str(path))

    def find_spec(self, name: str, path: object = None, target: object = None):
        return spec_from_file_location(name, self.path, loader=self) if name == self.module else None

    def get_code(self, name: str):
        return compile(self.source, self.path, "exec")


class Watch:
    """Puts likely killers first, stops a test that runs away, tells the parent who killed and how long tests take."""

    def __init__(self, out: Path, kills: Counter, times: dict[str, float]):
        self.out, self.kills, self.times, self.found = out, kills, times, {}

    def pytest_collection_modifyitems(self, items: list) -> None:
        items.sort(key=lambda item: (-self.kills[item.nodeid], self.times.get(item.nodeid, 0)))

    def pytest_runtest_setup(self, item) -> None:
        self.out.write_text(json.dumps({"at": item.nodeid}))
        signal.setitimer(signal.ITIMER_PROF, 5 + 10 * self.times.get(item.nodeid, 9))  # seconds of this process's work

    def pytest_runtest_logreport(self, report) -> None:
        self.found[report.nodeid] = self.found.get(report.nodeid, 0) + report.duration

    def pytest_sessionfinish(self) -> None:
        last = json.loads(self.out.read_text()) if self.out.exists() else {}
        self.out.write_text(json.dumps(last | {"times": self.found}))


def judge(path: Path, source: str, tests: list[str], watch: Watch) -> int:
    """pytest's exit code in this process, which dies of a signal if a test runs away."""
    import hypothesis
    import numba
    import pytest

    os.nice(5)
    resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    signal.setitimer(signal.ITIMER_PROF, 8)
    sys.dont_write_bytecode = True
    sys.meta_path.insert(0, Sown(path, source))
    sys.path.insert(0, str(HERE.parent))
    if path.parent.name == "batch":  # compiled kernels are kept by file, not by what is in it
        numba.config.CACHE_DIR = str(watch.out) + "-numba"
    plain = {"derandomize": True, "database": None, "deadline": None, "phases": ["explicit", "generate"]}
    hypothesis.settings.register_profile("mutants", **plain)
    hypothesis.settings.load_profile("mutants")
    without = [part for name in ("cacheprovider", "unraisableexception") for part in ("-p", f"no:{name}")]
    flags = ["-x", "-q", "--tb=no", "--assert=plain", "-W", "ignore", "-m", "not full", *without]
    codes = (pytest.main([*flags, str(HERE / f"test_{name}.py")], plugins=[watch]) for name in tests)
    return next((int(code) for code in codes if code), 0)


def sow(path: Path, tests: list[str], wanted: int, folder: Path) -> Counter:
    """Judge every mutant of a module (of one line, if wanted) and print the survivors."""
    text = path.read_text(encoding="utf-8")
    kills: Counter[str] = Counter()
    times: dict[str, float] = {}
    known = set(re.findall(r"^- (\w+: `.*` → `.*`)$", NOTES.read_text("utf-8"), re.M)) if NOTES.exists() else set()
    score: Counter[str] = Counter()
    running: dict[int, tuple[int, str]] = {}

    def start(line: int, change: str, source: str) -> None:
        sys.stdout.flush()
        if pid := os.fork():
            running[pid] = line, change
            return
        sink = os.open(os.devnull, os.O_WRONLY)
        os.dup2(sink, 1), os.dup2(sink, 2)
        try:
            code = judge(path, source, tests, Watch(folder / str(os.getpid()), kills, times))
        finally:
            os._exit(code if "code" in locals() else 3)

    def end() -> tuple[str, dict]:
        pid, status = os.wait()
        line, change = running.pop(pid)
        note = folder / str(pid)
        told = json.loads(note.read_text() or "{}") if note.exists() else {}
        code = os.waitstatus_to_exitcode(status)
        fate = "timed out" if code < 0 else "killed" if code else "equivalent" if change in known else "survived"
        if line and fate == "survived":
            print(f"{path.stem}:{line} {change}", flush=True)
        kills[told.get("at", "")] += bool(code)
        return fate, told

    start(0, "", text)
    fate, told = end()
    assert fate == "survived", f"the tests of {path.stem} fail without any mutant: {told.get('at')}"
    times.update(told["times"])
    for line, change, source in mutants(path):
        if not wanted or line == wanted:
            start(line, change, source)
            if len(running) == AT_ONCE:
                score[end()[0]] += 1
    while running:
        score[end()[0]] += 1
    return score


def main(*names: str) -> None:
    os.environ |= {"PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1", "OPENBLAS_NUM_THREADS": "1", "MPLBACKEND": "agg"}
    for name in LOADED_ONCE:
        importlib.import_module(name)
    fates = "killed", "timed out", "equivalent", "survived"
    rows = []
    gc.freeze()
    with tempfile.TemporaryDirectory() as folder:
        for name in names or TESTS:
            name, _, line = name.partition(":")
            score = sow(ROOT / f"{name}.py", TESTS[name], int(line or 0), Path(folder))
            rows.append(f"| {name} | {score.total()} | " + " | ".join(str(score[fate]) for fate in fates) + " |")
            print(rows[-1], flush=True)
    print("\n| module | mutants | " + " | ".join(fates) + " |\n|---|--:|--:|--:|--:|--:|")
    print(*rows, sep="\n")


if __name__ == "__main__":
    main(*sys.argv[1:])

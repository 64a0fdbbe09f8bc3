"""Mutation tests: small faults are sown into the exact core one at a time, and the tests run against each.

    python -m pip install 'mutmut>=3.8' && python tests/mutants.py engine/axes:same_axis batch/exact_signs

prints every mutant that survived, every one that was killed though listed as equivalent, and a
table; without names it goes through the whole core.  engine/axes:same_axis,module sows one function
and the statements outside of any, batch/validation~300 a random sample of 300, always the same;
--new leaves out those that are listed as equivalent.  tests/mutants.md holds the last table and, for
each survivor that changes nothing, the reason: those are known and only counted.  Half the kinds of
mutants are mutmut's.  Its runner starts Python anew for each; here a parent loads the large libraries
once and forks.  Left as they are: strings, messages (all of a raise), annotations, docstrings, zip's strict.
"""

import ast
import gc
import importlib.util
import json
import os
import re
import resource
import signal
import sys
import tempfile
import time
from collections import Counter, defaultdict
from collections.abc import Iterator
from importlib.machinery import SourceFileLoader
from importlib.util import spec_from_file_location
from pathlib import Path
from random import Random

import libcst as cst
import libcst.matchers as m
from libcst.metadata import MetadataWrapper, PositionProvider
from mutmut.mutation.mutators import mutation_operators

HERE = Path(__file__).parent
ROOT = HERE.parent / "satviz"
AT_ONCE = int(os.environ.get("AT_ONCE", 2))
QUICK = 0.5  # seconds of CPU time: slower tests do not judge, since each survivor goes through all that do
SLEEP = 300  # seconds of wall time without any work, after which a test is stopped
LOADED_ONCE = ["hypothesis.strategies", "matplotlib", "numba", "numpy", "pytest", "shapely.geometry"]
BATCH_TESTS = [
    f"batch_{idea}" for idea in ("narrow", "exact", "broad", "work", "outlines", "few", "validation", "padded")
]
TESTS = {  # which test files judge a module
    "engine/geometry": ["geometry", "shapes", "certificate", "mtv"],
    "engine/predicates": ["predicates", "trace", "relate"],
    "engine/sweep": ["shapes", "convex_parts"],
    "engine/polygon_validation": ["shapes"],
    "engine/shapes": ["shapes", "trace"],
    "engine/triangulation": ["convex_parts"],
    "engine/convex_parts": ["convex_parts"],
    "engine/relate": ["relate"],
    **{
        path.relative_to(ROOT).with_suffix("").as_posix(): BATCH_TESTS
        for path in sorted((ROOT / "batch").rglob("[!_]*.py"))
    },
    "batch/with_numba/few": ["batch_small", "batch_few", "batch_broad", "batch_padded"],
    "batch/with_numba/filter": ["batch_small", "batch_narrow", "batch_exact"],
    "batch/with_numba/grid": ["batch_small", "batch_few", "batch_broad"],
    "batch/with_numba/indexed": ["batch_small", "batch_narrow", "batch_exact"],
    "batch/with_numba/outlines": ["batch_small", "batch_few", "batch_outlines", "batch_padded", "batch_validation"],
    "batch/moving": ["batch_moving", "batch_few", "batch_padded"],
    "batch/with_numpy/filter": ["batch_filter_numpy", "batch_narrow", "batch_exact"],
    "batch/with_numpy/few": ["batch_few_numpy", "batch_few", "batch_broad", "batch_padded"],
    "batch/with_numpy/outlines": ["batch_outlines", "batch_few", "batch_padded", "batch_validation"],
    "engine/axes": ["axes", "trace", "failing"],
    "engine/sat": ["trace"],
    "engine/shortcut": ["failing", "trace"],
    "engine/axis_count": ["advice"],
    "engine/mtv": ["mtv"],
    "engine/certificate": ["certificate", "trace"],
    "engine/trace": ["trace", "failing", "mtv"],
    "scenes/tracefile": ["trace", "failing"],
}
GRID = "boxes or candidate or cells or collid or grid or stream"
ABOUT = {  # of those files only these tests, as pytest -k takes them, since each survivor goes through all that judge
    "batch/broad_phase": GRID,
    "batch/with_numba/grid": f"{GRID} or small",
    "batch/with_numpy/grid": GRID,
    "batch/with_numba/few": f"({GRID} or small or few or giant or joined or order or pairs or sizes or sorted or swept)"
    " and not (bad or cells or depends or index or layout or outline or rows or side_by_side)",
    "batch/with_numba/outlines": "bad or circles or layout or number or outline or padded or pose or radi or repeats"
    " or small or tile or zero",
    "batch/with_numpy/few": "few_numpy or all_colliding or along_one or candidate_pairs or chosen or depends or giant"
    " or joined or joins or no_comparisons or odd_shape_among or padded or same_broad or swept or unlike",
    "batch/with_numpy/outlines": "circles or kind_of_array or number or outlines or padded or star or validates",
    "batch/with_numpy/filter": "begins or circles or filter_numpy or float32 or hard_pairs or ordinary or upright"
    " or width",
    "batch/moving": "moves or moving or place or pose",
    "engine/axis_count": "axes or axis or enough or touch",
    "batch/with_numba/filter": "circles or columns or filter or float32 or hard_pairs or ordinary or scalar or small"
    " or upright",
    "batch/with_numba/indexed": "columns or hard_pairs or index or lanes or many_corners or ordinary or small"
    " or upright",
    "batch/with_numpy/indexed": "hard_pairs or index or many_corners or ordinary or side_by_side or upright",
    "batch/with_numpy/circle_polygons": "circle or foot or hard_pairs or relations_are_the_scalar or tiny",
}
# what kernels run as Python cannot do: number cells beyond 2**63, pass by 1e308 without a warning, and be quick
COMPILED_ONLY = [
    "are_candidates",
    "every_layout",
    "little_memory",
    "comparisons_of_the_grid",
    "of_every_size",
    "warn_of_nothing",
]
FATES = "killed", "timed out", "equivalent", "survived"

# -- the mutants -----------------------------------------------------------------------------------

ORDER = cst.LessThan, cst.LessThanEqual, cst.GreaterThan, cst.GreaterThanEqual
SWAPS = {
    **{way: [other for other in ORDER if other is not way] for way in ORDER},
    cst.Add: [cst.Multiply],
    cst.Subtract: [cst.Multiply],
    cst.Multiply: [cst.Add],
    cst.Break: [cst.Continue],
}
TWINS = {"min": "max", "max": "min", "any": "all", "all": "any"}
NEEDLESS = {"abs", "sorted", "set", "float", "int"}  # calls that might as well be left out
KEPT = m.Import() | m.ImportFrom() | m.Pass() | m.AnnAssign(value=None) | m.Expr(m.SimpleString())
WORDS = m.Annotation() | m.Decorator() | m.FormattedString() | m.SimpleString() | m.Raise()
CHECK = m.Arg(keyword=m.Name("strict"))
ALIAS = m.SimpleStatementLine([m.Assign(value=m.Subscript() | m.BinaryOperation(operator=m.BitOr()))])


def ours(node: cst.CSTNode) -> Iterator[cst.CSTNode]:
    """Yield the replacements of a node, in addition to those of mutmut."""
    for other in SWAPS.get(type(node), ()):
        yield other()
    match node:
        case cst.Integer() | cst.Float():  # one more or less; a bound far from 1 is brought to 1 or done away with
            value = node.evaluated_value
            far = isinstance(value, float) and not 1e-9 < value < 1e9
            for other in (1.0, 0.0 if value < 1 else 1e999) if far else (value - 1, value + 1):
                yield cst.parse_expression(repr(other).replace("inf", "1e999") if other >= 0 else f"({other!r})")
        case cst.Name(value) if value in TWINS:
            yield cst.Name(TWINS[value])
        case cst.Call(cst.Name(called), [arg]) if called in NEEDLESS:
            yield arg.value.with_changes(lpar=[cst.LeftParen()], rpar=[cst.RightParen()])
        case cst.Call(_, args) if len(args) > 1:  # without its last argument, or one that has a name
            for i, arg in enumerate(args):
                if not m.matches(arg, CHECK) and (arg.keyword or i == len(args) - 1):
                    yield node.with_changes(args=[*args[:i], *args[i + 1 :]])
        case cst.UnaryOperation():
            yield node.expression
        case cst.If() | cst.CompIf():
            for value in "True", "False":
                yield node.with_changes(test=cst.parse_expression(f"({value})"))
        case cst.SimpleStatementLine() if not m.matches(node, m.SimpleStatementLine([KEPT])):
            yield node.with_changes(body=[cst.Pass()])
        case cst.FunctionDef() | cst.ClassDef() if node.decorators:
            yield node.with_changes(decorators=[])


REPLACED = cst.BaseNumber, cst.BaseString, cst.Assign, cst.Call  # of mutmut's: ours do more, or only crash less
OPERATORS = [*(pair for pair in mutation_operators if pair[0] not in REPLACED), (cst.CSTNode, ours)]


def mutants(path: Path) -> Iterator[tuple[int, str, str]]:
    """Yield (line, key, mutated source) of each mutant; those that are no Python or the same program are left out.

    The key, such as "orient: > → >= #2", names function, operator and place: the second such change in that function.
    No name of a variable is in it, so it survives a rename.
    """
    text = path.read_text(encoding="utf-8")
    wrapper = MetadataWrapper(cst.parse_module(text), unsafe_skip_copy=True)
    tree, places = wrapper.module, wrapper.resolve(PositionProvider)
    count: Counter[tuple[str, str]] = Counter()
    for statement in tree.body:
        code = tree.code_for_node(statement)
        seen = {ast.dump(ast.parse(code))}
        for function, node in () if m.matches(statement, ALIAS) else inner(statement):
            for other in (other for kind, make in OPERATORS if isinstance(node, kind) for other in make(node)):
                changed = tree.code_for_node(statement.deep_replace(node, other))
                try:
                    program = ast.dump(ast.parse(changed))
                except SyntaxError:
                    continue
                if program not in seen:
                    seen.add(program)
                    operator = operator_of(tree, node, other)
                    count[function, operator] += 1
                    key = f"{function or 'module'}: {operator} #{count[function, operator]}"
                    yield places[node].start.line, key, text.replace(code, changed, 1)


def inner(node: cst.CSTNode, function: str = "") -> Iterator[tuple[str, cst.CSTNode]]:
    """Yield the node and all below it but words, each with the innermost function or class that holds it."""
    if not m.matches(node, WORDS | CHECK):
        if isinstance(node, cst.FunctionDef | cst.ClassDef):
            function = node.name.value
        yield function, node
        for child in node.children:
            yield from inner(child, function)


def operator_of(tree: cst.Module, node: cst.CSTNode, other: cst.CSTNode) -> str:
    """Return what was changed without the names of variables: "< → <=", "8 → 7", "if True", "no statement"."""
    match node, other:
        case cst.IfExp(), cst.IfExp(cst.BooleanOperation(operator=cst.Or())):
            return "if True"
        case cst.IfExp(), cst.IfExp(cst.BooleanOperation(operator=cst.And())):
            return "if False"
        case (cst.If() | cst.CompIf(), _):
            return f"if {tree.code_for_node(other.test).strip('()')}"
        case cst.SimpleStatementLine(), _:
            return "no statement"
        case ((cst.FunctionDef() | cst.ClassDef()), _):
            return "no decorator"
        case cst.UnaryOperation(operator), _:
            return f"no {tree.code_for_node(operator).strip()}"
        case cst.Call(cst.Name(called), [_]), cst.CSTNode() if called in NEEDLESS:
            return f"no {called}"
        case cst.Call(_, args), cst.Call(_, fewer) if len(fewer) < len(args):
            lost = next((a for a, b in zip(args, fewer) if a is not b), args[-1])
            return f"no {lost.keyword.value}=" if lost.keyword else "no last argument"
        case cst.BooleanOperation() | cst.BinaryOperation() | cst.ComparisonTarget() | cst.AugAssign(), _ if type(
            node
        ) is type(other):
            node, other = node.operator, other.operator
    was, now = (" ".join(tree.code_for_node(n).split()) for n in (node, other))
    simple = all(
        re.fullmatch(r"[^\w\s]+|(not )?(and|or|in|is|is not|not|break|continue|True|False)|\(?-?[\d.e+-]+\)?|\w+", x)
        for x in (was, now)
    )
    names = not isinstance(node, cst.Name) or node.value in TWINS or was in ("True", "False", "None")
    return f"{was} → {now}" if simple and names else f"{type(node).__name__} → {type(other).__name__}"


# -- the judging -----------------------------------------------------------------------------------


class Sown(SourceFileLoader):
    """Imports one module of satviz from other source."""

    def __init__(self, path: Path, source: str):
        self.source = source
        super().__init__(".".join(path.relative_to(ROOT.parent).with_suffix("").parts), str(path))

    def find_spec(self, name: str, path: object = None, target: object = None):
        return spec_from_file_location(name, self.path, loader=self) if name == self.name else None

    def get_code(self, name: str):
        return compile(self.source, self.path, "exec")


class Watch:
    """Keeps to the quick tests, puts likely killers first, stops one that runs away, and writes down who killed."""

    def __init__(self, out: Path, kills: Counter, likely: Counter, times: dict[str, float]):
        self.out, self.kills, self.likely, self.times, self.found = out, kills, likely, times, {}
        self.engine, self.begun = "numpy", time.process_time()

    def pytest_collection_modifyitems(self, items: list) -> None:
        for module in {item.module for item in items if hasattr(item.module, "ENGINES")}:
            module.ENGINES = [self.engine]  # of those that a test asks in turn
        items[:] = [item for item in items if self.times.get(item.nodeid, 0) < QUICK]
        items.sort(key=lambda i: (-self.likely[i.nodeid], -self.kills[i.nodeid], self.times.get(i.nodeid, 0)))

    def pytest_runtest_setup(self, item) -> None:
        self.note(item.nodeid)
        self.begun = time.process_time()
        signal.setitimer(signal.ITIMER_PROF, 2 + 5 * self.times.get(item.nodeid, 9))  # CPU time of this process
        self.sleep_limit(None)

    def sleep_limit(self, number: int | None, frame: object = None) -> None:
        """Begin to wait, or stop this process if it has slept since the last call: however busy the machine is."""
        worked = time.process_time()
        if number and worked - self.worked < 0.001:
            signal.raise_signal(signal.SIGKILL)
        self.worked = worked
        signal.signal(signal.SIGALRM, self.sleep_limit)
        signal.alarm(SLEEP)

    def pytest_runtest_logreport(self, report) -> None:
        self.found[report.nodeid] = time.process_time() - self.begun
        self.note(report.nodeid)  # here too, or the last test would have no time

    def note(self, test: str) -> None:
        whole = self.out.with_suffix(".new")  # a child that is stopped while it writes leaves the last note whole
        whole.write_text(json.dumps({"at": test, "times": self.found}))
        whole.replace(self.out)


def judge(path: Path, source: str, tests: list[str], about: str, watch: Watch) -> int:
    """Return pytest's exit code in this process, which a signal ends if a test runs too long."""
    import hypothesis
    import numba
    import pytest

    resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
    signal.setitimer(signal.ITIMER_PROF, 8)  # for what comes before the first test
    sys.dont_write_bytecode = True
    sys.meta_path.insert(0, Sown(path, source))
    sys.path.insert(0, str(HERE.parent))
    words = [f"({about})"] if about else []
    if path.parent.name == "with_numba":  # run as Python: to compile them anew would take 17 seconds a mutant
        numba.config.DISABLE_JIT = True
        watch.engine = "numba"
        words += [f"not {word}" for word in ("numpy", "processes", *COMPILED_ONLY)]
    elif "batch" in path.parts:  # NumPy answers, so that nothing need be compiled
        found = importlib.util.find_spec
        importlib.util.find_spec = lambda name, *more: None if name == "numba" else found(name, *more)
        words += ["not numba", "not processes"]  # which would outlive a test that is stopped
    plain = {"derandomize": True, "database": None, "deadline": None, "phases": ["explicit", "generate"]}
    plain["suppress_health_check"] = list(hypothesis.HealthCheck)  # they measure wall time
    hypothesis.settings.register_profile("mutants", **plain)
    hypothesis.settings.load_profile("mutants")
    flags = [
        "-xq",
        "-oaddopts=",
        "--tb=no",
        "--assert=plain",
        "-Wignore",
        "-pno:cacheprovider",
        "-pno:unraisableexception",
    ]
    files = [str(HERE / f"test_{name}.py") for name in tests]
    return int(pytest.main([*flags, "-k", " and ".join(words), "-m", "not slow and not full", *files], plugins=[watch]))


def known(notes: str) -> Iterator[str]:
    """Yield the keys in a module's notes: `orient: > → >= #1 #2, 8 → 7 #1` holds three."""
    for function, changes in re.findall(r"`(\w+): ([^`]+)`", notes):
        for change in changes.split(", "):
            operator, *places = re.split(r" #", change)
            yield from (f"{function}: {operator} #{place}" for place in places)


class Field:
    """One module, its mutants being judged and how many met which fate."""

    def __init__(self, name: str, folder: Path, only_new: bool = False):
        self.only_new = only_new  # those listed as equivalent are counted and not judged
        self.path, self.tests, self.folder = ROOT / f"{name}.py", TESTS[name], folder
        self.about = ABOUT.get(name, "")
        self.running: dict[int, tuple[int, str]] = {}
        self.score, self.kills, self.times = Counter(), Counter(), {}
        self.kills_in: defaultdict[str, Counter] = defaultdict(Counter)  # of a function's mutants
        notes = (HERE / "mutants.md").read_text(encoding="utf-8")
        of_this = re.search(rf"^## {name}$(.*?)(^## |\Z)", notes, re.M | re.S)
        self.known = set(known(of_this[1] if of_this else ""))

    def start(self, line: int, key: str, source: str) -> None:
        sys.stdout.flush()
        if pid := os.fork():
            self.running[pid] = line, key
            return
        code, sink = 3, os.open(os.devnull, os.O_WRONLY)
        os.dup2(sink, 1), os.dup2(sink, 2)
        try:
            likely = self.kills_in[key.partition(":")[0]]
            watch = Watch(self.folder / str(os.getpid()), self.kills, likely, self.times)
            code = judge(self.path, source, self.tests, self.about, watch)
        finally:
            os._exit(code)

    def end(self) -> dict:
        """Wait for any; a mutant on no line is none."""
        pid, status = os.wait()
        line, key = self.running.pop(pid)
        note = self.folder / str(pid)
        report = json.loads(note.read_text()) if note.exists() else {"at": "", "times": {}}
        code = os.waitstatus_to_exitcode(status)
        fate = "timed out" if code < 0 else "killed" if code else "equivalent" if key in self.known else "survived"
        assert line or not code, f"{report['at'] or self.tests} fails without any mutant"
        if line:
            self.kills[report["at"]] += bool(code)
            self.kills_in[key.partition(":")[0]][report["at"]] += bool(code)
            self.score[fate] += 1
            if fate == "survived":
                print(f"line {line}: {key}", flush=True)
            elif code and key in self.known:
                print(f"line {line}: {key} is listed as equivalent, but {fate}", flush=True)
        return report

    def sow(self, functions: list[str], most: int) -> None:
        """Judge every mutant, or a sample of so many, of some functions only if any are named, after none at all."""
        self.start(0, "", self.path.read_text(encoding="utf-8"))
        self.times = self.end()["times"]
        every = [*mutants(self.path)]
        for key in sorted(self.known - {key for _, key, _ in every}):
            print(f"{key} is listed, but there is no such mutant", flush=True)
        wanted = [mutant for mutant in every if not functions or mutant[1].partition(":")[0] in functions]
        for mutant in Random(1).sample(wanted, min(most, len(wanted))):
            if self.only_new and mutant[1] in self.known:
                self.score["equivalent"] += 1
                continue
            self.start(*mutant)
            if len(self.running) == AT_ONCE:
                self.end()
        while self.running:
            self.end()


def main(*names: str) -> None:
    os.environ |= {"PYTEST_DISABLE_PLUGIN_AUTOLOAD": "1", "OPENBLAS_NUM_THREADS": "1", "MPLBACKEND": "agg"}
    for name in LOADED_ONCE:
        importlib.import_module(name)
    gc.freeze()
    rows = ["| module | mutants | " + " | ".join(FATES) + " |", "|---|--:|--:|--:|--:|--:|"]
    with tempfile.TemporaryDirectory() as folder:
        for name in [name for name in names if name != "--new"] or TESTS:
            name, functions, most = re.fullmatch(r"([^:~]+)(?::([\w,]+))?(?:~(\d+))?", name).groups()
            print(f"## {name}", flush=True)
            field = Field(name, Path(folder), "--new" in names)
            field.sow(functions.split(",") if functions else [], int(most or sys.maxsize))
            counts = field.score.total(), *(field.score[fate] for fate in FATES)
            rows.append(f"| {name} | {' | '.join(map(str, counts))} |")
    print("", *rows, sep="\n")


if __name__ == "__main__":
    main(*sys.argv[1:])

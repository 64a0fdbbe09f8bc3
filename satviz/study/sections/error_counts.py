"""Counts of wrong answers: every method on pairs of every kind of hardness, and a summary of each method.

`speed_against_accuracy` and `errors_by_margin` draw these counts by the relative margin: how far the deciding number is
from 0, in rounding errors.
"""

from functools import partial
from typing import Any

import numpy as np

from ..harness.cells import JsonRow, Settings
from ..harness.timings import time_jobs
from ..methods import all_methods, answers_by_method, count_mistakes, true_relations, wrong_answers
from ..workloads.generators import ngons
from ..workloads.hard_pairs import (
    EXTREME_KIND,
    HARD_KINDS,
    MARGIN_OCTAVES,
    HardKind,
    hard_pairs,
    octave_of,
    touching_triangles,
)

ALL_KINDS = (*HARD_KINDS, EXTREME_KIND)
EVERY_MARGIN = 2.0 ** (max(MARGIN_OCTAVES) - 1)  # a method that is wrong beyond this is wrong at any relative margin

# lanes of a chart, for methods that a relative margin cannot rank
NONE_WRONG = "none wrong in this sample"
EXACT_BY_CONSTRUCTION = "exact by construction"
WRONG_AT_ANY_DISTANCE = "wrong at any distance"
FIXED_TOLERANCE = "fixed tolerance"  # a tolerance is a length, and a relative margin is none


def count_errors_by_margin(kind: int, per_octave: int, settings: Settings) -> list[JsonRow]:
    """Return each method's wrong answers on pairs of one kind, by octave, and their largest margin.

    `kind`: its number in `ALL_KINDS`.
    """
    a, b, margin = hard_pairs(ALL_KINDS[kind], settings.rng("hard", ALL_KINDS[kind].name), per_octave)
    right, bins = true_relations(a, b), np.clip(octave_of(margin) - MARGIN_OCTAVES.start, 0, len(MARGIN_OCTAVES) - 1)
    rows = []
    for method, answers in answers_by_method(all_methods(), a, b):
        wrong = wrong_answers(answers, right)
        row: JsonRow = {"kind": ALL_KINDS[kind].name, "language": method.language, "method": method.name}
        row |= {"family": method.family, "pairs": len(a), "wrong": int(wrong.sum())}
        row["relative_margin"] = float(max(margin[wrong], default=0))
        row["pairs_by_octave"] = np.bincount(bins, minlength=len(MARGIN_OCTAVES)).tolist()
        row["wrong_by_octave"] = np.bincount(bins[wrong], minlength=len(MARGIN_OCTAVES)).tolist()
        rows.append(row)
    return rows


def count_errors(work: str, n: int, settings: Settings) -> list[JsonRow]:
    """Return for each method its wrong answers on n pairs, by kind of mistake; `work`: "touching" or "ordinary"."""
    rng = settings.rng(work)
    a, b = touching_triangles(rng, n) if work == "touching" else _ordinary_pairs(rng, n)
    right, rows = true_relations(a, b), []
    for method, answers in answers_by_method(all_methods(), a, b):
        wrong = count_mistakes(answers, right)
        row = {"language": method.language, "method": method.name, "pairs": n, "wrong": sum(wrong.values()), **wrong}
        rows.append(row)
    return rows


def _ordinary_pairs(rng: np.random.Generator, n: int) -> tuple[Any, Any]:
    """Return n pairs of random 4-gons."""
    return ngons(rng, n, 4, 1.2), ngons(rng, n, 4, 1.2)


def take_times(pairs: dict[str, int], rounds: int, settings: Settings) -> list[JsonRow]:
    """Return each method's ns per ordinary, prepared pair; `pairs`: the number of pairs by language."""
    rows = []
    for language, n in pairs.items():
        a, b = _ordinary_pairs(settings.rng("times"), n)
        methods = {method.name: method for method in all_methods() if method.language == language}
        jobs = {name: partial(method.hits, method.prepare(a), method.prepare(b)) for name, method in methods.items()}
        for name, times in time_jobs(jobs, rounds, dict.fromkeys(jobs, n)).items():
            rows.append({"language": language, "method": name, **times})
    return rows


def method_summaries(found: dict[str, Any]) -> list[JsonRow]:
    """Return a row for each method: its errors, the largest relative margin among them, and its time.

    Extreme sizes are counted apart.  `lane`: empty where the largest margin of this sample ranks the method.
    """
    ordinary, touching, times = (
        {method_key(row): row for row in found[name]}
        for name in ("count-ordinary", "count-touching", "resolution-times")
    )
    hard = [row for kind in HARD_KINDS for row in found[cell_name(kind)]]
    extreme = {method_key(row): row for row in found[cell_name(EXTREME_KIND)]}
    # the octaves at both ends hold pairs that rounding has moved out of the others
    by_octave = np.sum([found[cell_name(kind)][0]["pairs_by_octave"] for kind in HARD_KINDS], axis=0)[2:-1]
    summaries = []
    for key in dict.fromkeys(map(method_key, hard)):
        own = [row for row in hard if method_key(row) == key]
        row = {"language": key[0], "method": key[1], "family": own[0]["family"]}
        row["relative_margin"] = max(row["relative_margin"] for row in own)
        row |= {"pairs": sum(row["pairs"] for row in own), "wrong": sum(row["wrong"] for row in own)}
        row["least_an_octave"] = int(by_octave.min())
        for name, counts in ("touching", touching[key]), ("ordinary", ordinary[key]), ("extreme", extreme[key]):
            row |= {name: counts["pairs"], f"{name}_wrong": counts["wrong"]}
        row["lane"] = _lane_of(row)
        summaries.append({**row, **{k: round(times[key][k], 3) for k in ("ns", "ns_low", "ns_high")}})
    return summaries


def _lane_of(row: JsonRow) -> str:
    """Return the lane of a method's summary, or an empty string where its relative margin ranks the method."""
    if row["relative_margin"] > EVERY_MARGIN:
        return WRONG_AT_ANY_DISTANCE
    if row["family"] == "tolerance":
        return FIXED_TOLERANCE
    if row["wrong"] or row["touching_wrong"]:
        return ""
    return EXACT_BY_CONSTRUCTION if row["family"] == "exact" else NONE_WRONG


def method_key(row: JsonRow) -> tuple[str, str]:
    """Return (language, name) of the method that a row is about."""
    return row["language"], row["method"]


def cell_name(kind: HardKind) -> str:
    """Return the name of the cell that counts the errors on one kind of hard pairs."""
    return f"hard-{kind.name.replace(' ', '-')}"

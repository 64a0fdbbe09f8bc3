"""What was wrong: each method on pairs of every kind of hardness, by gamma, and a row a method of that."""

from functools import partial
from typing import Any

import numpy as np

from ..harness.cells import Settings
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

Row = dict[str, Any]
MethodKey = tuple[str, str]  # language, name
EVERY_MARGIN = 2.0 ** (max(MARGIN_OCTAVES) - 1)  # wrong up to here is wrong at any gamma
ALL_KINDS = (*HARD_KINDS, EXTREME_KIND)
NONE_WRONG, EXACT_BY_CONSTRUCTION, WRONG_AT_ANY_DISTANCE = (
    "none wrong in this sample",
    "exact by construction",
    "wrong at any distance",
)
FIXED_TOLERANCE = "fixed tolerance"  # a length, which gamma does not measure


def count_errors_by_margin(kind: int, each: int, settings: Settings) -> list[Row]:
    """Each method on one kind: how many pairs of each octave of gamma were wrong, and the largest gamma of those."""
    a, b, gamma = hard_pairs(ALL_KINDS[kind], settings.rng("hard", ALL_KINDS[kind].name), each)
    right, bins = true_relations(a, b), np.clip(octave_of(gamma) - MARGIN_OCTAVES.start, 0, len(MARGIN_OCTAVES) - 1)
    rows = []
    for method, said in answers_by_method(all_methods(), a, b):
        bad = wrong_answers(said, right)
        row: Row = {"kind": ALL_KINDS[kind].name, "language": method.language, "method": method.name}
        row |= {
            "family": method.family,
            "pairs": len(a),
            "wrong": int(bad.sum()),
            "gamma": float(max(gamma[bad], default=0)),
        }
        row["pairs_by_octave"] = np.bincount(bins, minlength=len(MARGIN_OCTAVES)).tolist()
        row["wrong_by_octave"] = np.bincount(bins[bad], minlength=len(MARGIN_OCTAVES)).tolist()
        rows.append(row)
    return rows


def count_errors(work: str, n: int, settings: Settings) -> list[Row]:
    """Each method on exactly touching or on ordinary pairs."""
    rng = settings.rng(work)
    a, b = touching_triangles(rng, n) if work == "touching" else _ordinary(rng, n)
    right, rows = true_relations(a, b), []
    for method, said in answers_by_method(all_methods(), a, b):
        found = count_mistakes(said, right)
        row = {"language": method.language, "method": method.name, "pairs": n, "wrong": sum(found.values()), **found}
        rows.append(row)
    return rows


def _ordinary(rng: np.random.Generator, n: int) -> tuple[Any, Any]:
    return ngons(rng, n, 4, 1.2), ngons(rng, n, 4, 1.2)


def take_times(sizes: dict[str, int], rounds: int, settings: Settings) -> list[Row]:
    """Nanoseconds a pair of ordinary 4-gons that are ready, in turn within each round, language by language."""
    rows = []
    for language, n in sizes.items():
        a, b = _ordinary(settings.rng("times"), n)
        mine = {m.name: m for m in all_methods() if m.language == language}
        jobs = {name: partial(m.hits, m.prepare(a), m.prepare(b)) for name, m in mine.items()}
        for name, times in time_jobs(jobs, rounds, dict.fromkeys(jobs, n)).items():
            rows.append({"language": language, "method": name, **times})
    return rows


def method_summaries(found: dict[str, Any]) -> list[Row]:
    """A row a method: the largest gamma wrong over all kinds but the extreme sizes, these counted apart, and its time.

    `lane`: empty where the largest gamma of this sample ranks the method.
    """
    ordinary, touches, times = (
        {method_key(row): row for row in found[name]}
        for name in ("count-ordinary", "count-touching", "resolution-times")
    )
    counted = [row for kind in HARD_KINDS for row in found[cell_name(kind)]]
    extremes = {method_key(row): row for row in found[cell_name(EXTREME_KIND)]}
    each = np.sum([found[cell_name(kind)][0]["pairs_by_octave"] for kind in HARD_KINDS], axis=0)[2:-1]
    made = []
    for key in dict.fromkeys(map(method_key, counted)):
        mine = [row for row in counted if method_key(row) == key]
        gamma = max(row["gamma"] for row in mine)
        touch, plain, time, extreme = touches[key], ordinary[key], times[key], extremes[key]
        bad = sum(row["wrong"] for row in mine)
        row = {"language": key[0], "method": key[1], "family": mine[0]["family"], "gamma": gamma}
        row |= {"pairs": sum(row["pairs"] for row in mine), "wrong": bad, "least_an_octave": int(each.min())}
        row |= {"touching": touch["pairs"], "touching_wrong": touch["wrong"]}
        row |= {"ordinary": plain["pairs"], "ordinary_wrong": plain["wrong"]}
        row |= {"extreme": extreme["pairs"], "extreme_wrong": extreme["wrong"]}
        row["lane"] = _lane_of(row)
        made.append({**row, **{k: round(time[k], 3) for k in ("ns", "ns_low", "ns_high")}})
    return made


def _lane_of(row: Row) -> str:
    if row["gamma"] > EVERY_MARGIN:
        return WRONG_AT_ANY_DISTANCE
    if row["family"] == "tolerance":
        return FIXED_TOLERANCE
    if row["wrong"] or row["touching_wrong"]:
        return ""
    return EXACT_BY_CONSTRUCTION if row["family"] == "exact" else NONE_WRONG


def method_key(row: Row) -> MethodKey:
    """Which method a row is of."""
    return row["language"], row["method"]


def cell_name(kind: HardKind) -> str:
    """The name of the cell that counts on a kind."""
    return f"hard-{kind.name.replace(' ', '-')}"

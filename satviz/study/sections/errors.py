"""What was wrong: each method on pairs of every kind of hardness, by gamma, and a row a method of that."""

from functools import partial
from typing import Any

import numpy as np

from ..harness.cells import Settings
from ..harness.times import timed
from ..methods import asked, methods, mistakes, truths, wrong
from ..workloads.hard import EXTREME, KINDS, OCTAVES, Kind, hard, octave, touching
from ..workloads.workloads import ngons

Row = dict[str, Any]
Key = tuple[str, str]  # language, name
ANY = 2.0 ** (max(OCTAVES) - 1)  # wrong up to here is wrong at any gamma
EVERY = (*KINDS, EXTREME)
NEVER, PROVED, LOOSE = "none wrong in this sample", "exact by construction", "wrong at any distance"
FIXED = "fixed tolerance"  # a length, which gamma does not measure


def count_hard(kind: int, each: int, settings: Settings) -> list[Row]:
    """Each method on one kind: how many pairs of each octave of gamma were wrong, and the largest gamma of those."""
    a, b, gamma = hard(EVERY[kind], settings.rng("hard", EVERY[kind].name), each)
    right, bins = truths(a, b), np.clip(octave(gamma) - OCTAVES.start, 0, len(OCTAVES) - 1)
    rows = []
    for method, said in asked(methods(), a, b):
        bad = wrong(said, right)
        row: Row = {"kind": EVERY[kind].name, "language": method.language, "method": method.name}
        row |= {
            "family": method.family,
            "pairs": len(a),
            "wrong": int(bad.sum()),
            "gamma": float(max(gamma[bad], default=0)),
        }
        row["pairs_by_octave"] = np.bincount(bins, minlength=len(OCTAVES)).tolist()
        row["wrong_by_octave"] = np.bincount(bins[bad], minlength=len(OCTAVES)).tolist()
        rows.append(row)
    return rows


def count(work: str, n: int, settings: Settings) -> list[Row]:
    """Each method on exactly touching or on ordinary pairs."""
    rng = settings.rng(work)
    a, b = touching(rng, n) if work == "touching" else _ordinary(rng, n)
    right, rows = truths(a, b), []
    for method, said in asked(methods(), a, b):
        found = mistakes(said, right)
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
        mine = {m.name: m for m in methods() if m.language == language}
        jobs = {name: partial(m.hits, m.prepare(a), m.prepare(b)) for name, m in mine.items()}
        for name, times in timed(jobs, rounds, dict.fromkeys(jobs, n)).items():
            rows.append({"language": language, "method": name, **times})
    return rows


def rows(found: dict[str, Any]) -> list[Row]:
    """A row a method: the largest gamma wrong over all kinds but the extreme sizes, these counted apart, and its time.

    `lane`: empty where the largest gamma of this sample ranks the method.
    """
    ordinary, touches, times = (
        {key_of(row): row for row in found[name]} for name in ("count-ordinary", "count-touching", "resolution-times")
    )
    counted = [row for kind in KINDS for row in found[cell_of(kind)]]
    extremes = {key_of(row): row for row in found[cell_of(EXTREME)]}
    each = np.sum([found[cell_of(kind)][0]["pairs_by_octave"] for kind in KINDS], axis=0)[2:-1]
    made = []
    for key in dict.fromkeys(map(key_of, counted)):
        mine = [row for row in counted if key_of(row) == key]
        gamma = max(row["gamma"] for row in mine)
        touch, plain, time, extreme = touches[key], ordinary[key], times[key], extremes[key]
        bad = sum(row["wrong"] for row in mine)
        row = {"language": key[0], "method": key[1], "family": mine[0]["family"], "gamma": gamma}
        row |= {"pairs": sum(row["pairs"] for row in mine), "wrong": bad, "least_an_octave": int(each.min())}
        row |= {"touching": touch["pairs"], "touching_wrong": touch["wrong"]}
        row |= {"ordinary": plain["pairs"], "ordinary_wrong": plain["wrong"]}
        row |= {"extreme": extreme["pairs"], "extreme_wrong": extreme["wrong"]}
        row["lane"] = _lane(row)
        made.append({**row, **{k: round(time[k], 3) for k in ("ns", "ns_low", "ns_high")}})
    return made


def _lane(row: Row) -> str:
    if row["gamma"] > ANY:
        return LOOSE
    if row["family"] == "tolerance":
        return FIXED
    if row["wrong"] or row["touching_wrong"]:
        return ""
    return PROVED if row["family"] == "exact" else NEVER


def key_of(row: Row) -> Key:
    """Which method a row is of."""
    return row["language"], row["method"]


def cell_of(kind: Kind) -> str:
    """The name of the cell that counts on a kind."""
    return f"hard-{kind.name.replace(' ', '-')}"

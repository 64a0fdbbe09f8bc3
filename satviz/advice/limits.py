"""Limits on the work of `sv.advise`: work is counted before it is done, so that the answer takes seconds at most."""

from ..engine.geometry import InvalidScene

# Two cores take some 5 us and 300 bytes a pair of triangles: 10 s and 600 MB for the most.
MAX_PAIRS = 2_000_000
# An edge against a corner, in each direction: 18 for two triangles.
MAX_TESTS = 60_000_000
# Pairs that need fractions, because arrays of floats cannot decide them: up to 1 ms each.
MAX_PAIRS_BY_FRACTIONS = 20_000
# Above this number of tests two shapes are classified with arrays, which are then faster than fractions.
TESTS_BY_FRACTIONS = 2_000
# `check()` uses fractions for every test: some 30 us each.
MAX_TESTS_CHECKED = 500_000
# Timing: seconds for all models of a scene, and tests in one timed call (some 50 ms).
SECONDS_TIMED = 1.0
TESTS_TIMED = 400_000


def refuse_too_many_tests(pairs: int, tests: int) -> None:
    """Raise InvalidScene for too many `pairs` of convex parts, or too many `tests` of an edge against a corner."""
    for many, most, what in (
        (pairs, MAX_PAIRS, "pairs of convex parts"),
        (tests, MAX_TESTS, "tests of an edge against a corner"),
    ):
        if many > most:
            raise InvalidScene(
                f"advise would test {many:,} {what}: the limit is {most:,}; give fewer or simpler shapes, or "
                "only some of the pairs (pairs=)"
            )


def refuse_too_many_boxes(pairs: int, shapes: int) -> None:
    """Raise InvalidScene for too many pairs of shapes whose boxes meet; `pairs`: those found so far."""
    if pairs > MAX_PAIRS:
        raise InvalidScene(
            f"more than {MAX_PAIRS:,} pairs of {shapes:,} shapes have bounding boxes that meet: this is the limit of "
            "advise; give fewer shapes, or only some of the pairs (pairs=)"
        )


def refuse_too_many_fractions(decided: int, undecided: int) -> None:
    """Raise InvalidScene if `decided` pairs, those decided with fractions so far, reach MAX_PAIRS_BY_FRACTIONS.

    undecided: how many pairs need fractions, for the message.
    """
    if decided >= MAX_PAIRS_BY_FRACTIONS:
        raise InvalidScene(
            f"{undecided:,} pairs of convex parts are so near to touching, or of such different sizes, that only "
            f"fractions, which are slow, can decide them: the limit is {MAX_PAIRS_BY_FRACTIONS:,}; give fewer or "
            "simpler shapes"
        )

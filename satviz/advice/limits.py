"""How much work `sv.advise` takes on: counted before it is done, so that the answer comes in seconds or not at all."""

from ..engine.geometry import InvalidScene

# Two cores take some 5 us and 300 bytes a pair of triangles: 10 s and 600 MB for the most.
MAX_PAIRS = 2_000_000
# An edge against a corner, in each direction: 18 for two triangles.
MAX_TESTS = 60_000_000
# Pairs that arrays cannot tell and fractions can: up to 1 ms each.
MAX_PAIRS_BY_FRACTIONS = 20_000
# Two shapes that take more tests are looked at with arrays, which is quicker from here on.
TESTS_BY_FRACTIONS = 2_000
# `check()` takes fractions for every test: some 30 us each.
MAX_TESTS_CHECKED = 500_000
# Prices: how long they are measured for a scene, and how many tests one call makes (some 50 ms).
SECONDS_TIMED = 1.0
TESTS_TIMED = 400_000


def refuse_too_many_tests(pairs: int, tests: int) -> None:
    """InvalidScene for more pairs of convex parts, or more tests of an edge against a corner, than are taken on."""
    for many, most, what in (
        (pairs, MAX_PAIRS, "pairs of convex parts"),
        (tests, MAX_TESTS, "tests of an edge against a corner"),
    ):
        if many > most:
            raise InvalidScene(
                f"advise would look at {many:,} {what}: the limit is {most:,}; give fewer or simpler shapes, or "
                "some of the pairs by pairs="
            )


def refuse_too_many_boxes(pairs: int, shapes: int) -> None:
    """InvalidScene for more pairs of shapes whose boxes meet than are taken on; `pairs`: counted so far."""
    if pairs > MAX_PAIRS:
        raise InvalidScene(
            f"more than {MAX_PAIRS:,} pairs of the bounding boxes of {shapes:,} shapes meet, which is the most that "
            "advise looks at: give fewer shapes, or some of the pairs by pairs="
        )


def refuse_too_many_fractions(asked: int, doubtful: int) -> None:
    """InvalidScene once so many of the doubtful pairs have been asked of fractions."""
    if asked >= MAX_PAIRS_BY_FRACTIONS:
        raise InvalidScene(
            f"{doubtful:,} pairs of convex parts are so near to touching, or of such different sizes, that fractions "
            f"must tell them: advise asks at most {MAX_PAIRS_BY_FRACTIONS:,}; give fewer or simpler shapes"
        )

"""Continuity, the order of axes, what optimisations save and what the engine does not do: counts, never times."""

import json
import pickle
from concurrent.futures import ThreadPoolExecutor
from itertools import combinations

import pytest
from matplotlib.text import Text

from satviz.engine.axes import NAMED, needed
from satviz.pictures import THEMES
from satviz.study import continuity, cost, doing_less, moving, optimisations
from satviz.study.cells import Settings
from satviz.study.chart import TEXT

pytestmark = pytest.mark.slow

SEED = 3
ROUNDING = 1e-14  # a gap's worst: 27 roundings of 2**-53 at a reach of about 4
CASES = {cost._slug(case): case for case in optimisations.cases()}
COUNTED = [slug for slug, case in CASES.items() if case.counted]


@pytest.fixture(scope="module")
def results():
    """Every cell's result on few pairs; the times are made up, so that a reading can be held to them."""
    found = {f"doing-no-more-{doing_less._slug(kind)}": doing_less.counted(kind, 30, SEED) for kind in doing_less.KINDS}
    for scene, hits in continuity.SCENES:
        for move in continuity.MOVES:
            found[continuity._name(scene, hits, move)] = continuity.jumps(scene, hits, move, 120, SEED)
    found["moving-scene"] = moving.followed(4, 60, SEED)
    for i, slug in enumerate(CASES):
        times = {"median": 100.0, "least": 90.0, "low": 95.0, "high": 105.0}
        left = {key: value * (0.35 + 0.07 * i) for key, value in times.items()}
        found[f"cost-time-{slug}"] = {"pairs": 10, "setup": 2000.0, "without": times, "optimised": left}
        if slug in COUNTED:
            found[f"cost-count-{slug}"] = cost.count(slug, True, SEED)
    return json.loads(json.dumps(found, allow_nan=False))


@pytest.fixture(scope="module")
def charts(results):
    return {chart.stem: chart for part in (continuity, moving, cost, doing_less) for chart in part.charts(results)}


def rows(results, *words):
    return [row for name, found in results.items() if name.startswith(words) for row in found]


def test_the_engines_choice_and_all_axes_and_rationals_give_one_relation(results):
    for kind in doing_less.KINDS:
        found = results[f"doing-no-more-{doing_less._slug(kind)}"]
        assert found["equal"] == found["pairs"], kind
        assert found["tested"] <= found["chosen"] <= found["all"], kind
    assert sum(row["touching"] for name, row in results.items() if name.startswith("doing-no-more")) > 5


def test_a_choice_that_is_not_enough_would_show(monkeypatch):
    monkeypatch.setattr(doing_less, "all_axes", NAMED["edge-normals-of-b"])
    found = doing_less.counted("triangles", 30, SEED)
    assert found["equal"] < found["pairs"]


@pytest.mark.parametrize(
    "kind, every, chosen",
    [
        ("upright boxes", 8, 2),
        ("boxes, same orientation", 8, 2),
        ("boxes, other orientation", 8, 4),
        ("circles", 1, 1),
        ("triangles", 6, 6),
        ("regular 8-gons, same turn", 16, 4),
        ("regular 8-gons, other turn", 16, 8),
        ("regular 5-gons, same turn", 10, 5),
        ("box and concave L", 16, 4),
    ],
)
def test_the_engine_tests_as_many_axes_as_the_kind_of_pair_needs(results, kind, every, chosen):
    found = results[f"doing-no-more-{doing_less._slug(kind)}"]
    assert (found["all"], found["chosen"]) == (every, chosen)


def test_depth_and_distance_never_move_further_than_the_vertex(results):
    exact = [row for row in rows(results, "continuity") if row["quantity"] in ("depth", "distance")]
    assert len(exact) == len(continuity.SCENES) * len(continuity.MOVES)
    assert all(row["beyond"] <= ROUNDING and row["torn"] == 0 for row in exact)


def test_shortcuts_are_torn_where_the_engine_is_not(results):
    def torn(quantity, scene):
        found = [r for r in rows(results, "continuity") if (r["quantity"], r["scene"]) == (quantity, scene)]
        return sum(row["torn"] for row in found)

    assert torn("MTV", continuity.LEVEL) == 0 < torn("MTV, sign from centers", continuity.LEVEL)
    assert torn("MTV", "needles") == 0 < torn("MTV, raw normals", "needles")
    about = "first axis about to separate"
    assert torn("best gap", about) == 0 < torn("gap at early exit", about)
    assert torn("MTV", continuity.TIED) > 0  # where two ways out are equally short no MTV can be stable


def test_the_order_of_axes_never_changes_a_verdict(results):
    found = results["moving-scene"]
    for name, order in found["orders"].items():
        assert order["equal"] == found["frames"], name
        assert 0 < order["apart"] < found["frames"], name


def test_a_warm_start_tests_fewer_axes_while_apart_and_all_of_them_in_a_hit(results):
    found = results["moving-scene"]
    warm, given = (found["orders"][name]["tested_apart"] for name in (moving.WARM, moving.GIVEN))
    assert warm < given
    hits = [row for row in found["first"] if not row["apart"]]
    assert hits and all(row[name] == 16 for row in hits for name in moving.ORDERS)


def test_the_last_axis_comes_first_and_none_is_lost():
    a, b = next(moving.passing(Settings(seed=SEED).rng("order"), 2))
    axes = needed(a, b).axes
    for axis in axes:
        ordered = moving.last_first(axes, axis.source)
        assert ordered[0] == axis and sorted(ordered) == sorted(axes)
    assert moving.last_first(axes, None) == axes


@pytest.mark.parametrize("slug", COUNTED)
def test_dot_products_are_saved_where_an_optimisation_helps_and_nowhere_else(results, slug):
    found = results[f"cost-count-{slug}"]
    assert (found["optimised"] < found["without"]) is CASES[slug].helps


def test_counts_are_the_same_on_a_rerun_with_the_same_seed(results):
    slug = "order-along-the-centers-triangles-apart"
    assert cost.count(slug, True, SEED) == results[f"cost-count-{slug}"] != cost.count(slug, True, SEED + 1)
    assert doing_less.counted("triangles", 30, SEED) == results["doing-no-more-triangles"]
    assert continuity.jumps("needles", True, "1e-9", 120, SEED) == results["continuity-hits-needles-1e-9"]
    assert moving.followed(4, 60, SEED) == results["moving-scene"]


@pytest.mark.parametrize("slug", ["early-exit-8-gons-apart", "2-threads-NumPy-500-triangles"])
def test_times_are_taken_with_their_spread_and_the_set_up_apart(slug):
    found = json.loads(json.dumps(cost.take_times(slug, True, SEED, 2), allow_nan=False))
    assert found["pairs"] > 0 and found["setup"] > 0
    for name in "without", "optimised":
        assert 0 < found[name]["least"] <= found[name]["low"] <= found[name]["median"] <= found[name]["high"]


@pytest.mark.parametrize("slug", [slug for slug, case in CASES.items() if not case.counted and "numba" not in slug])
def test_the_threads_of_a_case_end_with_it(slug, monkeypatch):
    pools = []

    class Pool(ThreadPoolExecutor):
        def __init__(self, *args):
            super().__init__(*args)
            pools.append(self)

    monkeypatch.setattr(optimisations, "ThreadPoolExecutor", Pool)
    monkeypatch.setattr(optimisations.Case, "sizes", (20, 20))
    cost.take_times(slug, True, SEED, 1)
    assert len(pools) == 1
    with pytest.raises(RuntimeError, match="after shutdown"):
        pools[0].submit(print)


def test_cells_can_be_sent_away_and_have_names_of_their_own():
    for settings in Settings(), Settings(quick=True):
        cells = [cell for part in (continuity, moving, cost, doing_less) for cell in part.cells(settings)]
        assert pickle.loads(pickle.dumps(cells)) == cells
        assert len({cell.name for cell in cells}) == len(cells)
        assert {cell.name.startswith("cost-time") for cell in cells if cell.timed} == {True}


def test_readings_tell_the_numbers_of_the_rows(charts):
    def tells(stem, *words):
        assert [word for word in words if word not in charts[stem].reading] == [], charts[stem].reading

    found = {row["kind"]: row for row in charts["doing-no-more"].rows}
    pairs = f"{sum(row['equal'] for row in found.values()):,} of {sum(row['pairs'] for row in found.values()):,} pairs"
    tells("doing-no-more", "4 of 16", f"{found['boxes, one rounded angle']['chosen']:.1f} of 8", pairs)

    orders = {row["order"]: row for row in charts["moving-scene"].rows if "order" in row}
    tells(
        "moving-scene",
        *(f"{orders[name][key]:.2f}" for name in (moving.GIVEN, moving.WARM) for key in ("mean_apart", "mean")),
    )

    tied = [row for row in charts["continuity"].rows if (row["scene"], row["quantity"]) == (continuity.TIED, "MTV")]
    tells("continuity", f"{sum(row['torn'] for row in tied)} of {sum(row['pairs'] for row in tied)} steps")

    of = charts["cost-of-optimisations"].rows
    best = min((row for row in of if "dots_ratio" in row), key=lambda row: row["dots_ratio"])
    slower = [row for row in of if row["time_low"] > 1]
    assert slower
    tells(
        "cost-of-optimisations",
        f"{best['dots_ratio']:.1%}",
        *(f"{row['scene']} {row['time_ratio']:.0%}" for row in slower),
    )


def drawn_texts(fig):
    """Every label of a figure; ticks beyond the view are not drawn."""
    yield from fig.texts
    for ax in fig.axes:
        yield from (child for child in ax.get_children() if isinstance(child, Text))
        for axis in (ax.xaxis, ax.yaxis) if ax.axison else ():
            low, high = sorted(axis.get_view_interval())
            ticks = zip(axis.get_ticklocs(), axis.get_ticklabels(), strict=True)
            yield from (axis.label, *(label for at, label in ticks if low <= at <= high))


@pytest.mark.parametrize("theme", THEMES.values(), ids=THEMES)
@pytest.mark.parametrize("stem", ["continuity", "moving-scene", "cost-of-optimisations", "doing-no-more"])
def test_no_label_of_a_chart_covers_another_or_leaves_it(charts, stem, theme):
    fig = charts[stem].figure(theme)
    fig.draw_without_rendering()
    renderer = fig.canvas.get_renderer()
    texts = [text for text in drawn_texts(fig) if text.get_text().strip()]
    assert len(texts) > 15 and all(text.get_fontsize() >= TEXT for text in texts)
    boxes = [text.get_window_extent(renderer) for text in texts]
    for text, box in zip(texts, boxes, strict=True):
        assert fig.bbox.x0 <= box.x0 and box.x1 <= fig.bbox.x1 and fig.bbox.y0 <= box.y0 and box.y1 <= fig.bbox.y1, text
    for (one, p), (other, q) in combinations(zip(texts, boxes, strict=True), 2):
        over = min(min(p.x1, q.x1) - max(p.x0, q.x0), min(p.y1, q.y1) - max(p.y0, q.y0))
        assert over <= 1, (one.get_text(), other.get_text())

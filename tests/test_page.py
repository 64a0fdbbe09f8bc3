"""The page to share: one file, the same bytes each time, nothing from anywhere else, words that cannot run."""

import json
import re
import shutil
import subprocess
from importlib.resources import files
from pathlib import Path

import pytest
from speeds import one_in

import satviz as sv
from satviz.pictures import playback as module
from satviz.pictures.playback import playback, playbacks
from satviz.render import script as script_module
from satviz.render.script import javascript
from satviz.scenes.article import SCENES

TRIANGLES = sv.scene("triangles").record()


def data_of(page):
    return json.loads(re.search(r'id="satviz-show">(.*?)</script>', page, re.DOTALL)[1])["shows"]


def with_styles(data, marks):
    return [mark | {"style": data["styles"][mark["style"]]} for mark in marks]


@pytest.fixture(scope="module")
def triangles():
    return sv.page(TRIANGLES)


def test_a_page_of_two_triangles_is_small_and_the_same_each_time(triangles):
    assert triangles == sv.page(sv.Trace.from_json(TRIANGLES.to_json()))
    assert len(triangles.encode()) <= 250_000


@pytest.mark.parametrize("scene", one_in(3, SCENES), ids=lambda scene: scene.name)
def test_a_page_to_share_loads_nothing_from_another_server(scene):
    page = sv.page(scene.record(), title=scene.title)
    assert re.findall(r"https?://[^\s\"'<]+", page.replace("http://www.w3.org/", "")) == []
    assert "default-src 'none'" in page and 'src="' not in page and "@import" not in page


@pytest.mark.parametrize("name", ["explore", "play", "arrows", "../../site/browser/site"])
def test_a_script_is_one_module_without_comments_in_which_each_name_is_declared_once(name, monkeypatch):
    script = javascript(name)
    assert not re.search(r"^import |^export (?!default)|/\*\*|^ *//|^ ", script, re.MULTILINE)
    assert not any(line.count("`") % 2 for line in script.splitlines())  # a string of two lines would lose its indent
    monkeypatch.setattr(
        script_module, "_INDENT", re.compile("(?!)")
    )  # what is indented is not declared at the top level
    indented = javascript.__wrapped__(name)
    names = re.findall(r"^(?:async )?(?:class|const|function|let) (\w+)", indented, re.MULTILINE)
    assert len(names) > 1 and len(set(names)) == len(names)


def test_a_script_has_each_file_once_after_the_files_that_it_imports():
    script = javascript("player", "arrows")
    assert script.count("class Pen {") == 1
    assert script.index("function element(") < script.index("class Pen {") < script.index("class Player {")


def test_style_sheets_write_text_decoration_only_as_webkit_reads_it():
    """WebKit ignores `text-decoration` with more than a line, and reads `text-decoration-style`."""
    for sheet in Path(sv.__file__).parent.rglob("*.css"):
        for said in re.findall(r"text-decoration:\s*([^;}]*)", sheet.read_text(encoding="utf-8")):
            assert said.strip() in ("none", "underline"), sheet.name


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.name)
def test_a_playback_holds_every_step_as_it_is_drawn(scene):
    trace = scene.record()
    found = playback(trace)
    assert len(found["steps"]) == len(sv.steps(trace))
    for i, step in enumerate(found["steps"]):
        drawn = sv.picture(trace, i)
        marks = [found["marks"][m] for m in step["marks"]]
        assert with_styles(found, marks) == with_styles(drawn.data(), drawn.data()["marks"])
        assert (step["sentence"], step["limits"]) == (drawn.sentence, list(drawn.limits))


def test_without_a_script_the_page_has_two_pictures_the_table_and_every_sentence(triangles):
    static = triangles.split('class="sv-static"')[1].split("</section>")[0]
    assert static.count("<svg") == 2 and "normal of B&#x27;s edge v1v3" in static
    for i in range(len(sv.steps(TRIANGLES))):
        assert sv.picture(TRIANGLES, i).sentence.replace("'", "&#x27;") in static


def test_labels_are_text_wherever_they_stand():
    evil = '</script><script>alert(1)</script><img src=x onerror=alert(2)>"&$_'
    a = sv.Polygon([(0, 0), (1, 0), (0, 1)], [evil, "b", "c"])
    page = sv.page(sv.record(a, sv.Circle((3, 3), 1)), title=evil)
    assert "<script>alert" not in page and "<img" not in page
    assert page.count("</script>") == 2
    assert any(evil[:8] in mark.get("text", "") for mark in data_of(page)[0]["marks"])


def test_axes_that_the_early_exit_left_out_are_on_the_page_too():
    early, whole = playbacks(TRIANGLES)
    assert [row.get("number") for row in early["rows"]] == [1, 2, None, None, None, None]
    assert [row["number"] for row in whole["rows"]] == [1, 2, 3, 4, 5, 6]
    assert len(playbacks(TRIANGLES.without_early_exit())) == 1
    hit = sv.record(TRIANGLES.a, TRIANGLES.a)
    assert len(playbacks(hit)) == 1


def test_the_marked_line_of_the_algorithm_fits_the_step():
    found = playback(TRIANGLES)
    last_gap = [s for s in found["steps"] if s["stage"] == "gap"][-1]
    assert [found["code"][i].strip() for i in last_gap["code"]] == [
        "if the ranges leave a gap:",
        "stop: the shapes are apart",
    ]
    hit = playback(sv.record(TRIANGLES.a, TRIANGLES.a))
    assert found["code"][-1] == hit["code"][hit["steps"][-1]["code"][0]] == "no axis left: the shapes collide"
    unsure = playback(sv.record(TRIANGLES.a, TRIANGLES.b, axes=sv.axes.edge_normals_of_a))
    assert "no proof" in unsure["code"][-1]


@pytest.mark.parametrize("scene", SCENES, ids=lambda scene: scene.name)
def test_a_step_of_a_test_lights_the_row_of_that_test(scene):
    trace = scene.record().without_early_exit()
    found = playback(trace)
    for step, there in zip(found["steps"], sv.steps(trace), strict=True):
        assert (step["row"] is None) is (there.test is None)
        if there.test is not None:
            run = trace.pairs[there.pair] if trace.pairs else trace
            row = found["rows"][step["row"]]
            assert row["number"] == there.test + 1 and row["gap"] == run.tests[there.test].gap
            assert row["pair"] == (f"{run.names.a} and {run.names.b}" if trace.pairs else "")


def test_all_axes_parallel_to_one_axis_share_one_row_of_the_page():
    found = playback(sv.scene("concave").record())
    assert [row["reason"] for row in found["rows"] if row["pair"] == "A and B1" and "reason" in row] == [
        "early exit: axis 1 separates",
        "parallel to axis 1",
        "parallel to axis 2",
    ]


@pytest.mark.parametrize("every_axis", [False, True])
@pytest.mark.parametrize("move", [0, -1])
def test_the_algorithm_for_concave_shapes_goes_through_the_pairs_of_their_parts(move, every_axis):
    notch = sv.Polygon([(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)])
    block = sv.Polygon([(2.5 + move, 2.5), (3.5 + move, 2.5), (3.5 + move, 3.5), (2.5 + move, 3.5)])
    found = playback(sv.record(block, notch, every_axis=every_axis))
    assert found["code"][0] == "for each pair of convex parts:" and found["code"][1] == "    for each axis to test:"
    *_, last_gap, verdict = ([found["code"][i].strip() for i in step["code"]] for step in found["steps"])
    assert ("these two are apart: on to the next pair" in last_gap) is (move == 0)
    expected = "no pair left: the shapes are apart" if move == 0 else "no axis left: stop, the shapes collide"
    assert verdict == [expected]


def test_too_many_steps_are_thinned_then_refused(monkeypatch):
    monkeypatch.setattr(module, "MAX_STEPS", 10)
    assert [s["stage"] for s in playback(TRIANGLES)["steps"]] == ["scene", "gap", "gap", "verdict"]
    monkeypatch.setattr(module, "MAX_STEPS", 3)
    with pytest.raises(ValueError, match="too many"):
        playback(TRIANGLES)


def test_a_page_with_predict_folds_the_answer_on_paper_and_without_scripts(triangles):
    asks = sv.page("triangles", predict=True)
    section = asks[asks.index('<section class="sv-static">') : asks.index("</section>")]
    open_part, folded, rest = section.partition("<details><summary>The answer</summary>")
    assert folded and rest.rstrip().endswith("</details>") and open_part.count("<svg") == 1 == rest.count("<svg")
    assert "1.213" not in open_part and "1.213" in rest
    assert "<details><summary>The answer" not in triangles


@pytest.mark.skipif(shutil.which("node") is None, reason="no node is installed")
def test_a_widget_that_has_left_the_page_is_not_kept_for_its_arrow_keys(tmp_path):
    """The site makes a new widget for each link that is opened in one page."""
    source = files("satviz").joinpath("render/browser/arrows.js").read_text()
    script = """
    globalThis.document = { body: {}, addEventListener: (_, listener) => { globalThis.press = listener; } };
    globalThis.innerHeight = 100;
    const asked = [];
    const widget = (name) => ({ keyPressed: () => asked.push(`key to ${name}`), root: {
      isConnected: true, addEventListener: () => {}, checkVisibility: () => true,
      getBoundingClientRect: () => (asked.push(name), { top: 0, bottom: 50 }) } });
    const [first, second] = ["first", "second"].map(widget);
    arrowKeys(first);
    first.root.isConnected = false;
    arrowKeys(second);
    press({ target: document.body, key: "ArrowLeft" });
    console.log(JSON.stringify([...new Set(asked)]));
    """
    program = tmp_path / "arrows.mjs"
    program.write_text(source + script)
    done = subprocess.run(["node", program], capture_output=True, text=True, check=True)
    assert json.loads(done.stdout) == ["second", "key to second"]

"""The walkthrough runs from top to bottom and shows what stands in it."""

import ast
import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from xml.etree import ElementTree

import pytest

import satviz as sv

NEEDED = "nbval", "nbformat", "ipykernel", "ipywidgets", "anywidget"  # found here, imported where they are used
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not all(map(find_spec, NEEDED)), reason=f"the walkthrough needs {', '.join(NEEDED)}"),
]

FOLDER = Path(__file__).parent.parent / "notebooks"
CHAPTERS = sorted(path.name for path in FOLDER.glob("*.ipynb"))
MOST_BYTES = 400_000

# a picture's bytes depend on matplotlib's version, its sentence does not
SANITIZE = "[picture]\nregex: (?s)<svg.*</svg>\nreplace: SVG\n"


def read(chapter):
    import nbformat

    return nbformat.read(FOLDER / chapter, as_version=4)


def code_cells(notebook):
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def prose(notebook):
    return "\n\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")


def cells_that_differ(folder, notebooks):
    """Run copies of the notebooks; return nbval's messages about cells that failed or differ, by name and cell id."""
    import nbformat

    for name, notebook in notebooks.items():
        nbformat.write(notebook, folder / name)
    (folder / "sanitize.cfg").write_text(SANITIZE)
    (folder / "pytest.ini").write_text("[pytest]\n")
    options = ["--nbval", "--nbval-current-env", "--nbval-sanitize-with=sanitize.cfg", "--nbval-cell-timeout=60"]
    command = [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", *options, "--junitxml=report.xml"]
    run = subprocess.run([*command, *notebooks], cwd=folder, capture_output=True, text=True, timeout=600)
    cells = {(name, f"Cell {i}"): cell.id for name in notebooks for i, cell in enumerate(code_cells(notebooks[name]))}
    report = ElementTree.parse(folder / "report.xml")
    cases = {(case.get("classname"), case.get("name")): case for case in report.iter("testcase")}
    assert cases.keys() == cells.keys(), run.stdout[-3000:]
    differ = {name: {} for name in notebooks}
    for (name, cell), case in cases.items():
        if texts := [found.text for found in case if found.tag in ("failure", "error")]:
            differ[name][cells[name, cell]] = "\n".join(texts)
    return differ


def with_numbers_changed(notebook):
    """Change the first shown digit of each cell and return the ids of these cells."""
    changed = set()
    for cell in code_cells(notebook):
        if "nbval-ignore-output" in cell.metadata.get("tags", ()):
            continue
        for output in cell.outputs:
            where, key = (output, "text") if output.output_type == "stream" else (output.data, "text/plain")
            shown = where.get(key, "")
            where[key] = re.sub(r"\d", lambda digit: str((int(digit[0]) + 1) % 10), shown, count=1)
            if where[key] != shown:
                changed.add(cell.id)
                break
    return changed


def test_the_chapters_are_numbered_from_1_without_a_gap():
    assert [name[0] for name in CHAPTERS] == [str(i + 1) for i in range(len(CHAPTERS))] and len(CHAPTERS) >= 6


@pytest.fixture(scope="module")
def differ(tmp_path_factory):
    """Return what `cells_that_differ` does of all chapters: nbval takes long to start."""
    return cells_that_differ(tmp_path_factory.mktemp("chapters"), {chapter: read(chapter) for chapter in CHAPTERS})


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_running_a_chapter_again_gives_its_stored_outputs(differ, chapter):
    assert differ[chapter] == {}, "\n".join(differ[chapter].values())


# Two of them show that nbval compares what a cell shows; the next test says that no cell of the others is left out.
SOME = [chapter if i % 4 == 0 else pytest.param(chapter, marks=pytest.mark.full) for i, chapter in enumerate(CHAPTERS)]


@pytest.mark.parametrize("chapter", SOME)
def test_a_changed_number_is_noticed_in_every_cell_that_shows_one(chapter, tmp_path):
    altered = read(chapter)
    changed = with_numbers_changed(altered)
    assert len(changed) >= 5 and cells_that_differ(tmp_path, {chapter: altered})[chapter].keys() == changed


def test_every_output_but_measured_times_is_compared():
    """Tags mark these outputs; no other mark of nbval may leave a cell out."""
    tags = {
        chapter: [tag for cell in code_cells(read(chapter)) for tag in cell.metadata.get("tags", ())]
        for chapter in CHAPTERS
    }
    assert {tag for found in tags.values() for tag in found} == {"nbval-ignore-output"}
    assert {chapter[0]: len(found) for chapter, found in tags.items() if found} == {"5": 2}
    assert not re.search(
        r"^#\s*(NBVAL|PYTEST_VALIDATE)", "\n".join(c.source for n in CHAPTERS for c in code_cells(read(n))), re.M
    )


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_a_chapter_is_committed_with_its_outputs_below_its_size_limit_and_without_metadata(chapter):
    import nbformat

    notebook, text = read(chapter), (FOLDER / chapter).read_text(encoding="utf-8")
    nbformat.validate(notebook)
    cells = code_cells(notebook)
    assert [cell.execution_count for cell in cells] == list(range(1, len(cells) + 1))
    assert not [output for cell in cells for output in cell.outputs if output.output_type == "error"]
    assert len(text.encode()) <= MOST_BYTES
    assert set(notebook.metadata) == {"kernelspec"} and notebook.metadata.kernelspec.display_name == "Python 3"
    assert "application/vnd.jupyter.widget" not in text
    shown = [
        part
        for cell in cells
        for output in cell.outputs
        for part in output.get("data", {"text": output.get("text")}).items()
    ]
    words = [cell.source for cell in notebook.cells] + [part for kind, part in shown if kind in ("text", "text/plain")]
    assert not re.findall(r"/tmp|/home/|/root/|/Users/|[A-Z]:\\", "\n".join(words))
    ids = [cell.id for cell in notebook.cells]
    assert ids == [f"ch{chapter[0]}-{i:02d}" for i in range(1, len(ids) + 1)]


STATELESS = "--ExecutePreprocessor.store_widget_state=False"  # as the guide says


@pytest.mark.parametrize("route", ["run for the page", "saved"])
def test_in_an_exported_page_a_widget_is_its_picture(browser, tmp_path, route):
    """It needs no network, also if JupyterLab saved the notebook with widgets in its outputs but not their state."""
    import nbformat

    calls = "sv.explore('circles')", "sv.play('circles')", "sv.play('circles', pen='matplotlib')"
    cells = [nbformat.v4.new_code_cell(f"import satviz as sv\n{call}") for call in calls]
    nbformat.write(nbformat.v4.new_notebook(cells=cells), tmp_path / "copy.ipynb")

    def convert(*options):
        command = [sys.executable, "-m", "nbconvert", *options, "copy.ipynb"]
        subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, timeout=120)

    if route == "saved":
        convert("--to", "notebook", "--execute", STATELESS, "--inplace")
        assert (tmp_path / "copy.ipynb").read_text().count("application/vnd.jupyter.widget-view+json") == len(calls)
        convert("--to", "html")
    else:
        convert("--to", "html", "--execute", STATELESS)
    context = browser.new_context(offline=True)
    page = context.new_page()
    page.goto((tmp_path / "copy.html").as_uri())
    said = sv.scene("circles").record().sentence
    shown = page.locator(".jp-OutputArea-output img").all()
    assert [image.get_attribute("alt") for image in shown] == [said] * len(calls)
    assert all(image.evaluate("image => image.naturalWidth > 100 && image.offsetHeight > 100") for image in shown)
    assert STATELESS in (FOLDER.parent / "satviz" / "guides" / "notebook.md").read_text(encoding="utf-8")
    context.close()


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_links_of_a_chapter_lead_to_files_and_to_the_chapters_beside_it(chapter):
    notebook_words = re.sub(r"<!--.*?-->", "", prose(read(chapter)), flags=re.DOTALL)  # comments are for the site
    links = re.findall(r"\]\(([^)#]+)\)", notebook_words)
    assert links and not [link for link in links if "://" not in link and not (FOLDER / link).is_file()]
    neighbours = {CHAPTERS[i] for i in (int(chapter[0]) - 2, int(chapter[0])) if 0 <= i < len(CHAPTERS)}
    first, *_, last = [cell.source for cell in read(chapter).cells]
    for neighbour in neighbours:
        assert f"({neighbour})" in first and f"({neighbour})" in last


@pytest.mark.parametrize("chapter", CHAPTERS)
def test_each_solution_prints_the_value_that_it_states(chapter):
    """A solution's last words, `# value`, are what the expression before them gives."""
    notebook = read(chapter)
    exercises = re.split(r"^\*\*\d\.\*\* ", prose(notebook).split("## Exercises")[1], flags=re.MULTILINE)[1:]
    assert len(exercises) in (2, 3)
    names = {}
    for cell in code_cells(notebook):
        if "nbval-ignore-output" not in cell.metadata.get("tags", ()):
            exec(compile(cell.source, cell.id, "exec"), names)
    for exercise in exercises:
        assert exercise.count("<details><summary>Solution</summary>") == exercise.count("</details>") == 1
        for block in re.findall(r"^```python\n(.*?)^```$", exercise, re.MULTILINE | re.DOTALL):
            lines = block.splitlines()
            for statement in ast.parse(block).body:
                source = "\n".join(lines[statement.lineno - 1 : statement.end_lineno])
                if not isinstance(statement, ast.Expr):
                    exec(source, names)
                    continue
                after = lines[statement.end_lineno - 1][statement.end_col_offset :].split("# ")[1:]
                below = lines[statement.end_lineno] if statement.end_lineno < len(lines) else ""
                claim = after[0] if after else below.removeprefix("# ")
                assert repr(eval(source, names)) == claim.strip(), source

"""The reference has every public name, and its examples were run."""

import re
import warnings

import pytest

import satviz as sv
from satviz.cli import main

pytest.importorskip("pdoc", reason="the reference needs pdoc: python -m pip install '.[docs]'")

from satviz.site.examples import EXAMPLES
from satviz.site.reference import reference, run_example


@pytest.fixture(scope="module")
def pages():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        return {name: data.decode() for name, data in reference()}


def test_every_public_name_has_a_reference_page(pages):
    for page, names in (
        ("satviz.html", set(sv.__all__) - {"__version__", "axes", "batch", "testing"}),
        ("satviz/batch.html", sv.batch.__all__),
        ("satviz/testing.html", sv.testing.__all__),
        ("satviz/engine/axes.html", sv.axes.__all__),
        ("satviz/testing.html", sv.testing.__all__),
    ):
        ids = set(re.findall(r'<section id="([^"]+)"', pages[page]))
        assert set(names) <= ids, page
    links = {name: set(re.findall(r'<li><a href="([^"#]+)"', page)) for name, page in pages.items()}
    assert links["satviz.html"] >= {"satviz/batch.html", "satviz/engine/axes.html", "satviz/testing.html"}


def test_every_example_is_shown_in_the_reference(pages):
    shown = sum(page.count('<div class="example">') for name, page in pages.items() if name.endswith(".html"))
    assert shown == len(EXAMPLES)


@pytest.mark.parametrize("name", EXAMPLES)
def test_every_example_prints_a_result_without_an_address_in_memory(name):
    text, _ = run_example(EXAMPLES[name])
    assert text.strip() and " at 0x" not in text


def test_the_reference_loads_nothing_from_the_network(pages):
    for page in pages.values():
        assert not re.findall(r'(?:src|href)="(?:https?:)?//(?!pdoc\.dev")', page)
        assert not re.findall(r"url\(['\"]?(?:https?:)?//|@import", page)


def test_a_page_of_a_site_links_back_to_the_site_and_a_page_by_itself_does_not(pages):
    in_site = {name: data.decode() for name, data in reference(in_site=True)}
    for name, way in ("satviz.html", "../"), ("satviz/batch.html", "../../"), ("satviz/engine/axes.html", "../../../"):
        link = f'href="{way}index.html">Back to'
        assert link in in_site[name] and link not in pages[name]


@pytest.mark.slow
def test_the_command_overwrites_a_reference_that_it_made_and_nothing_else(tmp_path, capsys):
    out = tmp_path / "pages"
    for _ in range(2):
        assert main(["reference", "--out", str(out)]) == 0
    assert "index.html" in capsys.readouterr().out
    (out / "satviz.html").write_text("mine")
    assert main(["reference", "--out", str(out)]) == 2
    assert (out / "satviz.html").read_text() == "mine"
    assert "was not made by satviz" in capsys.readouterr().err

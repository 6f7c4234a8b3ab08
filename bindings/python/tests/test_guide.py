"""Execution of the Python programs of the guide, and their places on the pages of the site."""

import importlib.util
import pathlib

import pytest
from test_examples import run

import stickslip as ss

SITE = pathlib.Path(__file__).parents[3] / "docs" / "site"
PAGES = sorted(file.stem for file in (SITE / "python").glob("*.py"))


def pages():
    found = importlib.util.spec_from_file_location("pages", SITE / "pages.py")
    module = importlib.util.module_from_spec(found)
    found.loader.exec_module(module)
    return module


@pytest.mark.parametrize("name", PAGES)
def test_guide_programs_run(name, tmp_path):
    # The measured surface of the page on rough surfaces: a slightly rough ball.
    grid = ss.Grid.square(512, 500e-6)
    rough = ss.surface.SelfAffine(rms_height=1e-8, cut_off_wavelength=20e-6, seed=0).generate(grid)
    ss.io.sdf.write(tmp_path / "surface.sdf", rough.heights - ss.surface.sphere(grid, 10e-3), unit="m")
    for index, program in enumerate(pages().programs(f"guide/{name}")):
        file = tmp_path / f"{name}_{index}.py"
        file.write_text(program)
        run([str(file)], tmp_path)


@pytest.mark.parametrize("name", PAGES)
def test_guide_page_has_python_after_rust(name, tmp_path):
    of_site = pages()
    programs = of_site.programs(f"guide/{name}")
    page = of_site.included(tmp_path, f"guide/{name}", f"src/guide/{name}.md")
    assert programs and page.count("```rust\n") == len(programs) == page.count("In Python:")
    assert all(f"```\n\nIn Python:\n\n```python\n{program}\n```" in page for program in programs)
    assert "followed by the same program in Python" in page

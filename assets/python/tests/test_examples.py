"""The examples of the manual's page and of the package's own run, in a folder with the files that they name."""

from __future__ import annotations

import re
import shutil
from dataclasses import fields
from pathlib import Path

import pytest

import inbetween_animator as ia
from conftest import ASSETS, GRADING, WALK, Says

PAGES = [ASSETS / "manual/python.md", ASSETS / "python/README.md"]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_examples_run(page: Path, says: Says, capsys: pytest.CaptureFixture[str]) -> None:
    shutil.copy(WALK, "walk.json")
    shutil.copy(GRADING / "reference.json", "reference.json")
    shutil.copy(GRADING / "rubric.toml", "rubric.toml")
    shutil.copy(GRADING / "hotkeys.txt", "hotkeys.txt")
    says("convert", WALK, "-o", "student.txt")
    Path("broken.txt").write_text("0 0 0 1 0 0 0\n1 2 three 1 0 0 0\n")
    Path("class/ann").mkdir(parents=True)
    shutil.copy(WALK, "class/ann/animation.json")
    shutil.make_archive("submissions", "zip", "class")
    Path("roster.csv").write_text("name,id,section\nAnn,7,A\n")
    blocks = re.findall(r"^```python\n(.*?)^```$", page.read_text(), re.MULTILINE | re.DOTALL)
    assert blocks
    names: dict[str, object] = {}
    for block in blocks:
        exec(compile(block, page.name, "exec"), names)
    if page.name == "python.md":
        told = capsys.readouterr().out
        assert "ann  " in told and "No samples show linear playback" in told
        assert "turns fastest at" in told and "FirstExceeded(key_time=" in told
        assert "broken.txt | line 2 column 5 | broken.txt: line 2 column 5: " in told
        assert Path("walk.png").exists() and not Path("out.json").exists()


def test_the_page_names_every_function_and_field() -> None:
    page = PAGES[0].read_text()
    functions = {name for name in ia.__all__ if name[0].islower()}
    for name in functions:
        assert f"`{name}(" in page, name
    for field in ("times", "key_times", "nodes", "positions", "rotations", "matrices", "speeds", "angular_speeds"):
        assert f"\n| `{field}` |" in page, field
    for field in ("message", "path", "place", "exit_status", "problems"):
        assert f"\n| `{field}` |" in page, field


def test_the_page_names_every_field_of_results() -> None:
    page = PAGES[0].read_text()
    for kind in (ia.Grades, ia.Submission, ia.Item, ia.Shown, ia.Difference, ia.Deviation, ia.Diagnosis, ia.Conversion, ia.Finding):
        for field in fields(kind):
            assert f"`{field.name}`" in page, f"{kind.__name__}.{field.name}"


def test_everything_that_is_public_is_described() -> None:
    for name in ia.__all__:
        thing = getattr(ia, name)
        assert thing.__doc__ and not thing.__doc__.startswith(f"{name}("), name
        if name[0].islower() and thing is not ia.program:
            assert "Args:" in thing.__doc__ and "Raises:" in thing.__doc__, name

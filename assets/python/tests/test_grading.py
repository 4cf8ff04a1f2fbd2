"""A class of three is graded: the marks are those of grades.json, and follow from what was handed in."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from xml.etree import ElementTree

import pytest

import inbetween_animator as ia
from conftest import DIAGNOSIS, GRADING, Says

REFERENCE = GRADING / "reference.json"


@pytest.fixture
def classroom(says: Says) -> Path:
    """Ann hands in all that is right, Bo keyframes alone, Cy a text that is broken."""
    folder = Path("class")
    (folder / "ann").mkdir(parents=True)
    (folder / "bo").mkdir()
    (folder / "cy").mkdir()
    shutil.copy(REFERENCE, folder / "ann/animation.json")
    for interpolation in ("linear", "catmull-rom"):
        output = folder / "ann" / f"{interpolation}.csv"
        says("sample", REFERENCE, "--fps", 30, "--interpolation", interpolation, "-o", output)
    shutil.copy(REFERENCE, folder / "bo/animation.json")
    (folder / "cy/animation.txt").write_text("1 2 3 what\n")
    return folder


def test_marks_follow_from_what_was_handed_in(classroom: Path) -> None:
    grades = ia.grade(GRADING / "rubric.toml", classroom, "results", images=0)
    assert [submission.name for submission in grades] == ["ann", "bo", "cy"] and len(grades) == 3
    ann, bo, cy = grades.submissions
    assert (ann["linear_playback"].points, ann["catmull_rom_playback"].points) == (20, 20)
    assert ann["linear_playback"].evidence == "samples"
    assert bo["linear_playback"].points == 0 and bo["readable"].points == 10
    assert (cy.points, cy.keyframe_file) == (0, None)
    assert ann.points > bo.points > cy.points and ann.out_of == 100
    assert grades["bo"] is bo
    for submission in grades:
        assert submission.points == pytest.approx(sum(item.points for item in submission.items))
        assert all(item.reason for item in submission.items if item.points < item.out_of)
    assert {shown.best for shown in ann.samples} == {"correct", "correct-catmull-rom"}
    with pytest.raises(KeyError, match="ann, bo, cy"):
        grades["dee"]
    with pytest.raises(KeyError, match="linear_playback"):
        ann["nothing"]


def test_all_of_grades_json_is_there(classroom: Path) -> None:
    grades = ia.grade(GRADING / "rubric.toml", classroom, "results", images=0)
    assert grades.data == json.loads(Path("results/grades.json").read_text())
    for submission, data in zip(grades, grades.data["submissions"], strict=True):
        assert [vars(item) for item in submission.items] == data["items"]
        for name in ("name", "student", "id", "points", "out_of", "missing", "late", "days_late", "comment", "section"):
            assert getattr(submission, name) == data[name]
    assert grades.title == grades.data["title"]
    assert grades.report == Path("results/report.html") and grades.report.stat().st_size > 10_000


def test_a_class_is_a_table_in_a_notebook(classroom: Path) -> None:
    (classroom / "bo").rename(classroom / "bo & <co>")
    grades = ia.grade(GRADING / "rubric.toml", classroom, "results", images=0)
    table = ElementTree.fromstring(grades._repr_html_())
    head = [cell.text for cell in table.findall("./thead/tr/th")]
    assert head[:2] == ["submission", "points"] and head.count("each_keyframe") == 1
    rows = [[cell.text for cell in row] for row in table.findall("./tbody/tr")]
    assert [row[0] for row in rows] == ["ann", "bo & <co>", "cy"]
    for row, submission in zip(rows, grades, strict=True):
        assert row[1] == f"{submission.points:g} / 100"
        assert sum(float(cell or "nan") for cell in row[2:]) == pytest.approx(submission.points)


def test_options_of_a_course(classroom: Path) -> None:
    Path("roster.csv").write_text("name,id,section\nAnn,7,A\nDee,9,A\n")
    shutil.copy(GRADING / "rubric.toml", "rubric.toml")
    shutil.copy(GRADING / "hotkeys.txt", "hotkeys.txt")
    shutil.copy(REFERENCE, "reference.json")
    Path("overrides.toml").write_text(
        'format = "inbetween.overrides"\nversion = 1\n[students."bo"]\npoints = { script = 5 }\ncomment = "Shown."\n'
    )
    grades = ia.grade(
        "rubric.toml",
        classroom,
        "results",
        images=0,
        roster="roster.csv",
        to=["moodle", "junit"],
        feedback="feedback",
    )
    assert grades["ann"].section == "A" and not grades["ann"].missing
    assert grades["9"].student == "Dee" and grades["Dee"].missing and grades["Dee"].points == 0
    assert grades["bo"]["script"].by_hand and grades["bo"].comment == "Shown."
    assert Path("results/moodle.csv").exists() and Path("results/junit.xml").exists()
    assert Path("feedback/ann.html").exists()
    hidden = ia.grade("rubric.toml", classroom, "hidden", images=0, anonymous=True, key="key.json")
    assert not {"ann", "bo", "cy"} & {submission.name for submission in hidden}
    assert Path("key.json").exists()


def test_several_submissions_are_one_each(classroom: Path) -> None:
    grades = ia.grade(GRADING / "rubric.toml", [classroom / "ann", classroom / "cy"], "results", images=0)
    assert [submission.name for submission in grades] == ["ann", "cy"]


def test_a_mistake_is_named_in_the_marks() -> None:
    name = "lerp-for-slerp"
    (Path("class/eve")).mkdir(parents=True)
    shutil.copy(DIAGNOSIS / f"{name}.json", "reference.json")
    shutil.copy(DIAGNOSIS / f"{name}.json", "class/eve/animation.json")
    shutil.copy(DIAGNOSIS / f"{name}.csv", "class/eve/linear.csv")
    Path("rubric.toml").write_text(
        'format = "inbetween.rubric"\nversion = 1\ntitle = "T"\nreference = "reference.json"\n[points]\nlinear_playback = 20\n'
    )
    (eve,) = ia.grade("rubric.toml", "class", "results", images=0)
    assert eve.points == 0
    assert [(shown.file, shown.explained, shown.best) for shown in eve.samples] == [("linear.csv", True, name)]


def test_bad_rubrics_are_errors(classroom: Path) -> None:
    Path("rubric.toml").write_text("format = 3\n")
    with pytest.raises(ia.InbetweenError) as caught:
        ia.grade("rubric.toml", classroom, "results")
    assert (caught.value.path, caught.value.exit_status) == (Path("rubric.toml"), 1)
    with pytest.raises(ia.InbetweenError) as caught:
        ia.grade(GRADING / "rubric.toml", "no-class", "results", images=0)
    assert caught.value.path == Path("no-class")
    assert not Path("results").exists()


def test_the_report_has_pictures(classroom: Path) -> None:
    shutil.rmtree(classroom / "cy")
    for images in (0, 1):
        grades = ia.grade(GRADING / "rubric.toml", classroom, f"results{images}", images=images, image_size=(60, 45))
        assert ("data:image/" in grades.report.read_text()) == (images > 0)


def test_a_class_is_short_on_a_terminal(classroom: Path) -> None:
    grades = ia.grade(GRADING / "rubric.toml", classroom, "results", images=0)
    lines = str(grades).splitlines()
    assert lines[0] == grades.title and [line.split()[0] for line in lines[1:]] == ["ann", "bo", "cy"]
    assert lines[1].split()[1:] == [f"{grades['ann'].points:g}", "of", "100"]
    assert "reason" not in repr(grades["ann"]) and len(repr(grades["ann"])) < 400

"""A class of submissions, graded by a rubric."""

from __future__ import annotations

import html
import os
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Literal

from ._files import made, with_scene
from ._program import StrPath, argument, options, run_for_json, size_option

Form = Literal["canvas", "moodle", "gradescope", "classroom50", "junit"]


@dataclass(frozen=True)
class Item:
    """What one thing that is graded earned."""

    item: str
    """What: ``readable``, ``keyframe_count``, ``keyframe 0`` and on, ``linear_playback`` and so on."""
    points: float
    """The points that it earned, before lateness."""
    out_of: float
    """The points that the rubric gives."""
    evidence: str | None
    """What the verdict rests on: ``samples``, ``trace``, ``script`` or ``assumed``; None for items about keyframes alone."""
    reason: str
    """Why, in a sentence."""
    by_hand: bool
    """Whether the points are a teacher's."""


@dataclass(frozen=True)
class Shown:
    """What a file of samples shows."""

    file: str
    """Its name in the submission."""
    playback: str
    """``linear`` or ``catmull-rom``."""
    explained: bool
    """Whether ``best`` explains every number."""
    best: str | None
    """The name of the mistake, as :func:`diagnose` gives it."""
    residual: float | None
    """How far the samples are from it."""
    also: tuple[str, ...]
    """Mistakes that explain the samples as well."""
    problem: str | None
    """Why the samples cannot be read."""


@dataclass(frozen=True)
class Submission:
    """The marks of one student. ``submission["linear_playback"]`` is an item."""

    name: str
    """The name of the folder or file that was handed in."""
    student: str | None
    """The student's name, if the name of the file or a roster tells it."""
    id: str | None
    """The student's number in the course system."""
    section: str | None
    """The section on the roster."""
    points: float
    """All points, after lateness."""
    out_of: float
    """The points of the rubric."""
    items: tuple[Item, ...] = field(repr=False)
    """What was graded, in the order of the rubric."""
    samples: tuple[Shown, ...] = field(repr=False)
    """What its samples show, and by which mistake."""
    notes: tuple[str, ...] = field(repr=False)
    """What a grader should know."""
    keyframe_file: str | None
    """The file that the keyframes are from; None if none could be read."""
    missing: bool
    """Whether nothing was handed in."""
    late: bool
    """Whether the course system says that it came late."""
    days_late: int | None
    """How many days late."""
    late_points: float
    """The points that lateness cost."""
    comment: str | None
    """The teacher's."""

    def __getitem__(self, item: str) -> Item:
        for graded in self.items:
            if graded.item == item:
                return graded
        raise KeyError(f"no item {item!r} was graded: {', '.join(graded.item for graded in self.items)}")


@dataclass(frozen=True)
class Grades:
    """A graded class: a list of submissions, shown as a table in a notebook. ``grades["ann"]`` is one, by its name, student or id."""

    title: str
    """That of the rubric."""
    submissions: tuple[Submission, ...]
    """In the order of the tables."""
    passed_over: tuple[tuple[str, str], ...]
    """Entries that are no submissions: their names, and why."""
    not_revealed: tuple[str, ...] = field(repr=False)
    """Known mistakes that the rubric's reference does not reveal."""
    folder: Path
    """Where the results are: ``grades.csv``, ``grades.json``, ``report.html``."""
    data: dict[str, Any] = field(repr=False)
    """All of ``grades.json``."""

    @property
    def report(self) -> Path:
        """The page with reasons and pictures."""
        return self.folder / "report.html"

    def __iter__(self) -> Iterator[Submission]:
        return iter(self.submissions)

    def __len__(self) -> int:
        return len(self.submissions)

    def __getitem__(self, name: str) -> Submission:
        for submission in self.submissions:
            if name in (submission.name, submission.student, submission.id):
                return submission
        raise KeyError(f"no submission is called {name!r}: {', '.join(submission.name for submission in self.submissions)}")

    def __str__(self) -> str:
        width = max((len(submission.name) for submission in self), default=0)
        lines = [f"{submission.name:{width}}  {submission.points:g} of {submission.out_of:g}" for submission in self]
        return "\n".join([self.title, *lines])

    def _repr_html_(self) -> str:
        items = list(dict.fromkeys(_column(item.item) for submission in self for item in submission.items))
        rows = []
        for submission in self:
            sums = {name: (0.0, 0.0) for name in items}
            for item in submission.items:
                points, out_of = sums[_column(item.item)]
                sums[_column(item.item)] = (points + item.points, out_of + item.out_of)
            name = submission.student or submission.name
            cells = [f"{submission.points:g} / {submission.out_of:g}", *(f"{points:g}" for points, _ in sums.values())]
            rows.append(_row("td", [name, *cells]))
        head = _row("th", ["submission", "points", *items])
        title = html.escape(self.title)
        return f"<table><caption>{title}</caption><thead>{head}</thead><tbody>{''.join(rows)}</tbody></table>"


def _column(item: str) -> str:
    """Keyframes share a column."""
    return "each_keyframe" if item.startswith("keyframe ") else item


def _row(tag: str, cells: Sequence[str]) -> str:
    return f"<tr>{''.join(f'<{tag}>{html.escape(cell)}</{tag}>' for cell in cells)}</tr>"


def grade(
    rubric: StrPath,
    submissions: StrPath | Sequence[StrPath],
    output: StrPath,
    *,
    images: int = 8,
    image_size: tuple[int, int] | None = None,
    roster: StrPath | None = None,
    overrides: StrPath | None = None,
    to: Form | Sequence[Form] = (),
    assignment: str | None = None,
    feedback: StrPath | None = None,
    anonymous: bool = False,
    key: StrPath | None = None,
    scene: StrPath | None = None,
    further: Sequence[str] = (),
) -> Grades:
    """Grade submissions by a rubric, and write ``grades.csv``, ``grades.json`` and ``report.html``.

    What is wrong with a submission is in its marks, and no error.

    Args:
        rubric: JSON or TOML, as ``run("grade", "--example", FOLDER)`` writes one.
        submissions: A class: a folder or an archive whose entries are submissions. Or several submissions.
        output: The folder for the results. Files of an earlier run there are replaced.
        images: The most pictures of a submission in the report; 0 draws none, which is faster and needs no GPU adapter.
        image_size: Width and height of a picture in pixels; None is 180 by 135.
        roster: A table of the students of the course. Who handed nothing in gets a row.
        overrides: A teacher's points, in place of ``overrides.toml`` beside the rubric.
        to: Further forms of results for course systems, written into ``output``.
        assignment: With ``canvas``: the column of the assignment, as Canvas names it.
        feedback: A folder for a page for each student.
        anonymous: Numbers in place of names and ids, in everything.
        key: With ``anonymous``: the file that says who each number is.
        scene: A built-in scene or a scene file; None is ``two-robots``.
        further: Other options of ``inbetween grade``, such as ``["--classes"]``.

    Raises:
        InbetweenError: a bad rubric, no submissions, no GPU adapter for the pictures (exit status 3).
    """
    handed_in = [submissions] if isinstance(submissions, (str, os.PathLike)) else list(submissions)
    given = options(
        output=argument(output),
        no_images=images == 0,
        images=images or None,
        image_size=size_option(image_size if images else None),
        roster=roster,
        overrides=overrides,
        assignment=assignment,
        feedback=feedback,
        anonymous=anonymous,
        key=key,
        scene=scene,
    )
    forms = [f"--to={form}" for form in ([to] if isinstance(to, str) else to)]
    arguments = ["grade", argument(rubric), *map(argument, handed_in), "--quiet", "--json", *given, *forms, *further]
    paths = with_scene(scene, rubric, *handed_in, roster, overrides, output)
    data = run_for_json(arguments, paths)
    return Grades(
        title=data["title"],
        submissions=tuple(_submission(submission) for submission in data["submissions"]),
        passed_over=tuple((entry["name"], entry["reason"]) for entry in data["passed_over"]),
        not_revealed=tuple(entry["mistake"] for entry in data["not_revealed"]),
        folder=Path(output),
        data=data,
    )


def _submission(data: dict[str, Any]) -> Submission:
    items = tuple(made(Item, item) for item in data["items"])
    samples = tuple(made(Shown, shown, also=tuple(shown["also"])) for shown in data["samples"])
    return made(Submission, data, items=items, samples=samples, notes=tuple(data["notes"]))

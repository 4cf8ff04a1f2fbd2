"""Keyframes from one form to another, and what is wrong with them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any, Literal, TypeVar

from ._motion import Interpolation
from ._program import StrPath, argument, options, run_for_bytes, run_for_json

Layout = Literal[
    "header",
    "header-two-lines",
    "header-keyframe-a-line",
    "header-quaternion-first",
    "rows",
    "frames",
    "end",
    "csv",
    "pairs",
    "endless",
]

_T = TypeVar("_T")


def made(kind: type[_T], values: Mapping[str, Any], **others: Any) -> _T:
    """A dataclass of the fields of a JSON object. Fields that it does not know are left out, so that later programs can be read."""
    own = {field.name: values[field.name] for field in fields(kind) if field.name not in others}  # type: ignore[arg-type]
    return kind(**own, **others)


def with_scene(scene: StrPath | None, *paths: StrPath | None) -> list[StrPath]:
    """The files that problems may be about."""
    return [path for path in (*paths, scene) if path is not None]


@dataclass(frozen=True)
class Finding:
    """One thing that was inferred from a text."""

    certainty: str
    """``sure``, ``likely``, ``warning`` (a person should check it) or ``note``."""
    text: str
    """What was inferred, and from what."""


@dataclass(frozen=True)
class Conversion:
    """What :func:`convert` read and wrote."""

    output: Path
    """The file that was written."""
    summary: str
    """What was read, such as ``6 keyframes of 22 nodes, layout rows``."""
    findings: tuple[Finding, ...]
    """What was inferred, and how sure that is."""

    def __str__(self) -> str:
        return "\n".join([self.summary, *(f"{finding.certainty}: {finding.text}" for finding in self.findings)])


def convert(
    path: StrPath,
    output: StrPath,
    *,
    to: Layout | None = None,
    exact: bool = False,
    order: Literal["translation-first", "quaternion-first"] | None = None,
    joints: StrPath | None = None,
    salvage: bool = False,
    group: int | None = None,
    overwrite: bool = False,
    scene: StrPath | None = None,
) -> Conversion:
    """Read keyframes in any layout that students' own programs write, and write a keyframe file or another layout.

    Args:
        path: A keyframe file, a text of numbers, CSV, or a Python program with keys, which is not run.
        output: The file to write. Its ending tells the layout: ``.csv``, ``.txt`` (with a header), else a keyframe file.
        to: The layout, in place of the ending's.
        exact: In a text, write enough digits to read back the same values; otherwise six.
        order: The order of a row's numbers, in place of the inferred one.
        joints: A file with the path of a node for each row of a keyframe, a line each; ``-`` marks a row that is not used.
        salvage: Take the whole keyframes of a text that breaks off or disagrees with its header.
        group: Which group of keys of a Python program to read, from 1.
        overwrite: Write ``output`` also where it is ``path``.
        scene: A built-in scene or a scene file; None is ``two-robots``.

    Raises:
        InbetweenError: the text cannot be read, with line and column.

    Warns:
        InbetweenWarning: what was inferred needs a person's eye.
    """
    given = options(
        output=argument(output),
        to=to,
        exact=exact,
        order=order,
        joints=None if joints is None else argument(joints),
        salvage=salvage,
        group=group,
        overwrite=overwrite,
        scene=scene,
    )
    arguments = ["convert", argument(path), "--quiet", "--json", *given]
    read = run_for_json(arguments, with_scene(scene, path, output, joints))
    findings = tuple(made(Finding, finding) for finding in read["findings"])
    return Conversion(Path(output), read["summary"], findings)


@dataclass(frozen=True)
class Deviation:
    """How far translations or rotations of a node are apart: in scene units or in degrees."""

    largest: float
    """The largest difference of all frames."""
    largest_at: float
    """The key time of the first animation at which it is."""
    rms: float
    """The root mean square over all frames."""
    exceeds_at: float | None
    """The key time at which the tolerance is first exceeded; None if it never is."""


@dataclass(frozen=True)
class NodeDifference:
    """How far one node is apart in two animations."""

    node: str
    """Its path in the scene."""
    translation: Deviation
    """In scene units."""
    rotation: Deviation
    """In degrees."""


@dataclass(frozen=True)
class FirstExceeded:
    """What is first beyond its tolerance."""

    key_time: float
    """When, as a key time of the first animation."""
    node: str
    """The node's path."""
    part: str
    """``translation`` or ``rotation``."""


@dataclass(frozen=True)
class Difference:
    """How two animations differ as they play."""

    within_tolerance: bool
    """Whether they are equal within the tolerances, and of one length."""
    first_exceeded: FirstExceeded | None
    """What is first beyond its tolerance."""
    frames: int
    """The number of moments that were compared."""
    notes: tuple[str, ...]
    """What else differs: sentences."""
    nodes: tuple[NodeDifference, ...]
    """Each node, in the order of poses."""

    def __getitem__(self, node: str) -> NodeDifference:
        for difference in self.nodes:
            if difference.node == node:
                return difference
        raise KeyError(f"there is no node {node!r}")


def diff(
    a: StrPath,
    b: StrPath,
    *,
    tolerance_translation: float = 0.001,
    tolerance_rotation: float = 0.1,
    fps: int = 60,
    interpolation: Interpolation | None = None,
    scene: StrPath | None = None,
) -> Difference:
    """Compare two animations node by node at the same moments, as each plays.

    Args:
        a: Keyframes: the reference, say.
        b: Keyframes to compare them with.
        tolerance_translation: In scene units.
        tolerance_rotation: In degrees.
        fps: Frames a second to compare, 1 to 1000; the end is always compared.
        interpolation: For both, in place of the files'.
        scene: A built-in scene or a scene file; None is ``two-robots``.

    Raises:
        InbetweenError: a file cannot be read (exit status 2). That they differ is a result, and no error.
    """
    given = options(
        tolerance_translation=float(tolerance_translation),
        tolerance_rotation=float(tolerance_rotation),
        fps=fps,
        interpolation=interpolation,
        scene=scene,
    )
    arguments = ["diff", argument(a), argument(b), "--quiet", "--json", *given]
    read = run_for_json(arguments, with_scene(scene, a, b), also=[1])
    nodes = tuple(
        NodeDifference(node["node"], made(Deviation, node["translation"]), made(Deviation, node["rotation"]))
        for node in read["nodes"]
    )
    first = None if read["first_exceeded"] is None else made(FirstExceeded, read["first_exceeded"])
    return made(Difference, read, first_exceeded=first, notes=tuple(read["notes"]), nodes=nodes)


@dataclass(frozen=True)
class Candidate:
    """One mistake, or two together, and how far the samples are from it."""

    name: str
    """As ``inbetween help diagnose`` lists them; two are joined by `` + ``."""
    residual: float
    """The root mean square over all rows of the distance of translations and quaternions."""


@dataclass(frozen=True)
class Diagnosis:
    """The mistake that explains what a student's program showed. ``print`` shows it in sentences."""

    best: str
    """The name of the best candidate: ``correct`` (linear), ``correct-catmull-rom``, or a mistake."""
    explained: bool
    """Whether it explains every number; otherwise it is only nearest."""
    also: tuple[str, ...]
    """Mistakes that explain the samples as well."""
    residual: float
    """That of the best candidate."""
    candidates: tuple[Candidate, ...]
    """All that were tried, the best first."""
    text: str
    """What the program says in sentences: the mistake, and what to change."""

    def __str__(self) -> str:
        return self.text


def diagnose(keyframes: StrPath, samples: StrPath, *, scene: StrPath | None = None) -> Diagnosis:
    """Name the known mistake that explains what a program showed.

    Args:
        keyframes: The keyframes that the program played.
        samples: What it showed: CSV with the header ``key_time,rbt_ind,tx,ty,tz,rw,rx,ry,rz``.
        scene: A built-in scene or a scene file; None is ``two-robots``.

    Raises:
        InbetweenError: a file is bad.
    """
    paths = with_scene(scene, keyframes, samples)
    arguments = ["diagnose", argument(keyframes), argument(samples), *options(scene=scene)]
    read = run_for_json([*arguments, "--quiet", "--json"], paths)
    text = run_for_bytes(arguments, paths, warns=False).decode("utf-8", "replace").rstrip()
    candidates = tuple(made(Candidate, candidate) for candidate in read["candidates"])
    return made(Diagnosis, read, also=tuple(read["also"]), candidates=candidates, text=text)

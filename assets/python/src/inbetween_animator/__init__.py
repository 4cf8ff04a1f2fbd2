"""Inbetween for Python: sample, convert, compare, diagnose, grade and draw keyframe animations.

>>> import inbetween_animator as ia
>>> walk = ia.sample("walk.json", fps=30)
>>> walk["robot1/left_hip"].angular_speed  # degrees a second, one for each frame
>>> ia.render("walk.json", at=1.5)         # a Pillow image, which a notebook shows

Everything is done by the program ``inbetween``, which comes in the same wheel; each call is a process of its own.

* Times are seconds of playing, key times count played keyframes from 0.
* Positions are in scene units, x, y, z. The world is right-handed with Y up.
* Rotations are unit quaternions w, x, y, z. Angles are degrees.
* Node paths are such as ``robot1/left_shoulder/left_elbow``; :func:`nodes` lists them.
* Files are named by ``str`` or ``os.PathLike``; a name is never standard input or output.
* What the program refuses is an :class:`InbetweenError`, what a person should check an :class:`InbetweenWarning`.
"""

from ._files import (
    Candidate,
    Conversion,
    Deviation,
    Diagnosis,
    Difference,
    Finding,
    FirstExceeded,
    NodeDifference,
    convert,
    diagnose,
    diff,
)
from ._grading import Grades, Item, Shown, Submission, grade
from ._motion import Motion, NodeMotion, angular_speeds, nodes, sample
from ._pictures import Film, film, render
from ._program import InbetweenError, InbetweenWarning, Problem, program, run

__all__ = [
    "Candidate",
    "Conversion",
    "Deviation",
    "Diagnosis",
    "Difference",
    "Film",
    "Finding",
    "FirstExceeded",
    "Grades",
    "InbetweenError",
    "InbetweenWarning",
    "Item",
    "Motion",
    "NodeDifference",
    "NodeMotion",
    "Problem",
    "Shown",
    "Submission",
    "angular_speeds",
    "convert",
    "diagnose",
    "diff",
    "film",
    "grade",
    "nodes",
    "program",
    "render",
    "run",
    "sample",
]

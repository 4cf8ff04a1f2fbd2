"""The program: where it is, how it is run, and what it says when it fails."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import warnings
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import FrameType
from typing import Any

StrPath = str | os.PathLike[str]

#: The exit status of :class:`InbetweenError` where there is no program to run, as shells have it.
NOT_FOUND = 127


@dataclass(frozen=True)
class Problem:
    """One thing that is wrong."""

    message: str
    """The sentence of the program, with file and place."""
    path: Path | None
    """The file that it is about, as it was given to the function; None if it is about none."""
    place: str | None
    """Where in the file, such as ``line 3 column 7`` or ``keyframe 2, node "robot1/head"``; None if it is the whole file."""


class InbetweenError(Exception):
    """The program refused or failed. Nothing was written then, unless a function says otherwise.

    ``str`` gives all problems, a line each; ``path`` and ``place`` are those of the first.
    """

    def __init__(self, problems: Sequence[Problem], exit_status: int) -> None:
        super().__init__("\n".join(problem.message for problem in problems))
        self.problems: tuple[Problem, ...] = tuple(problems)
        """All that is wrong; at least one."""
        self.exit_status: int = exit_status
        """1: the input is bad; 2: wrong usage (or bad input of ``diff``); 3: no GPU adapter; 127: no program was found; negative: the
        number of the signal that ended the program."""

    def __reduce__(self) -> tuple[Any, ...]:
        # The arguments of an exception are its text: without this, it could not come back from another process.
        return (type(self), (self.problems, self.exit_status))

    @property
    def message(self) -> str:
        """All problems, a line each."""
        return str(self)

    @property
    def path(self) -> Path | None:
        """The file of the first problem."""
        return self.problems[0].path

    @property
    def place(self) -> str | None:
        """The place of the first problem."""
        return self.problems[0].place


class InbetweenWarning(UserWarning):
    """What a person should check: a guess about a text that was read."""


def program() -> Path:
    """The program ``inbetween`` that this module runs.

    It is the one that the environment variable ``INBETWEEN`` names, else the one that was installed with this module, else the one on
    the ``PATH``.

    Raises:
        InbetweenError: there is none (exit status 127).
    """
    named = os.environ.get("INBETWEEN")
    if named:
        found = shutil.which(named)
        if found is None:
            raise _not_found(f"the environment variable INBETWEEN names {named}, which is no program")
        return Path(found)
    name = "inbetween" + (sysconfig.get_config_var("EXE") or "")
    for folder in _script_folders():
        if os.access(folder / name, os.X_OK):
            return folder / name
    found = shutil.which(name)
    if found is None:
        raise _not_found("the program inbetween is neither installed with this module nor on the PATH: set INBETWEEN to its path")
    return Path(found)


def _not_found(message: str) -> InbetweenError:
    return InbetweenError([Problem(message, None, None)], NOT_FOUND)


def _script_folders() -> Iterator[Path]:
    """Where installers put the programs of a wheel: of this environment, of ``pip install --user``, of ``pip install --target``."""
    yield Path(sysconfig.get_path("scripts"))
    yield Path(sysconfig.get_path("scripts", sysconfig.get_preferred_scheme("user")))
    yield Path(__file__).parents[1] / "bin"


def run(*arguments: StrPath) -> str:
    """Run any command of the program, and return what it prints.

    For what has no function of its own: ``run("info", "walk.json", "--json")``. ``inbetween help`` lists the commands.

    Args:
        arguments: As on a command line; no shell reads them.

    Returns:
        Standard output, as text.

    Raises:
        InbetweenError: the program ended with another exit status than 0.
    """
    return run_for_bytes([os.fspath(argument) for argument in arguments]).decode("utf-8", "replace")


def run_for_bytes(arguments: Sequence[str], paths: Sequence[StrPath] = (), *, warns: bool = True) -> bytes:
    """The same, for bytes. ``paths`` are the files that the arguments name: problems are matched with them."""
    ended = _end(arguments)
    if ended.returncode != 0:
        raise _error(ended, paths)
    if warns:
        _warn(ended.stderr)
    return ended.stdout


def run_for_json(arguments: Sequence[str], paths: Sequence[StrPath] = (), also: Sequence[int] = ()) -> Any:
    """The JSON value that a command prints. ``also`` are exit statuses that are results, as "beyond the tolerance" is."""
    ended = _end(arguments)
    if ended.returncode != 0 and ended.returncode not in also:
        raise _error(ended, paths)
    _warn(ended.stderr)
    return json.loads(ended.stdout)


def argument(path: StrPath) -> str:
    """A path as an argument: never an option, and never standard input or output."""
    text = os.fspath(path)
    return f"./{text}" if text.startswith("-") else text


def options(**values: StrPath | int | float | bool | None) -> list[str]:
    """Options of the command line: those that are None or False are left out, ``from_`` is ``--from``."""
    made = []
    for name, value in values.items():
        option = "--" + name.rstrip("_").replace("_", "-")
        if value is True:
            made.append(option)
        elif value is not None and value is not False:
            text = value if isinstance(value, str) else os.fspath(value) if isinstance(value, os.PathLike) else repr(value)
            made.append(f"{option}={text}")
    return made


def size_option(size: tuple[int, int] | None) -> str | None:
    """Width and height as ``--size`` has them."""
    return None if size is None else f"{size[0]}x{size[1]}"


def _end(arguments: Sequence[str]) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run([program(), *arguments], stdin=subprocess.DEVNULL, capture_output=True, check=False)


def _warn(stderr: bytes) -> None:
    """Warnings are lines ``FILE: warning: SENTENCE`` on standard error."""
    for line in stderr.decode("utf-8", "replace").splitlines():
        if ": warning: " in line:
            # The caller of the function of this package that runs the program.
            warnings.warn(line, InbetweenWarning, stacklevel=_depth())


def _depth() -> int:
    """How many calls up the first one is that is not of this package, as ``warnings.warn`` counts in :func:`_warn`."""
    package = os.path.dirname(__file__)
    depth = 1
    frame: FrameType | None = sys._getframe(1)
    while frame is not None and os.path.dirname(frame.f_code.co_filename) == package:
        depth += 1
        frame = frame.f_back
    return depth


def _error(ended: subprocess.CompletedProcess[bytes], paths: Sequence[StrPath]) -> InbetweenError:
    return InbetweenError(_problems(ended, paths), ended.returncode)


def _problems(ended: subprocess.CompletedProcess[bytes], paths: Sequence[StrPath]) -> list[Problem]:
    in_json = _sentences_in_json(ended.stdout)
    if in_json:
        return [located(sentence, paths) for sentence in in_json]
    text = ended.stderr.decode("utf-8", "replace").strip()
    # Wrong usage is said in the form of clap, which ends with the usage of the command.
    if text.startswith("error: "):
        return [located(_AFTER_MISUSE.split(text)[0].removeprefix("error: "), paths)]
    sentences = [line for line in text.splitlines() if line and ": warning: " not in line]
    if ended.returncode < 0:
        sentences.append(f"a signal ended the program: {-ended.returncode}")
    if not sentences:
        sentences = [f"the program ended with exit status {ended.returncode}"]
    return [located(sentence, paths) for sentence in sentences]


_AFTER_MISUSE = re.compile(r"\n\n(?:Usage: |For more information)")


def _sentences_in_json(stdout: bytes) -> list[str]:
    """The ``problems`` of the objects that are printed, one a line."""
    sentences: list[str] = []
    for line in stdout.splitlines():
        try:
            value = json.loads(line)
        except ValueError:
            return []
        if isinstance(value, dict):
            sentences.extend(str(sentence) for sentence in value.get("problems", []))
    return sentences


#: The places of the manual's page Command line, section Exit status.
_PLACE = re.compile(
    r"""(line\ \d+(?:\ column\ \d+|,\ column\ \w+)?
        |keyframe\ \d+(?:,\ node\ "(?:[^"\\]|\\.)*")?
        |(?:node|picture)\ "(?:[^"\\]|\\.)*"
        ):\ """,
    re.VERBOSE,
)


def located(sentence: str, paths: Sequence[StrPath]) -> Problem:
    """A sentence of the form ``FILE: PLACE: REASON`` or ``FILE: REASON`` about one of the paths, taken apart.

    Only the paths that were given are files here: what else stands before a colon may be anything.
    """
    # Of two that fit, as "a" and "a: b" do, the longer one is meant.
    for path in sorted(paths, key=lambda path: -len(os.fspath(path))):
        name = next((name for name in _names(path) if sentence.startswith(f"{name}: ")), None)
        if name is not None:
            place = _PLACE.match(sentence, len(name) + 2)
            return Problem(sentence, Path(path), place[1] if place else None)
    return Problem(sentence, None, None)


#: What the program shows as an escape: control characters but tab and line end, and those that turn the direction of writing.
_HIDDEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069]")


def _names(path: StrPath) -> tuple[str, str]:
    """What sentences call a path: in JSON, and on standard error."""
    name = os.fsencode(argument(path)).decode("utf-8", "replace")
    return name, _HIDDEN.sub(lambda found: f"\\u{{{ord(found[0]):x}}}", name)

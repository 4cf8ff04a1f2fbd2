"""Where the program is found, how it is run, and what its errors say."""

from __future__ import annotations

import json
import os
import pickle
import re
import stat
import subprocess
import sys
import sysconfig
import warnings
from pathlib import Path

import pytest

import inbetween_animator as ia
from inbetween_animator import _program
from conftest import ASSETS, WALK, Says


def test_the_program_of_the_wheel_is_found(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("INBETWEEN", raising=False)
    monkeypatch.setenv("PATH", "")
    found = ia.program()
    assert found.parent == Path(sysconfig.get_path("scripts"))
    assert ia.run("--version").startswith("inbetween ")


def test_the_environment_names_another_program(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    other = tmp_path / "other"
    other.write_text("#!/bin/sh\necho other\n")
    other.chmod(other.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("INBETWEEN", str(other))
    assert ia.program() == other
    assert ia.run("--version") == "other\n"


def test_a_program_on_the_path_is_the_last_resort(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    other = tmp_path / "inbetween"
    other.write_text("")
    other.chmod(0o755)
    monkeypatch.delenv("INBETWEEN", raising=False)
    monkeypatch.setattr(_program, "_script_folders", lambda: iter([tmp_path / "none"]))
    monkeypatch.setenv("PATH", str(tmp_path))
    assert ia.program() == other


@pytest.mark.parametrize("named", ["", "/nowhere/inbetween"])
def test_no_program_is_an_error(named: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("INBETWEEN", named)
    monkeypatch.setenv("PATH", "")
    monkeypatch.setattr(_program, "_script_folders", lambda: iter([]))
    with pytest.raises(ia.InbetweenError, match="INBETWEEN") as caught:
        ia.sample(WALK)
    assert (caught.value.exit_status, caught.value.path, caught.value.place) == (127, None, None)
    assert named in caught.value.message


def test_the_module_runs_as_the_program(says: Says) -> None:
    run = subprocess.run([sys.executable, "-m", "inbetween_animator", "--version"], capture_output=True, text=True, check=True)
    assert run.stdout == says("--version")
    wrong = subprocess.run([sys.executable, "-m", "inbetween_animator", "chekc"], capture_output=True, text=True, check=False)
    assert wrong.returncode == 2
    assert "check" in wrong.stderr


def test_any_command_is_run(says: Says) -> None:
    assert ia.run("info", WALK, "--json") == says("info", WALK, "--json")


@pytest.mark.parametrize(
    ("sentence", "path", "place"),
    [
        ("a.json: line 3 column 7: the number is too large", "a.json", "line 3 column 7"),
        ("a.json: line 12: node \"x\" is not in the scene", "a.json", "line 12"),
        ("a.json: line 2, column tz: expected a number", "a.json", "line 2, column tz"),
        ('a.json: keyframe 0, node "robot1/head": rotation has length 2', "a.json", 'keyframe 0, node "robot1/head"'),
        (r'a.json: keyframe 0, node "a\": b": rotation has length 2', "a.json", r'keyframe 0, node "a\": b"'),
        ("a.json: keyframe 4: easing is \"x\"", "a.json", "keyframe 4"),
        ('a.json: node "hub": scale is [1, 0, 1]', "a.json", 'node "hub"'),
        ('a.json: node "hub" of the scene "x" is missing', "a.json", None),
        ("a.json: 3 keyframes cannot be played: the first and the last only steer", "a.json", None),
        ("a: b.json: line 1: nothing", "a: b.json", "line 1"),
        ("a: no such file", "a", None),
        ("b.json: line 1: nothing", None, None),
        ("no GPU adapter was found: install a driver", None, None),
    ],
)
def test_sentences_are_taken_apart(sentence: str, path: str | None, place: str | None) -> None:
    problem = _program.located(sentence, ["a", "a.json", "a: b.json"])
    assert (problem.message, problem.path, problem.place) == (sentence, path and Path(path), place)


def test_bad_files_are_errors_with_their_place() -> None:
    text = WALK.read_text()
    Path("broken.json").write_text(text[:400])
    long = json.loads(text)
    for node in (0, 1):
        long["keyframes"][0]["pose"][node]["rotation"] = [0, 0, 0, 3]
    Path("long.json").write_text(json.dumps(long))
    with pytest.raises(ia.InbetweenError) as caught:
        ia.sample("broken.json")
    error = caught.value
    assert (error.path, error.exit_status) == (Path("broken.json"), 1)
    assert error.place is not None and error.place.startswith("line ")
    assert error.message == str(error) and error.message.startswith(f"broken.json: {error.place}: ")
    with pytest.raises(ia.InbetweenError) as caught:
        ia.sample(Path("long.json"))
    assert [problem.place for problem in caught.value.problems] == [
        f'keyframe 0, node "{node}"' for node in long["nodes"][:2]
    ]
    assert "length 3" in caught.value.message


def test_errors_come_back_from_another_process() -> None:
    with pytest.raises(ia.InbetweenError) as caught:
        ia.sample("none.json")
    again = pickle.loads(pickle.dumps(caught.value))
    assert (again.message, again.path, again.exit_status) == (caught.value.message, Path("none.json"), 1)
    assert again.problems == caught.value.problems


@pytest.mark.parametrize("name", ["-o", "-", "--help", "a b.json", "걷기.json", "\u202egnp.json", "a: line 1: b.json"])
def test_names_are_files_whatever_they_are(name: str) -> None:
    with pytest.raises(ia.InbetweenError) as caught:
        ia.sample(name)
    assert (caught.value.path, caught.value.exit_status) == (Path(name), 1)
    Path(name).write_bytes(WALK.read_bytes())
    assert ia.sample(name, at=[0]).path == Path(name)


@pytest.mark.skipif(os.name != "posix", reason="names of files are bytes on POSIX alone")
def test_a_name_that_is_not_utf_8() -> None:
    name = os.fsdecode(b"walk\xff.json")
    with pytest.raises(ia.InbetweenError) as caught:
        ia.sample(name)
    assert caught.value.path == Path(name)
    Path(name).write_bytes(WALK.read_bytes())
    assert len(ia.sample(name, at=[0])) == 1


def test_wrong_usage_is_said_without_the_usage() -> None:
    with pytest.raises(ia.InbetweenError) as caught:
        ia.sample(WALK, fps=0)
    assert caught.value.exit_status == 2
    assert "--fps" in caught.value.message
    assert "Usage" not in caught.value.message and not caught.value.message.startswith("error")
    assert caught.value.path is None


def test_a_signal_is_said(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    other = tmp_path / "other"
    other.write_text("#!/bin/sh\nkill -9 $$\n")
    other.chmod(0o755)
    monkeypatch.setenv("INBETWEEN", str(other))
    with pytest.raises(ia.InbetweenError, match="signal ended the program: 9") as caught:
        ia.run("check", "a.json")
    assert caught.value.exit_status == -9


def test_what_a_person_should_check_is_a_warning(says: Says) -> None:
    # Every node turned alike: which four numbers are the quaternion cannot be told.
    row = "1 0 0 0 1 0 0\n"
    Path("rows.txt").write_text(row * 22 * 4)
    with pytest.warns(ia.InbetweenWarning, match=r"^rows\.txt: warning: ") as caught:
        ia.sample("rows.txt", at=[0])
    assert {Path(warning.filename) for warning in caught} == {Path(__file__)}
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ia.sample(WALK, at=[0])


def test_the_places_of_all_known_sentences_are_found() -> None:
    corpus = ASSETS.parent / "tests/corpus"
    told = "".join((corpus / name).read_text() for name in ("expected-files.txt", "expected-programs.txt"))
    sentences = re.findall(r"^> (([^ :]+\.\w+): (?:line|keyframe) \d.*)$", told, re.MULTILINE)
    assert len(sentences) > 200
    for sentence, name in sentences:
        problem = _program.located(sentence, [name])
        assert problem.path == Path(name) and problem.place, sentence
        assert re.fullmatch(r"line \d+( column \d+|, column \w+)?|keyframe \d+(, node \".+\")?", problem.place)
        assert sentence.startswith(f"{name}: {problem.place}: ")

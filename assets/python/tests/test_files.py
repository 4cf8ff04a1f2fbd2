"""Converting, comparing and diagnosing."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import inbetween_animator as ia
from conftest import DIAGNOSIS, WALK, WAVE, Says


def test_keyframes_survive_a_text() -> None:
    written = ia.convert(WALK, "walk.txt", exact=True)
    assert written.output == Path("walk.txt") and "keyframes" in written.summary
    read = ia.convert("walk.txt", Path("again.json"))
    assert "layout header" in read.summary
    assert {finding.certainty for finding in read.findings} <= {"sure", "likely", "note"}
    assert str(read).startswith(read.summary + "\n")
    again, walk = json.loads(Path("again.json").read_text()), json.loads(WALK.read_text())
    assert [keyframe["pose"] for keyframe in again["keyframes"]] == [keyframe["pose"] for keyframe in walk["keyframes"]]


def test_the_layout_is_that_of_the_ending_or_of_to() -> None:
    ia.convert(WALK, "walk.csv")
    assert Path("walk.csv").read_text().startswith("frame_num,rbt_ind,")
    ia.convert(WALK, "rows.txt", to="rows")
    assert len(Path("rows.txt").read_text().split()) % (22 * 7) == 0
    with pytest.raises(ia.InbetweenError) as caught:
        ia.convert(WALK, "walk.csv", to="rows")
    assert caught.value.exit_status == 2


def test_a_text_that_cannot_be_read_is_an_error_with_line_and_column() -> None:
    Path("student.txt").write_text("0 0 0 1 0 0 0\n1 2 three 1 0 0 0\n")
    with pytest.raises(ia.InbetweenError) as caught:
        ia.convert("student.txt", "out.json")
    assert (caught.value.path, caught.value.place) == (Path("student.txt"), "line 2 column 5")
    assert caught.value.exit_status == 1
    assert not Path("out.json").exists()


def test_an_output_that_cannot_be_written_is_the_problems_path() -> None:
    with pytest.raises(ia.InbetweenError) as caught:
        ia.convert(WALK, "nowhere/out.json")
    assert caught.value.path == Path("nowhere/out.json")


def test_options_of_convert() -> None:
    walk = ia.sample(WALK, at=[0])
    ia.convert(WALK, "q.txt", to="header-quaternion-first", exact=True)
    read = ia.convert("q.txt", "q.json", order="quaternion-first")
    assert read.output == Path("q.json")
    assert np.array_equal(ia.sample("q.json", at=[0], interpolation="linear").positions, walk.positions)
    lines = Path("q.txt").read_text().splitlines()
    Path("short.txt").write_text("\n".join(lines[:-3]) + "\n")
    with pytest.raises(ia.InbetweenError):
        ia.convert("short.txt", "short.json")
    with pytest.warns(ia.InbetweenWarning):
        salvaged = ia.convert("short.txt", "short.json", salvage=True)
    assert "warning" in {finding.certainty for finding in salvaged.findings}
    Path("joints.txt").write_text("\n".join(reversed(ia.nodes())) + "\n")
    ia.convert("q.txt", "reversed.json", joints="joints.txt", overwrite=True)
    reversed_ = ia.sample("reversed.json", at=[0], interpolation="linear")
    assert np.array_equal(reversed_.positions, walk.positions[:, ::-1])


def test_equal_animations_do_not_differ() -> None:
    same = ia.diff(WALK, WALK)
    assert same.within_tolerance and same.first_exceeded is None
    assert [node.node for node in same.nodes] == list(ia.nodes())
    assert all(node.translation.largest == 0 and node.rotation.exceeds_at is None for node in same.nodes)


def test_what_differs_is_a_result(says: Says) -> None:
    other = json.loads(WALK.read_text())
    at = other["nodes"].index("robot1")
    other["keyframes"][2]["pose"][at]["translation"][0] += 0.25
    Path("other.json").write_text(json.dumps(other))
    difference = ia.diff(WALK, "other.json", fps=30)
    assert not difference.within_tolerance
    assert difference.first_exceeded is not None
    assert (difference.first_exceeded.node, difference.first_exceeded.part) == ("robot1", "translation")
    assert difference["robot1"].translation.largest == pytest.approx(0.25, abs=0.02)
    assert difference["robot2"].translation.largest == 0
    assert ia.diff(WALK, "other.json", tolerance_translation=1).within_tolerance
    with pytest.raises(KeyError):
        difference["robot3"]
    # The reasons why they differ are sentences.
    assert any("different times" in note for note in ia.diff(WALK, WAVE).notes)


def test_trouble_is_an_error_of_diff() -> None:
    with pytest.raises(ia.InbetweenError) as caught:
        ia.diff(WALK, "none.json")
    assert (caught.value.path, caught.value.exit_status) == (Path("none.json"), 2)
    with pytest.raises(ia.InbetweenError) as caught:
        ia.diff("none.json", WALK)
    assert (caught.value.path, caught.value.exit_status) == (Path("none.json"), 2)


@pytest.mark.parametrize(
    ("name", "best"),
    [
        ("correct", "correct"),
        ("lerp-for-slerp", "lerp-for-slerp"),
        ("no-conditional-negation", "no-conditional-negation"),
        ("second-control-point-on-wrong-keyframe", "second-control-point-on-wrong-keyframe"),
    ],
)
def test_mistakes_are_named(name: str, best: str, says: Says) -> None:
    keyframes, samples = DIAGNOSIS / f"{name}.json", DIAGNOSIS / f"{name}.csv"
    diagnosis = ia.diagnose(keyframes, samples)
    assert diagnosis.explained and diagnosis.best.startswith(best)
    told = json.loads(says("diagnose", keyframes, samples, "--json"))
    assert diagnosis.residual == told["residual"] == diagnosis.candidates[0].residual
    assert [candidate.name for candidate in diagnosis.candidates] == [candidate["name"] for candidate in told["candidates"]]
    assert str(diagnosis) == says("diagnose", keyframes, samples).rstrip()


def test_bad_samples_are_an_error_with_their_place() -> None:
    text = (DIAGNOSIS / "correct.csv").read_text().splitlines()
    text[4] = text[4].replace(",", ",x", 3)
    Path("bad.csv").write_text("\n".join(text))
    with pytest.raises(ia.InbetweenError) as caught:
        ia.diagnose(DIAGNOSIS / "correct.json", "bad.csv")
    assert caught.value.path == Path("bad.csv")
    assert caught.value.place is not None and caught.value.place.startswith("line 5")



"""What the tests share: the repository's animations and rubric, and the program that was installed with the module."""

from __future__ import annotations

import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

import inbetween_animator as ia

ASSETS = Path(__file__).parents[2]
WALK = ASSETS / "animations/walk.json"
WAVE = ASSETS / "animations/wave.json"
GRADING = ASSETS / "grading"
DIAGNOSIS = ASSETS.parent / "tests/data/diagnosis"

Says = Callable[..., str]


@pytest.fixture
def says() -> Says:
    """What the program prints, without the module's help but for where the program is."""

    def run(*arguments: object) -> str:
        command = [str(ia.program()), *map(str, arguments)]
        return subprocess.run(command, check=True, capture_output=True, text=True, encoding="utf-8").stdout

    return run


@pytest.fixture(autouse=True)
def in_a_folder_of_its_own(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """No test writes into the repository."""
    monkeypatch.chdir(tmp_path)

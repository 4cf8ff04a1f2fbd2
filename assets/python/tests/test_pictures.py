"""Pictures and films: the pixels and bytes are those that the program writes. They need a graphics driver, a software driver at least."""

from __future__ import annotations

import base64
import re
from io import BytesIO
from pathlib import Path

import numpy as np
import PIL.Image
import pytest

import inbetween_animator as ia
from conftest import WALK, Says


def pixels(picture: PIL.Image.Image) -> "np.ndarray[tuple[int, ...], np.dtype[np.uint8]]":
    return np.asarray(picture.convert("RGBA"))


def test_a_picture_is_the_programs_own(says: Says) -> None:
    picture = ia.render(WALK, 1.5, size=(80, 60))
    says("render", WALK, "--at", 1.5, "--size", "80x60", "-o", "walk.png")
    assert picture.size == (80, 60)
    assert np.array_equal(pixels(picture), pixels(PIL.Image.open("walk.png")))
    assert not np.array_equal(pixels(picture), pixels(ia.render(WALK, size=(80, 60))))
    # What a notebook shows.
    assert picture._repr_png_().startswith(b"\x89PNG")  # type: ignore[union-attr]


def test_options_of_pictures(says: Says) -> None:
    size = (64, 48)
    plain = pixels(ia.render(WALK, 1, size=size))
    assert np.array_equal(plain, pixels(ia.render(WALK, keyframe=2, size=size)))
    changed = {
        "ghosts": ia.render(WALK, 1, size=size, ghosts=2),
        "lighting": ia.render(WALK, 1, size=size, lighting="evening"),
        "quality": ia.render(WALK, 1, size=size, quality=4),
        "strobe": ia.render(WALK, size=size, strobe=3),
        "background": ia.render(WALK, 1, size=size, background="#ff00ff"),
        "further": ia.render(WALK, 1, size=size, further=["--samples", "4"]),
        "scene": ia.render(scene="cylinder", size=size),
        "rest": ia.render(size=size),
    }
    for name, picture in changed.items():
        assert picture.size == size and not np.array_equal(pixels(picture), plain), name
    clear = ia.render(WALK, 1, size=size, background="transparent")
    assert pixels(clear)[0, 0].tolist() == [0, 0, 0, 0]
    compared = ia.render(WALK, 1, size=(320, 200), compare=["linear", "matrix"])
    assert compared.size == (320, 200)


def test_a_film_is_the_programs_own(says: Says) -> None:
    film = ia.film(WALK, fps=5, from_=0, to=2, size=(64, 48))
    says("render", WALK, "--fps", 5, "--from", 0, "--to", 2, "--size", "64x48", "-o", "walk.webp")
    assert film.data == Path("walk.webp").read_bytes()
    assert film.size == (64, 48) and film.frames > 3
    assert film.save("saved.webp").read_bytes() == film.data
    says("render", WALK, "--fps", 5, "--from", 0, "--to", 2, "--size", "64x48", "-o", "walk.gif")
    assert film.save("saved.gif").read_bytes() == Path("walk.gif").read_bytes()
    with pytest.raises(ia.InbetweenError, match="avi"):
        film.save("saved.avi")
    with pytest.raises(ia.InbetweenError) as caught:
        film.save("nowhere/saved.gif")
    assert caught.value.path == Path("nowhere/saved.gif")


def test_a_film_plays_in_a_notebook() -> None:
    film = ia.film(scene="cylinder", fps=4, size=(32, 24))
    shown = re.fullmatch(r'<img src="data:image/webp;base64,([^"]+)" alt="a film of cylinder">', film._repr_html_())
    assert shown is not None and base64.b64decode(shown[1]) == film.data
    with PIL.Image.open(BytesIO(film.data)) as picture:
        assert picture.format == "WEBP" and getattr(picture, "is_animated", False)
    assert len(repr(film)) < 100


def test_what_cannot_be_drawn_is_an_error() -> None:
    with pytest.raises(ia.InbetweenError) as caught:
        ia.render("none.json")
    assert (caught.value.path, caught.value.exit_status) == (Path("none.json"), 1)
    with pytest.raises(ia.InbetweenError) as caught:
        ia.film(WALK, fps=5, camera="no/eye", size=(32, 24))
    assert "no/eye" in caught.value.message
    with pytest.raises(ia.InbetweenError) as caught:
        ia.render(WALK, size=(0, 5))
    assert caught.value.exit_status == 2


def test_no_driver_is_an_error(monkeypatch: pytest.MonkeyPatch) -> None:
    for variable in ("VK_ICD_FILENAMES", "VK_DRIVER_FILES"):
        monkeypatch.setenv(variable, "/nowhere.json")
    with pytest.raises(ia.InbetweenError) as caught:
        ia.render(WALK, size=(32, 24))
    assert (caught.value.exit_status, caught.value.path) == (3, None)

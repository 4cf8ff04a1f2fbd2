"""Pictures and films, drawn without a display."""

from __future__ import annotations

import base64
import html
from collections.abc import Sequence
from dataclasses import dataclass, field
from io import BytesIO
from pathlib import Path
from typing import Literal

import PIL.Image

from ._files import with_scene
from ._motion import Interpolation
from ._program import StrPath, argument, options, run_for_bytes, size_option

Lighting = Literal["day", "evening", "studio"]
Blend = Literal["linear", "catmull-rom", "nlerp", "matrix", "file"]


def render(
    path: StrPath | None = None,
    at: float | None = None,
    *,
    keyframe: int | None = None,
    size: tuple[int, int] | None = None,
    quality: str | int | None = None,
    camera: str | None = None,
    background: str | None = None,
    lighting: Lighting | None = None,
    ghosts: int = 0,
    strobe: int | None = None,
    compare: Sequence[Blend] = (),
    seconds: float = 0.0,
    interpolation: Interpolation | None = None,
    scene: StrPath | None = None,
    further: Sequence[str] = (),
) -> PIL.Image.Image:
    """Draw one moment of an animation, or the scene's rest pose.

    The picture is Pillow's: it shows itself in a notebook, and has ``save``.

    Args:
        path: A keyframe file or a text; None draws the scene's rest pose.
        at: The key time, from 0 to N - 3; without ``at`` and ``keyframe`` it is 0.
        keyframe: The keyframe of the list, from 0 to N - 1, in place of a key time.
        size: Width and height in pixels; None is 640 by 480, and with ``compare`` what its views need.
        quality: ``draft`` (None), ``good``, ``film``, ``poster``, or the number of sub-frames.
        camera: The path of an eye of the scene; None is its first.
        background: ``sky`` (None), ``#rrggbb`` or ``transparent``.
        lighting: The light; None is the scene's.
        ghosts: How many keyframes before and after are shown, translucent; at most 20.
        strobe: Show so many moments of the whole animation in one picture, 2 to 32.
        compare: Show the moment by 2 to 4 interpolations, with plots of the angular speed.
        seconds: The time of the scene's timed keys.
        interpolation: In place of the file's.
        scene: A built-in scene or a scene file; None is ``two-robots``.
        further: Other options of ``inbetween render``, such as ``["--samples", "4"]``.

    Raises:
        InbetweenError: the file or an argument is bad; there is no GPU adapter, also no software driver (exit status 3).
    """
    moment = options(
        at=None if at is None else float(at),
        keyframe=keyframe,
        size=size_option(size),
        quality=None if quality is None else str(quality),
        camera=camera,
        background=background,
        lighting=lighting,
        ghosts=ghosts or None,
        strobe=strobe,
        compare=",".join(compare) or None,
        seconds=float(seconds),
        interpolation=interpolation,
        scene=scene,
    )
    arguments = _request(path, [*moment, *further])
    png = run_for_bytes([*arguments, "--output=-", "--format=png"], with_scene(scene, path))
    picture = PIL.Image.open(BytesIO(png), formats=["PNG"])
    picture.load()
    return picture


def film(
    path: StrPath | None = None,
    fps: int = 25,
    *,
    from_: float | None = None,
    to: float | None = None,
    size: tuple[int, int] | None = None,
    quality: str | int | None = None,
    camera: str | None = None,
    background: str | None = None,
    lighting: Lighting | None = None,
    ghosts: int = 0,
    compare: Sequence[Blend] = (),
    seconds: float = 0.0,
    interpolation: Interpolation | None = None,
    scene: StrPath | None = None,
    further: Sequence[str] = (),
) -> Film:
    """Draw an animation, or a scene's timed keys, as a film that plays in a notebook.

    Args:
        path: A keyframe file or a text; None is for scenes with timed keys, or ``camera="turntable"``.
        fps: Frames a second, 1 to 90.
        from_: The key time at which the film begins; None is 0.
        to: The key time at which it ends; None is N - 3.
        size: Width and height in pixels; None is 320 by 240, and with ``compare`` what its views need.
        quality, camera, background, lighting, ghosts, compare, seconds, interpolation, scene: As of :func:`render`; ``camera`` may also
            be ``turntable``, which circles the scene once.
        further: Other options of ``inbetween render``.

    Raises:
        InbetweenError: as :func:`render`.
    """
    given = options(
        fps=fps,
        from_=None if from_ is None else float(from_),
        to=None if to is None else float(to),
        size=size_option(size if size is not None or compare else (320, 240)),
        quality=None if quality is None else str(quality),
        camera=camera,
        background=background,
        lighting=lighting,
        ghosts=ghosts or None,
        compare=",".join(compare) or None,
        seconds=float(seconds),
        interpolation=interpolation,
        scene=scene,
    )
    arguments = _request(path, [*given, *further])
    paths = with_scene(scene, path)
    webp = run_for_bytes([*arguments, "--output=-", "--format=webp"], paths)
    return Film(webp, f"a film of {scene or 'two-robots'}" if path is None else f"a film of {path}", arguments, paths)


@dataclass(frozen=True)
class Film:
    """A film: an animated WebP, which shows itself in a notebook."""

    data: bytes = field(repr=False)
    """The bytes of the animated WebP."""
    alt: str
    """What it shows, for who does not see it."""
    _arguments: list[str] = field(repr=False)
    _paths: list[StrPath] = field(repr=False)

    @property
    def frames(self) -> int:
        """The number of frames that differ from the one before."""
        return int(getattr(self._picture(), "n_frames", 1))

    @property
    def size(self) -> tuple[int, int]:
        """Width and height in pixels."""
        return self._picture().size

    def save(self, output: StrPath) -> Path:
        """Write the film to a file.

        A ``.webp`` has the bytes of ``data``. For any other ending (``.gif``, ``.apng``, ``.y4m``, ``.mp4`` through ffmpeg) it is drawn
        anew, of the keyframe file as it is then.

        Returns:
            The path.

        Raises:
            InbetweenError: the ending is unknown, the film cannot be drawn or written.
        """
        path = Path(output)
        if path.suffix.lower() == ".webp":
            path.write_bytes(self.data)
        else:
            run_for_bytes([*self._arguments, f"--output={argument(output)}"], [*self._paths, output])
        return path

    def _picture(self) -> PIL.Image.Image:
        return PIL.Image.open(BytesIO(self.data), formats=["WEBP"])

    def _repr_html_(self) -> str:
        text = base64.b64encode(self.data).decode("ascii")
        return f'<img src="data:image/webp;base64,{text}" alt="{html.escape(self.alt)}">'


def _request(path: StrPath | None, given: Sequence[str]) -> list[str]:
    return ["render", *([] if path is None else [argument(path)]), "--quiet", *given]

"""Poses over time, as arrays."""

from __future__ import annotations

import difflib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._program import StrPath, argument, options, run_for_json

Floats = NDArray[np.float64]
Interpolation = Literal["linear", "catmull-rom"]
Space = Literal["parent", "world"]


@dataclass(frozen=True, eq=False)
class NodeMotion:
    """What one node does: a column of :class:`Motion`."""

    node: str
    """Its path in the scene, such as ``robot1/head``."""
    times: Floats
    """(frames,): seconds of playing from the first played keyframe."""
    positions: Floats
    """(frames, 3): x, y, z in scene units."""
    rotations: Floats
    """(frames, 4): unit quaternions w, x, y, z."""

    @property
    def speed(self) -> Floats:
        """(frames,): how fast its origin moves, in scene units a second."""
        return _speeds(self.times, self.positions)

    @property
    def angular_speed(self) -> Floats:
        """(frames,): how fast it turns, in degrees a second."""
        return angular_speeds(self.times, self.rotations)


@dataclass(frozen=True, eq=False)
class Motion:
    """An animation, or a part of it, as poses at moments. ``motion["robot1/head"]`` is what one node does.

    The program computes in single precision; the arrays have its numbers as float64. Speeds are differences between the frames beside a
    moment (at both ends, between the last two), so they are smooth where there are more frames a second than the motion needs.
    """

    path: Path
    """The file that was sampled."""
    space: Space
    """The space of positions, rotations and matrices: ``parent`` is that of each node's parent, ``world`` is right-handed, Y up."""
    nodes: tuple[str, ...]
    """The paths of the nodes, in the order of the arrays: in parent space the nodes of poses (RBT nodes), in world space all nodes."""
    key_times: Floats
    """(frames,): played keyframes; 0 is the first played one, keyframe 1 of the file."""
    times: Floats
    """(frames,): seconds of playing from key time 0."""
    positions: Floats
    """(frames, nodes, 3): the origins of the nodes: x, y, z in scene units."""
    rotations: Floats
    """(frames, nodes, 4): unit quaternions w, x, y, z. q and -q are the same rotation, and the sign is as it was computed. In world space
    below a control node that scales, it is the rotation that is nearest to the node's matrix."""
    matrices: Floats
    """(frames, nodes, 4, 4): parent_from_node or world_from_node; they multiply columns: ``matrices @ [x, y, z, 1]``."""

    @cached_property
    def speeds(self) -> Floats:
        """(frames, nodes): how fast each node's origin moves, in scene units a second."""
        return _speeds(self.times, self.positions)

    @cached_property
    def angular_speeds(self) -> Floats:
        """(frames, nodes): how fast each node turns, in degrees a second."""
        return angular_speeds(self.times, self.rotations)

    def index(self, node: str) -> int:
        """The place of a node in the arrays.

        Raises:
            KeyError: there is no such node; the text names the nearest.
        """
        try:
            return self.nodes.index(node)
        except ValueError:
            near = difflib.get_close_matches(node, self.nodes, n=1)
            hint = f": did you mean {near[0]!r}?" if near else ""
            raise KeyError(f"there is no node {node!r}{hint}") from None

    def __getitem__(self, node: str) -> NodeMotion:
        at = self.index(node)
        return NodeMotion(node, self.times, self.positions[:, at], self.rotations[:, at])

    def __contains__(self, node: object) -> bool:
        return node in self.nodes

    def __len__(self) -> int:
        """The number of frames."""
        return len(self.times)

    def __repr__(self) -> str:
        spread = f"from {self.times.min():g} s to {self.times.max():g} s"
        return f"<Motion of {self.path}: {len(self)} frames of {len(self.nodes)} nodes, {spread}, {self.space} space>"


def sample(
    path: StrPath,
    fps: int = 30,
    *,
    at: Sequence[float] | None = None,
    space: Space = "parent",
    interpolation: Interpolation | None = None,
    seconds: float = 0.0,
    scene: StrPath | None = None,
) -> Motion:
    """Play an animation, and give its poses as arrays.

    Args:
        path: A keyframe file, or a text of keyframes that a student's program wrote.
        fps: Frames a second, 1 to 1000: of the whole playing range, and its end, which may lie between two frames.
        at: Key times in place of frames, from 0 to N - 3, in the order of the arrays.
        space: ``parent``: the nodes of poses, each in its parent's space; ``world``: all nodes, shapes too.
        interpolation: In place of the file's.
        seconds: The time of the scene's timed keys at the first frame.
        scene: A built-in scene (``two-robots``, ``cylinder``, ``orbits``) or a scene file; None is ``two-robots``.

    Raises:
        InbetweenError: the file or an argument is bad.
    """
    moments = options(fps=fps) if at is None else options(at=",".join(repr(float(key_time)) for key_time in at))
    given = options(space=space, interpolation=interpolation, seconds=float(seconds), scene=scene)
    arguments = ["sample", argument(path), "--quiet", "--json", *moments, *given]
    read = run_for_json(arguments, [path, *([] if scene is None else [scene])])
    frames, nodes = read["frames"], tuple(read["nodes"])
    key_times = np.array([frame["key_time"] for frame in frames], np.float64)
    times = np.array([frame["ms"] for frame in frames], np.float64) / 1000
    if space == "world":
        # Sixteen numbers in column order.
        columns = np.array([frame["world_from_node"] for frame in frames], np.float64)
        matrices = columns.reshape(len(frames), len(nodes), 4, 4).swapaxes(2, 3).copy()
        positions, rotations = matrices[..., :3, 3].copy(), _nearest_rotations(matrices[..., :3, :3])
    else:
        poses = [frame["pose"] for frame in frames]
        positions = np.array([[node["translation"] for node in pose] for pose in poses], np.float64)
        positions = positions.reshape(len(frames), len(nodes), 3)
        rotations = np.array([[node["rotation"] for node in pose] for pose in poses], np.float64)
        # The program has x, y, z, w.
        rotations = np.roll(rotations.reshape(len(frames), len(nodes), 4), 1, axis=-1)
        matrices = _matrices(positions, rotations)
    return Motion(Path(path), space, nodes, key_times, times, positions, rotations, matrices)


def nodes(scene: StrPath | None = None) -> tuple[str, ...]:
    """The paths of a scene's nodes of poses (RBT nodes), in the order of poses.

    Args:
        scene: A built-in scene or a scene file; None is ``two-robots``.

    Raises:
        InbetweenError: there is no such scene, or the file is bad.
    """
    return tuple(run_for_json(["nodes", "--json", *options(scene=scene)], [] if scene is None else [scene]))


def _speeds(times: Floats, positions: Floats) -> Floats:
    return np.asarray(np.linalg.norm(np.gradient(positions, _in_order(times), axis=0), axis=-1), np.float64)


def angular_speeds(times: ArrayLike, rotations: ArrayLike) -> Floats:
    """How fast things turn, of rotations at moments: of what a student's program showed, say.

    At each moment it is the angle between the rotations of the frames before and after, divided by the time between; at both ends,
    that of the last two frames.

    Args:
        times: (frames,): seconds, each later than the one before; two or more.
        rotations: (frames, ..., 4): unit quaternions w, x, y, z; q and -q are the same.

    Returns:
        (frames, ...): degrees a second.

    Raises:
        ValueError: the times do not grow, or the shapes do not go together.
    """
    moments, turned = _in_order(times), np.asarray(rotations, np.float64)
    if turned.ndim < 2 or turned.shape[0] != len(moments) or turned.shape[-1] != 4:
        raise ValueError(f"rotations of the shape {turned.shape} are not 4 numbers for each of {len(moments)} moments")
    frames = np.arange(len(moments))
    before, after = np.maximum(frames - 1, 0), np.minimum(frames + 1, len(moments) - 1)
    dot = np.sum(turned[before] * turned[after], axis=-1)
    # What is across the first quaternion is the sine of half the turn: exact for small turns, where the cosine is not.
    across = turned[after] - dot[..., None] * turned[before]
    turns = 2 * np.degrees(np.arctan2(np.linalg.norm(across, axis=-1), np.abs(dot)))
    seconds = moments[after] - moments[before]
    return np.asarray(turns / seconds.reshape(-1, *[1] * (turns.ndim - 1)), np.float64)


def _in_order(times: ArrayLike) -> Floats:
    moments = np.asarray(times, np.float64)
    if moments.ndim != 1 or len(moments) < 2 or not np.all(np.diff(moments) > 0):
        raise ValueError("speeds need two moments or more, each later than the one before")
    return moments


def _matrices(positions: Floats, rotations: Floats) -> Floats:
    w, x, y, z = np.moveaxis(rotations, -1, 0)
    matrices = np.zeros((*positions.shape[:-1], 4, 4))
    matrices[..., 0, :3] = np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], axis=-1)
    matrices[..., 1, :3] = np.stack([2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)], axis=-1)
    matrices[..., 2, :3] = np.stack([2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)], axis=-1)
    matrices[..., :3, 3] = positions
    matrices[..., 3, 3] = 1
    return matrices


def _nearest_rotations(matrices: Floats) -> Floats:
    """The quaternions w, x, y, z, with w not negative, of the rotations nearest to 3x3 matrices (Frobenius norm)."""
    u, _, vt = np.linalg.svd(matrices)
    u[..., 2] *= np.sign(np.linalg.det(u @ vt))[..., None]
    m = u @ vt
    # Of the four ways to read a quaternion off a matrix, the one with the largest component is well conditioned.
    xx, yy, zz = m[..., 0, 0], m[..., 1, 1], m[..., 2, 2]
    wx, wy, wz = m[..., 2, 1] - m[..., 1, 2], m[..., 0, 2] - m[..., 2, 0], m[..., 1, 0] - m[..., 0, 1]
    xy, xz, yz = m[..., 0, 1] + m[..., 1, 0], m[..., 0, 2] + m[..., 2, 0], m[..., 1, 2] + m[..., 2, 1]
    ways = np.stack(
        [
            np.stack([1 + xx + yy + zz, wx, wy, wz], axis=-1),
            np.stack([wx, 1 + xx - yy - zz, xy, xz], axis=-1),
            np.stack([wy, xy, 1 - xx + yy - zz, yz], axis=-1),
            np.stack([wz, xz, yz, 1 - xx - yy + zz], axis=-1),
        ],
        axis=-2,
    )
    best = np.argmax(np.diagonal(ways, axis1=-2, axis2=-1), axis=-1)
    quaternions = np.take_along_axis(ways, best[..., None, None], axis=-2)[..., 0, :]
    quaternions /= np.linalg.norm(quaternions, axis=-1, keepdims=True)
    return np.asarray(np.where(quaternions[..., :1] < 0, -quaternions, quaternions), np.float64)

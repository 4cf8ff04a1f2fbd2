"""Arrays of poses: the numbers are those that the program prints, and speeds are those of known motions."""

from __future__ import annotations

import io
import json
import math
from pathlib import Path

import numpy as np
import pytest

import inbetween_animator as ia
from conftest import ASSETS, GRADING, WALK, WAVE, Says


@pytest.mark.parametrize("interpolation", [None, "linear", "catmull-rom"])
@pytest.mark.parametrize("path", [WALK, WAVE, GRADING / "reference.json"])
def test_numbers_are_the_programs_own(path: Path, interpolation: str | None, says: Says) -> None:
    motion = ia.sample(path, fps=24, interpolation=interpolation)  # type: ignore[arg-type]
    override = [] if interpolation is None else ["--interpolation", interpolation]
    rows = np.genfromtxt(io.StringIO(says("sample", path, "--fps", 24, "--format", "csv", *override)), delimiter=",", names=True)
    frames = json.loads(says("sample", path, "--fps", 24, *override))["frames"]
    shape = (len(motion), len(motion.nodes))
    assert rows.shape == (shape[0] * shape[1],)
    assert np.array_equal(np.repeat(motion.key_times, shape[1]), rows["key_time"])
    assert np.array_equal(motion.times, np.array([frame["ms"] for frame in frames]) / 1000)
    for axis, name in enumerate(["tx", "ty", "tz"]):
        assert np.array_equal(motion.positions[..., axis], rows[name].reshape(shape))
    for axis, name in enumerate(["rw", "rx", "ry", "rz"]):
        assert np.array_equal(motion.rotations[..., axis], rows[name].reshape(shape))
    assert motion.nodes == ia.nodes() == tuple(json.loads(says("nodes", "--json")))


def test_shapes_types_and_units() -> None:
    motion = ia.sample(WALK, fps=30)
    frames, nodes = len(motion), len(motion.nodes)
    assert motion.positions.shape == (frames, nodes, 3)
    assert motion.rotations.shape == (frames, nodes, 4)
    assert motion.matrices.shape == (frames, nodes, 4, 4)
    assert motion.speeds.shape == motion.angular_speeds.shape == (frames, nodes)
    for array in (motion.times, motion.key_times, motion.positions, motion.rotations, motion.matrices, motion.angular_speeds):
        assert array.dtype == np.float64
    assert motion.times[0] == 0 and np.allclose(np.diff(motion.times)[:-1], 1 / 30)
    assert motion.path == WALK and motion.space == "parent"
    assert np.allclose(np.linalg.norm(motion.rotations, axis=-1), 1, atol=1e-6)
    assert repr(motion).startswith(f"<Motion of {WALK}: {frames} frames of 22 nodes, from 0 s to ")


def test_key_times_are_sampled_in_the_order_given() -> None:
    motion = ia.sample(WALK, at=[2, 0.5, np.float64(1)])
    assert motion.key_times.tolist() == [2, 0.5, 1]
    with pytest.raises(ValueError, match="each later"):
        _ = motion.speeds
    with pytest.raises(ValueError, match="two moments"):
        _ = ia.sample(WALK, at=[0]).angular_speeds
    with pytest.raises(ia.InbetweenError) as caught:
        ia.sample(WALK, at=[99])
    assert caught.value.path == WALK


def test_a_node_is_a_column() -> None:
    motion = ia.sample(WALK)
    at = motion.index("robot1/head")
    head = motion["robot1/head"]
    assert head.node == "robot1/head" == motion.nodes[at]
    assert np.array_equal(head.positions, motion.positions[:, at])
    assert np.array_equal(head.rotations, motion.rotations[:, at])
    assert np.array_equal(head.speed, motion.speeds[:, at])
    assert np.array_equal(head.angular_speed, motion.angular_speeds[:, at])
    assert "robot1/head" in motion and "head" not in motion
    with pytest.raises(KeyError, match="did you mean 'robot1/head'"):
        motion["robot1/haed"]


def spin(degrees: float) -> Path:
    """A keyframe file in which robot1 goes one unit along x and turns about y by so many degrees, in each half second."""
    walk = json.loads(WALK.read_text())
    still = {"translation": [0, 0, 0], "rotation": [0, 0, 0, 1]}
    keyframes = []
    for step in range(6):
        half = math.radians(degrees * step) / 2
        turned = {"translation": [step, 0, 0], "rotation": [0, math.sin(half), 0, math.cos(half)]}
        keyframes.append({"pose": [turned if node == "robot1" else still for node in walk["nodes"]]})
    made = {"format": "inbetween.keyframes", "version": 1, "scene": "two-robots", "interpolation": "linear"}
    path = Path("spin.json")
    path.write_text(json.dumps({**made, "ms_between_keyframes": 500, "nodes": walk["nodes"], "keyframes": keyframes}))
    return path


@pytest.mark.parametrize("degrees", [0.02, 45, 89, 170])
def test_speeds_of_a_known_motion(degrees: float) -> None:
    motion = ia.sample(spin(degrees), fps=60)
    robot = motion["robot1"]
    assert motion.times[-1] == 1.5
    assert np.allclose(robot.angular_speed, 2 * degrees, rtol=2e-4, atol=2e-3)
    assert np.allclose(robot.speed, 2, atol=1e-4)
    assert np.array_equal(motion["robot2"].angular_speed, np.zeros(len(motion)))
    # The same rotations, written by the other quaternions.
    signs = np.where(np.arange(len(motion)) % 2, 1, -1)[:, None]
    assert np.allclose(ia.angular_speeds(robot.times, robot.rotations * signs), robot.angular_speed)


def test_angular_speeds_of_any_rotations() -> None:
    half = np.radians([0, 10, 40]) / 2
    rotations = np.stack([np.cos(half), 0 * half, np.sin(half), 0 * half], axis=-1)
    assert np.allclose(ia.angular_speeds([0, 1, 3], rotations), [10, 40 / 3, 15])
    with pytest.raises(ValueError, match="shape"):
        ia.angular_speeds([0, 1], rotations)
    with pytest.raises(ValueError, match="later"):
        ia.angular_speeds([0, 1, 1], rotations)


def test_matrices_are_of_positions_and_rotations() -> None:
    motion = ia.sample(spin(90), at=[1])
    # A quarter turn about y, twice, since key time 1 is keyframe 2: x becomes -x.
    matrix = motion.matrices[0, motion.index("robot1")]
    assert np.allclose(matrix, [[-1, 0, 0, 2], [0, 1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1]], atol=1e-6)
    quarter = ia.sample(spin(45), at=[1]).matrices[0, motion.index("robot1")]
    assert np.allclose(quarter[:3, :3] @ [1, 0, 0], [0, 0, -1], atol=1e-6)


def test_the_world_is_the_product_of_parents() -> None:
    local = ia.sample(WALK, fps=5)
    world = ia.sample(WALK, fps=5, space="world")
    assert len(world.nodes) > len(local.nodes) and world.space == "world"
    for at, node in enumerate(local.nodes):
        product = np.broadcast_to(np.eye(4), (len(local), 4, 4))
        parts = node.split("/")
        for depth in range(len(parts)):
            product = product @ local.matrices[:, local.index("/".join(parts[: depth + 1]))]
        in_world = world.index(node)
        assert np.allclose(world.matrices[:, in_world], product, atol=1e-5), node
        assert np.allclose(world.positions[:, in_world], product[:, :3, 3], atol=1e-5)
        # The quaternion turns as the matrix does.
        w, x, y, z = world.rotations[:, in_world].T
        assert np.allclose(2 * (x * z + w * y), product[:, 0, 2], atol=1e-5)
        assert np.allclose(1 - 2 * (x * x + z * z), product[:, 1, 1], atol=1e-5)
        assert np.allclose(2 * (x * y + w * z), product[:, 1, 0], atol=1e-5)
        assert np.allclose(np.linalg.norm(world.rotations[:, in_world], axis=-1), 1)


def test_other_scenes_and_their_timed_keys(says: Says) -> None:
    tour = ASSETS / "animations/orbits-tour.json"
    scene = ASSETS / "scenes/orbits.json"
    named, filed = ia.sample(tour, scene="orbits", space="world"), ia.sample(tour, scene=scene, space="world")
    assert np.array_equal(named.matrices, filed.matrices)
    later = ia.sample(tour, scene="orbits", space="world", seconds=2)
    assert not np.array_equal(later.matrices, named.matrices)
    assert ia.nodes("orbits") == tuple(json.loads(says("nodes", "--json", "--scene", "orbits")))
    with pytest.raises(ia.InbetweenError) as caught:
        ia.sample(tour, scene="no-such-scene")
    assert "no-such-scene" in caught.value.message

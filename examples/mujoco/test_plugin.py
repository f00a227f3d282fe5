"""Baked fields in MuJoCo itself: fall, rest, touch, screw, and what happens to files that are no fields."""

import pathlib
import threading

import igl
import mujoco
import numpy as np
import pytest

import screw

COWS = (1, 2)

# MuJoCo makes a mesh of the field.
WITHOUT_FILE = ('file="spot.obj" inertia="exact"/>', 'inertia="exact"><plugin instance="spot"/></mesh>')


def step(model, data, seconds):
    """Simulates; returns the deepest penetration that MuJoCo saw between each pair of geoms, metres, at most 0."""
    deepest = {}
    for _ in range(round(seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)
        for contact in data.contact[: data.ncon]:
            pair = tuple(sorted(int(geom) for geom in contact.geom))
            deepest[pair] = min(deepest.get(pair, 0.0), contact.dist)
    return deepest


def vertices_of(name, data, body):
    """The vertices of a body's mesh in the world, and its triangles."""
    vertices, triangles = igl.read_triangle_mesh(f"{name}.obj")
    return vertices @ data.xmat[body].reshape(3, 3).T + data.xpos[body], triangles


def exact_distances(points, vertices, triangles):
    """To a mesh, by libigl."""
    return igl.signed_distance(points, vertices, triangles, sign_type=igl.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER)[0]


def test_bodies_fall_touch_and_rest(scene):
    model = scene("fall.xml")
    data = mujoco.MjData(model)
    deepest = step(model, data, 4.0)
    assert COWS in deepest, "the cows never met"
    assert min(deepest.values()) > -0.05, f"too deep: {deepest}"

    deepest = step(model, data, 0.5)
    assert np.abs(data.qvel).max() < 0.02, f"they still move: {data.qvel}"
    assert COWS in deepest, "they do not touch"
    lower, triangles = vertices_of("spot", data, 1)
    upper, _ = vertices_of("spot", data, 2)
    assert abs(lower[:, 2].min()) < 0.01, "the lower one does not lie on the plane"
    assert upper[:, 2].min() > 0.1, "the upper one does not lie on the lower one"
    assert abs(exact_distances(upper, lower, triangles).min()) < 0.02, "in one another, or apart"


def test_a_bolt_turns_in_a_nut(scene):
    model = scene("screw.xml")
    data = mujoco.MjData(model)
    data.ctrl[:] = -2 * np.pi
    start = data.qpos.copy()
    deepest = step(model, data, 2.0)
    advance, turn = data.qpos - start
    turns = turn / (2 * np.pi)
    assert turns < -1.5, f"{turns} turns"
    assert abs(advance - turns * screw.PITCH) < screw.GAP * 2, f"advanced {advance} m in {turns} turns"
    assert min(deepest.values()) > -screw.GAP, f"through the thread: {deepest}"


def test_mass_is_that_of_the_mesh(scene):
    model = scene("fall.xml")
    vertices, triangles = igl.read_triangle_mesh("spot.obj")
    corners = vertices[triangles]
    volume = np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6
    assert model.body_mass[1] == pytest.approx(1000 * volume, rel=1e-5)


def test_without_a_mesh_mujoco_makes_one_of_the_field(scene):
    with_mesh = scene("fall.xml")
    without = scene("fall.xml", [WITHOUT_FILE])
    assert without.body_mass[1] == pytest.approx(with_mesh.body_mass[1], rel=0.02)
    data = mujoco.MjData(without)
    deepest = step(without, data, 2.0)
    assert COWS in deepest and min(deepest.values()) > -0.05, deepest


def test_threads_share_a_field(scene):
    model = scene("fall.xml")
    ends = {}

    def run(number):
        data = mujoco.MjData(model)
        mujoco.mj_step(model, data, nstep=500)
        ends[number] = data.qpos.copy()

    threads = [threading.Thread(target=run, args=(number,)) for number in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all((ends[number] == ends[0]).all() for number in range(4))


@pytest.mark.parametrize(
    ("name", "damage", "reason"),
    [
        ("missing.nfd", None, "cannot be read"),
        ("empty.nfd", lambda field: b"", "shorter"),
        ("short.nfd", lambda field: field[:-1], "as long as"),
        ("bit.nfd", lambda field: field[:-9] + bytes([field[-9] ^ 1]) + field[-8:], "checksum"),
    ],
)
def test_what_is_no_field_is_named(scene, parts, name, damage, reason):
    if damage is not None:
        (parts / name).write_bytes(damage((parts / "spot.nfd").read_bytes()))
    with pytest.raises((ValueError, mujoco.FatalError), match=f"(?i){name}.*{reason}"):
        scene("fall.xml", [('value="spot.nfd"', f'value="{name}"'), WITHOUT_FILE])


def test_a_field_that_was_baked_anew_is_read_anew(scene, parts):
    changed = pathlib.Path("changed.nfd")
    masses = []
    for name in ("bolt", "nut", "bolt"):
        changed.write_bytes((parts / f"{name}.nfd").read_bytes())
        model = scene("fall.xml", [('value="spot.nfd"', 'value="changed.nfd"'), WITHOUT_FILE])
        masses.append(model.body_mass[1])
    assert masses[0] == masses[2] != masses[1]

"""Baked fields beside MuJoCo's own octree of the same mesh, in one process: `run measure [MESH]`.

Bytes, seconds to make ready, errors against libigl's exact distances, nanoseconds a query in C, and a scene: two bodies fall on a
plane and on one another. The machine may be busy: times are of this thread's CPU, the least of several interleaved rounds."""

import ctypes
import functools
import os
import re
import sys
import tempfile
import time

import igl
import mujoco
import numpy as np

from conftest import HERE, SPOT, bake

DEPTHS = (5, 6, 7)
# Families of fields: how they are baked but for one number, and that from coarse to fine.
TARGETS = [f"{1.6e-3 / 2 ** (step / 2):.2g}" for step in range(20)]
GRID = "--layout grid --order 0 --sampling fitted --range file --margin 0.02 --resolution"
FAMILIES = {
    "--error": TARGETS,
    "--continuity none --error": TARGETS,
    GRID: [str(resolution) for resolution in range(20, 128, 2)],
}
POINTS = 100_000
ROUNDS = 7
FALLS = 3

asking = ctypes.CDLL(os.environ["NEARFIELD_MEASURE"])


def points_around(vertices, triangles):
    """Uniform in the box of the mesh, and within 1 % of its diagonal of the surface."""
    random = np.random.default_rng(1)
    low, high = vertices.min(0), vertices.max(0)
    corners = vertices[triangles]
    area = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    chosen = corners[random.choice(len(triangles), POINTS, p=area / area.sum())]
    on_surface = np.einsum("ij,ijk->ik", random.dirichlet([1, 1, 1], POINTS), chosen)
    direction = random.normal(size=(POINTS, 3))
    direction /= np.linalg.norm(direction, axis=1, keepdims=True)
    away = random.uniform(0, 0.01 * np.linalg.norm(high - low), (POINTS, 1))
    return {"uniform": random.uniform(low, high, (POINTS, 3)), "band": on_surface + away * direction}


def address_of(array):
    return array.ctypes.data_as(ctypes.c_void_p)


class Shape:
    """A geom of a compiled model, with what its making took."""

    def __init__(self, name, text, depth=1):
        self.name = name
        self.baked = None
        spec = mujoco.MjSpec.from_string(text)
        for mesh in spec.meshes:
            mesh.octree_maxdepth = depth
        start = time.process_time()
        self.model = spec.compile()
        self.data = mujoco.MjData(self.model)
        self.seconds = time.process_time() - start
        self.bytes = sum(getattr(self.model, f"oct_{part}").nbytes for part in ("depth", "child", "aabb", "coeff"))
        self.nanoseconds = {}

    def ask(self, what, points):
        """Distances or gradients at points in the frame of the mesh, and the CPU seconds that they took."""
        frame = np.empty(9)
        mujoco.mju_quat2Mat(frame, self.model.mesh_quat[0])
        points = np.ascontiguousarray((points - self.model.mesh_pos[0]) @ frame.reshape(3, 3))
        answers = np.empty(points.shape if what == "gradients" else len(points))
        model, data = ctypes.c_void_p(self.model._address), ctypes.c_void_p(self.data._address)
        start = time.thread_time()
        getattr(asking, f"measure_{what}")(model, data, 1, address_of(points), len(points), address_of(answers))
        return answers, time.thread_time() - start

    def errors(self, points, exact, diagonal):
        """Root mean square and largest, as fractions of the diagonal."""
        error = np.abs(self.ask("distances", points)[0] - exact) / diagonal
        return np.sqrt((error**2).mean()), error.max()


def time_queries(shapes, points):
    """Fills in `nanoseconds` of each shape, by kind of query and set of points."""
    for _ in range(ROUNDS):
        for kind, chosen in points.items():
            for what in ("distances", "gradients"):
                for shape in shapes:
                    taken = shape.ask(what, chosen)[1] / len(chosen) * 1e9
                    shape.nanoseconds[kind, what] = min(taken, shape.nanoseconds.get((kind, what), np.inf))


def fall(shape, vertices, triangles, seconds=4.0):
    """CPU milliseconds a step, deepest contact between the bodies, and how deep one lies in the other at the end."""
    model, data = shape.model, mujoco.MjData(shape.model)
    steps, deepest, taken = round(seconds / model.opt.timestep), 0.0, 0.0
    for _ in range(steps):
        start = time.thread_time()
        mujoco.mj_step(model, data)
        taken += time.thread_time() - start
        between = [contact.dist for contact in data.contact[: data.ncon] if (contact.geom > 0).all()]
        deepest = min([deepest, *between])
    placed = [vertices @ data.xmat[body].reshape(3, 3).T + data.xpos[body] for body in (1, 2)]
    sign = igl.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
    overlap = igl.signed_distance(placed[1], placed[0], triangles, sign_type=sign)[0].min()
    return taken / steps * 1e3, -deepest, -overlap


def children_seconds():
    """CPU seconds of the programs that were run."""
    times = os.times()
    return times.children_user + times.children_system


@functools.cache
def field(scene, options):
    """A scene with a field of the mesh, baked so."""
    name = f"spot{options.replace(' ', '')}.nfd"
    start = children_seconds()
    bake("spot.obj", name, *options.split())
    baked = children_seconds() - start
    shape = Shape(f"`{options}`", scene.replace("spot.nfd", name))
    shape.baked, shape.bytes = baked, os.path.getsize(name)
    return shape


def row(shape, errors, falls):
    """What was measured of a shape, as a line of a table."""
    step, deepest, overlap = min(falls)
    cells = [shape.name, f"{shape.bytes:_}".replace("_", " "), "" if shape.baked is None else f"{shape.baked:.1f}",
             f"{shape.seconds:.2f}", *(f"{rmse:.1e} / {largest:.1e}" for rmse, largest in errors.values()),
             *(f"{nanoseconds:.0f}" for nanoseconds in shape.nanoseconds.values()),
             f"{step:.2f}", f"{deepest:.4f}", f"{overlap:.4f}"]
    return "| " + " | ".join(cells) + " |"


def main(mesh):
    mujoco.mj_loadPluginLibrary(os.environ["NEARFIELD_PLUGIN"])
    vertices, triangles = igl.read_triangle_mesh(str(mesh))
    with_field = (HERE / "fall.xml").read_text()
    with_octree = re.sub(r"<plugin instance=.*?/>|<extension>.*?</extension>", "", with_field, flags=re.DOTALL)

    diagonal = np.linalg.norm(np.ptp(vertices, axis=0))
    points = points_around(vertices, triangles)
    sign = igl.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
    exact = {kind: igl.signed_distance(chosen, vertices, triangles, sign_type=sign)[0] for kind, chosen in points.items()}

    @functools.cache
    def errors_of(shape):
        return {kind: shape.errors(points[kind], exact[kind], diagonal) for kind in points}

    def is_as_exact(shape, other):
        """In all four measures."""
        return all(ours <= theirs for kind in points for ours, theirs in zip(errors_of(shape)[kind], errors_of(other)[kind]))

    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        igl.write_triangle_mesh("spot.obj", vertices, triangles)
        print("| shape | bytes | bake, CPU s | compile, CPU s | uniform RMSE / max | band RMSE / max "
              "| ns, uniform | +gradient | ns, band | +gradient | ms a step | deepest contact | overlap at rest |")
        print("|" + " --- |" * 13)
        for depth in DEPTHS:
            octree = Shape(f"octree, depth {depth}", with_octree, depth)
            shapes = [octree]
            for family, numbers in FAMILIES.items():
                fields = (field(with_field, f"{family} {number}") for number in numbers)
                shapes.append(next(shape for shape in fields if is_as_exact(shape, octree)))

            time_queries(shapes, points)
            falls = {shape: [] for shape in shapes}
            for _ in range(FALLS):
                for shape in shapes:
                    falls[shape].append(fall(shape, vertices, triangles))
            for shape in shapes:
                print(row(shape, errors_of(shape), falls[shape]), flush=True)


if __name__ == "__main__":
    main(os.path.abspath(sys.argv[1]) if len(sys.argv) > 1 else SPOT.resolve())

"""Times one call for many points beside the Rust batch, and beside other libraries that are installed.

    python runtime/python/measure.py MESH.ply FIELD.nfd [POINTS]

Points are uniform in the box of the mesh. Times are processor time, unless they say otherwise.
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import nearfield
import numpy as np


def read_ply(path):
    """Vertices and triangles of an ASCII or binary little-endian PLY of float vertices and triangle lists."""
    data = Path(path).read_bytes()
    header, body = data.split(b"end_header\n", 1)
    lines = header.decode().splitlines()
    counts = {line.split()[1]: int(line.split()[2]) for line in lines if line.startswith("element")}
    if "format ascii 1.0" in lines:
        rows = body.decode().split("\n")
        vertices = np.array([row.split()[:3] for row in rows[: counts["vertex"]]], dtype=np.float32)
        faces = [row.split()[1:4] for row in rows[counts["vertex"] : counts["vertex"] + counts["face"]]]
        return vertices, np.array(faces, dtype=np.uint32)
    width = sum(line.startswith("property float") for line in lines)
    vertices = np.frombuffer(body, "<f4", counts["vertex"] * width).reshape(-1, width)[:, :3].copy()
    face = np.dtype([("count", "u1"), ("corners", "<u4", 3)])
    faces = np.frombuffer(body, face, counts["face"], offset=counts["vertex"] * width * 4)
    return vertices, faces["corners"].copy()


def seconds(work, clock=time.process_time, repeats=5):
    """The least time of several, after one that warms up."""
    work()
    times = []
    for _ in range(repeats):
        start = clock()
        work()
        times.append(clock() - start)
    return min(times)


def rust_nanoseconds(field, points):
    manifest = Path(__file__).with_name("Cargo.toml")
    with tempfile.NamedTemporaryFile(suffix=".f32") as file:
        points.tofile(file.name)
        command = ["cargo", "run", "--release", "--locked", "--manifest-path", manifest, "--example", "rust_batch"]
        report = subprocess.run([*command, "--", field, file.name], stdout=subprocess.PIPE, check=True)
    return json.loads(report.stdout)


def others(vertices, faces):
    """Name and signed distance function of every other library that is here."""
    try:
        import pysdf

        mesh = pysdf.SDF(vertices, faces)
        yield "pysdf", lambda points: -mesh(points, n_threads=1)
    except ImportError:
        print("pysdf is not installed")

    try:
        import open3d

        scene = open3d.t.geometry.RaycastingScene(nthreads=1)
        scene.add_triangles(vertices, faces)
        yield "Open3D", lambda points: scene.compute_signed_distance(points, nthreads=1).numpy()
    except ImportError:
        print("Open3D is not installed")

    try:
        import warp

        warp.config.quiet = True
        warp.init()
        yield "Warp (CPU)", warp_distance(warp, vertices, faces)
    except ImportError:
        print("Warp is not installed")


def warp_distance(warp, vertices, faces):
    from measure_warp import distance

    mesh = warp.Mesh(
        points=warp.array(vertices, dtype=warp.vec3, device="cpu"),
        indices=warp.array(faces.ravel().astype(np.int32), dtype=int, device="cpu"),
    )

    def ask(points):
        answers = warp.empty(len(points), dtype=float, device="cpu")
        asked = warp.array(points, dtype=warp.vec3, device="cpu", copy=False)
        warp.launch(distance, dim=len(points), inputs=[mesh.id, asked, answers], device="cpu")
        return answers.numpy()

    return ask


def main():
    mesh_path, field_path, *rest = sys.argv[1:]
    count = int(rest[0]) if rest else 10_000_000
    vertices, faces = read_ply(mesh_path)
    generator = np.random.default_rng(1)
    points = generator.uniform(vertices.min(axis=0), vertices.max(axis=0), (count, 3)).astype(np.float32)
    field = nearfield.open(field_path)

    rust = rust_nanoseconds(field_path, points)
    calls = {
        "distances": lambda: field.distance(points, threads=1),
        "distances_and_gradients": lambda: field.distance_and_gradient(points, threads=1),
    }
    for name, call in calls.items():
        here, alone = seconds(call) / count * 1e9, rust[name]
        print(f"{count} {name}: {here:.1f} ns a point, Rust batch {alone:.1f}, ratio {here / alone:.2f}")
    wide = points.astype(np.float64)
    print(f"distance of float64: {seconds(lambda: field.distance(wide, threads=1)) / count * 1e9:.1f} ns a point")
    elapsed = seconds(lambda: field.distance(points), time.perf_counter)
    print(f"distance, all threads: {elapsed / count * 1e9:.1f} ns a point of elapsed time")

    few = points[: min(count, 1_000_000)]
    ours = field.distance(few, threads=1)
    mine = seconds(lambda: field.distance(few, threads=1)) / len(few) * 1e9
    print(f"on {len(few)} points, one thread: Nearfield {mine:.0f} ns a point")
    for name, ask in others(vertices, faces):
        theirs = seconds(lambda ask=ask: ask(few), repeats=2) / len(few) * 1e9
        differences = np.abs(ask(few) - ours)
        print(
            f"{name}: {theirs:.0f} ns a point, {theirs / mine:.0f} times ours; differs from ours by at most"
            f" {differences.max():.2e}, 99 % by at most {np.quantile(differences, 0.99):.2e}"
            f" (contract: {field.contract.max_error:.2e})"
        )


if __name__ == "__main__":
    main()

"""Meshes of a bolt and of the nut that it goes into, from the formula of their thread."""

import numpy as np

PITCH = 0.1
"""Metres that the bolt advances in a turn."""

RADIUS = 0.25
"""Of the middle of the bolt's thread, metres."""

DEPTH = 0.02
"""From there to the crest, metres."""

GAP = 0.004
"""Between bolt and nut, metres."""


def _grid(columns, rows):
    """Triangles between the points of a cylinder, row by row upwards; outwards is right of upwards."""
    around = np.arange(columns)
    beside = (around + 1) % columns
    quads = [
        np.stack([row * columns + around, row * columns + beside, (row + 1) * columns + beside, (row + 1) * columns + around], 1)
        for row in range(rows - 1)
    ]
    quads = np.concatenate(quads)
    return np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


def _cylinder(radius_at, low, high, columns=96, samples_a_pitch=24):
    """Points and triangles of a surface around the z axis, open at both ends."""
    rows = round((high - low) / PITCH * samples_a_pitch) + 1
    z, angle = np.meshgrid(np.linspace(low, high, rows), np.arange(columns) * 2 * np.pi / columns, indexing="ij")
    radius = radius_at(z, angle)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), z], -1).reshape(-1, 3)
    return points, _grid(columns, rows), columns


def _thread(middle):
    return lambda z, angle: middle + DEPTH * np.cos(2 * np.pi * z / PITCH - angle)


def bolt(length=0.8):
    """A threaded rod along z, centred: vertices (N, 3), triangles (M, 3)."""
    points, triangles, columns = _cylinder(_thread(RADIUS), -length / 2, length / 2)
    below, above, last = len(points), len(points) + 1, len(points) - columns
    around, beside = np.arange(columns), (np.arange(columns) + 1) % columns
    bottom = np.stack([np.full(columns, below), beside, around], 1)
    top = np.stack([np.full(columns, above), last + around, last + beside], 1)
    points = np.concatenate([points, [[0, 0, -length / 2], [0, 0, length / 2]]])
    return points, np.concatenate([triangles, bottom, top])


def nut(height=0.3, outer=0.45):
    """A round nut along z, centred: vertices (N, 3), triangles (M, 3)."""
    inside, triangles, columns = _cylinder(_thread(RADIUS + GAP), -height / 2, height / 2)
    outside, _, _ = _cylinder(lambda z, angle: np.full_like(z, outer), -height / 2, height / 2)
    shift, last = len(inside), len(inside) - columns
    around, beside = np.arange(columns), (np.arange(columns) + 1) % columns
    bottom = np.stack([around, beside, shift + beside, shift + around], 1)
    top = np.stack([last + around, shift + last + around, shift + last + beside, last + beside], 1)
    ring = [quads[:, corners] for quads in (bottom, top) for corners in ([0, 1, 2], [0, 2, 3])]
    faces = [triangles[:, ::-1], triangles + shift, *ring]
    return np.concatenate([inside, outside]), np.concatenate(faces)

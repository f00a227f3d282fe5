import nearfield
import numpy as np
import pytest


@pytest.fixture(scope="session")
def octahedron():
    vertices = np.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=np.float64)
    upper = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4]]
    lower = [[2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    return vertices, np.array(upper + lower, dtype=np.int32)


@pytest.fixture(scope="session")
def field(octahedron):
    return nearfield.bake(*octahedron, error=1e-3, samples=2000)


@pytest.fixture
def points():
    return np.random.default_rng(7).uniform(-1.5, 1.5, (20_001, 3))


def exact_distance(points):
    """To the octahedron |x| + |y| + |z| <= 1 where a face is closest: everywhere inside, and above the faces."""
    return (np.abs(points).sum(axis=-1) - 1) / np.sqrt(3)

"""Points in, answers out."""

import threading
import time

import numpy as np
import pytest
from conftest import exact_distance


def test_distances_are_within_the_contract(field, points):
    inside = points[np.abs(points).sum(axis=1) < 1]
    assert len(inside) > 500
    errors = np.abs(field.distance(inside) - exact_distance(inside))
    assert errors.max() <= 2 * field.contract.max_error
    assert 0 < field.contract.max_error < 0.05


def test_the_gradient_is_the_slope_of_the_distance(field, points):
    inside = points[np.abs(points).sum(axis=1) < 0.9].astype(np.float32)
    distance, gradient = field.distance_and_gradient(inside)
    np.testing.assert_array_equal(distance, field.distance(inside))

    step = np.float32(2.0**-8)
    slopes = []
    for axis in np.eye(3, dtype=np.float32):
        slopes.append((field.distance(inside + step * axis) - field.distance(inside - step * axis)) / (2 * step))
    # The slope is continuous, but bends at the edges of cells.
    assert np.median(np.abs(np.stack(slopes, axis=1) - gradient)) < 1e-3


def test_types_layouts_and_threads_change_no_bit(field, points):
    single = points.astype(np.float32)
    expected = field.distance(single, threads=1)
    assert expected.dtype == np.float32 and expected.shape == (len(points),)

    wide = single.astype(np.float64)
    padded = np.zeros((len(points), 5), dtype=np.float32)
    padded[:, 1:4] = single
    variants = {
        "float64": wide,
        "padded": padded[:, 1:4],
        "column-major": np.asfortranarray(single),
        "column-major float64": np.asfortranarray(wide),
        "reversed twice": single[::-1].copy()[::-1],
        "other byte order": wide.astype(">f8"),
        "list": wide.tolist(),
    }
    for name, variant in variants.items():
        np.testing.assert_array_equal(field.distance(variant), expected, err_msg=name)
    for threads in (1, 2, 3, 64):
        np.testing.assert_array_equal(field.distance(single, threads=threads), expected, err_msg=f"{threads} threads")


def test_answers_have_the_shape_of_the_points(field):
    grid = np.zeros((4, 5, 6, 3), dtype=np.float32)
    distance, gradient = field.distance_and_gradient(grid)
    assert distance.shape == (4, 5, 6) and gradient.shape == (4, 5, 6, 3)
    assert field.distance([0, 0, 0]).shape == ()
    assert float(field.distance([0, 0, 0])) == pytest.approx(-1 / np.sqrt(3), abs=field.contract.max_error)
    assert field.distance(np.empty((0, 3))).shape == (0,)


@pytest.mark.parametrize("wrong", [np.zeros((5, 2)), np.zeros(4), 1.0, np.zeros((3, 1))])
def test_other_shapes_are_refused(field, wrong):
    with pytest.raises(ValueError, match=r"\(\.\.\., 3\)"):
        field.distance(wrong)


def test_what_is_no_number_is_refused(field):
    with pytest.raises((TypeError, ValueError)):
        field.distance("three")
    with pytest.raises((OverflowError, ValueError)):
        field.distance([0, 0, 0], threads=0)


def test_odd_coordinates_have_documented_answers(field):
    odd = np.array([[np.nan, 0, 0], [np.inf, 0, 0], [1e30, 0, 0]], dtype=np.float32)
    nan, infinite, far = field.distance(odd)
    assert np.isnan(nan) and np.isposinf(infinite) and np.isfinite(far)


def test_clearance_is_the_distance_less_the_error(field, points):
    inside = points[np.abs(points).max(axis=1) < 1].astype(np.float32)
    np.testing.assert_array_equal(
        field.clearance(inside), field.distance(inside) - np.float32(field.contract.max_error)
    )


def test_closest_points_are_on_the_surface(field, points):
    ends, residuals = field.closest_point(points)
    assert ends.shape == points.shape and residuals.shape == (len(points),)
    np.testing.assert_array_equal(field.distance(ends), residuals)
    assert np.median(np.abs(exact_distance(ends))) < 2 * field.contract.max_error


def test_rays_hit_and_miss(field):
    origins = np.array([[-1.2, 0.1, 0.2], [-1.2, 0.9, 0.9]])
    rays = field.raycast(origins, np.broadcast_to([2.0, 0, 0], origins.shape))
    assert rays.hit.tolist() == [True, False]
    assert rays.distance[0] == pytest.approx(0.5, abs=0.02) and np.isposinf(rays.distance[1])
    np.testing.assert_allclose(rays.point[0], [-0.7, 0.1, 0.2], atol=0.02)
    np.testing.assert_allclose(rays.normal[0], np.array([-1, 1, 1]) / np.sqrt(3), atol=0.05)
    assert np.isnan(rays.point[1]).all() and np.isnan(rays.normal[1]).all()

    assert not field.raycast(origins[0], [1, 0, 0], length=0.3).hit
    early = field.raycast(origins[0], [1, 0, 0], within=0.1)
    assert early.hit and early.distance < rays.distance[0] - 0.1
    with pytest.raises(ValueError, match="broadcast_to"):
        field.raycast(origins, [1, 0, 0])


def test_other_threads_run_during_a_call(field):
    """While one call computes, the interpreter is free."""
    many = np.zeros((2_000_000, 3), dtype=np.float32)
    done = threading.Event()

    def work():
        for _ in range(5):
            field.distance(many, threads=1)
        done.set()

    worker = threading.Thread(target=work)
    worker.start()
    ticks = 0
    while not done.is_set():
        ticks += 1
        time.sleep(0.001)
    worker.join()
    # A call that held the lock would let through one tick a call, five in all.
    assert ticks > 10

"""Files, bytes, headers and meshes."""

import copy
import errno
import json
import multiprocessing
import pickle
from pathlib import Path

import nearfield
import numpy as np
import pytest

VECTORS = Path(__file__).parents[3] / "format-spec" / "vectors"


def test_a_field_survives_files_bytes_pickles_and_copies(field, tmp_path):
    field.save(tmp_path / "field.nfd")
    for again in (
        nearfield.open(tmp_path / "field.nfd"),
        nearfield.open(str(tmp_path / "field.nfd")),
        nearfield.from_bytes(field.tobytes()),
        pickle.loads(pickle.dumps(field)),
        copy.deepcopy(field),
    ):
        assert again.tobytes() == field.tobytes()
    assert field.nbytes == len(field.tobytes()) == (tmp_path / "field.nfd").stat().st_size


def test_levels_of_detail_are_fields(octahedron, field, points):
    assert field.lod_count == 1
    assert field.lod(0).tobytes() == field.tobytes()
    with pytest.raises(IndexError):
        field.lod(1)

    fine = nearfield.bake(*octahedron, error=1e-3, samples=2000, lods=1)
    assert fine.lod_count == 2
    assert (fine.distance(points) == field.distance(points)).all()
    coarse = fine.lod(1)
    assert coarse.target_error == pytest.approx(4 * fine.target_error)
    assert coarse.nbytes < fine.nbytes / 4
    inside = points[(np.abs(points) <= 1).all(axis=-1)]
    assert np.abs(coarse.distance(inside) - fine.distance(inside)).max() <= 2 * coarse.contract.max_error


def test_the_header_is_there(field):
    assert field.family == "polynomial"
    low, high = field.bounds
    assert field.bounds.shape == (2, 3) and (low <= -1).all() and (high >= 1).all()
    assert field.sign_method == "pseudonormal"
    assert field.family in repr(field)
    assert field.diagonal == pytest.approx(np.sqrt(12))
    assert field.target_error == pytest.approx(1e-3 * field.diagonal)
    assert field.lipschitz >= 1
    assert len(field.mesh_hash) == 16 and any(field.mesh_hash)
    assert len(field.settings_hash) == 8
    assert len(field.format_version) == 2 and len(field.baker_version) == 3

    contract = field.contract
    assert contract.sample_count == 2000 and contract.doubtful_signs == 0
    assert 0 < contract.uniform.rmse <= contract.uniform.max <= contract.max_error
    assert contract.band.p99 <= contract.band.max
    assert contract == field.contract
    assert "max_error" in repr(contract) and "rmse" in repr(contract.band)


def test_the_answers_of_every_vector_of_the_format():
    valid = sorted((VECTORS / "valid").glob("*.nfd"))
    assert len(valid) > 50
    for path in valid:
        answers = json.loads(path.with_suffix(".json").read_text())

        def column(key, answers=answers):
            # What JSON has no numbers for are words.
            return np.array([np.array(answer[key], dtype=np.float64) for answer in answers])

        distance, gradient = nearfield.open(path).distance_and_gradient(column("point"))
        for actual, name in ((distance, "distance"), (gradient, "gradient")):
            expected, tolerance = column(name), column(name + "_tolerance").reshape(-1, *[1] * (actual.ndim - 1))
            finite = np.isfinite(expected)
            np.testing.assert_array_equal(actual[~finite], expected[~finite], err_msg=path.name)
            errors = np.abs(np.subtract(actual, expected, out=np.zeros_like(expected), where=finite))
            assert (errors <= tolerance).all(), path.name


def test_no_invalid_vector_opens():
    invalid = sorted((VECTORS / "invalid").glob("*.nfd"))
    assert len(invalid) > 50
    for path in invalid:
        with pytest.raises(nearfield.FieldError):
            nearfield.open(path)


def test_a_damaged_field_is_refused(field):
    damaged = bytearray(field.tobytes())
    damaged[len(damaged) // 2] ^= 1
    with pytest.raises(nearfield.FieldError, match="checksum"):
        nearfield.from_bytes(bytes(damaged))
    with pytest.raises(ValueError):
        nearfield.from_bytes(b"solid cube")


def test_a_missing_file_is_an_os_error(tmp_path, field):
    with pytest.raises(FileNotFoundError) as caught:
        nearfield.open(tmp_path / "gone.nfd")
    assert caught.value.errno == errno.ENOENT and Path(caught.value.filename) == tmp_path / "gone.nfd"
    with pytest.raises(OSError):
        field.save(tmp_path / "no" / "folder.nfd")


def test_baking_is_deterministic(octahedron, field):
    vertices, faces = octahedron
    for variant in (faces, faces.astype(np.uint64), faces.tolist(), np.asfortranarray(faces)):
        for threads in (1, 2):
            again = nearfield.bake(vertices, variant, error=1e-3, samples=2000, threads=threads)
            assert again.tobytes() == field.tobytes()
    coarse = nearfield.bake(vertices.astype(np.float32), faces, error_abs=0.05, continuity="none", samples=100)
    assert coarse.nbytes < field.nbytes


@pytest.mark.parametrize(
    ("settings", "problem"),
    [
        ({"error": -1}, "target error"),
        ({"error": 1e-3, "error_abs": 1e-3}, "not both"),
        ({"continuity": "c2"}, "c2"),
        ({"max_depth": 99}, "max depth"),
        ({"margin": float("nan")}, "margin"),
        ({"samples": 0}, "sample"),
    ],
)
def test_settings_that_give_no_field(octahedron, settings, problem):
    with pytest.raises(ValueError, match=problem):
        nearfield.bake(*octahedron, **settings)


def test_meshes_that_give_no_field(octahedron):
    vertices, faces = octahedron
    with pytest.raises(ValueError, match="face 3 .* 6"):
        nearfield.bake(vertices, np.where(np.arange(8)[:, None] == 3, 6, faces))
    with pytest.raises(ValueError, match="face 0"):
        nearfield.bake(vertices, [[0, 1, -1]])
    with pytest.raises(ValueError, match="vertex 2"):
        nearfield.bake(np.where(np.arange(6)[:, None] == 2, np.nan, vertices), faces)
    with pytest.raises(ValueError, match="area"):
        nearfield.bake(vertices, [[0, 0, 1]])
    with pytest.raises(ValueError, match="split polygons"):
        nearfield.bake(vertices, [[0, 1, 2, 3]])
    with pytest.raises(TypeError, match="integers"):
        nearfield.bake(vertices, faces + 0.5)


def ask(field, points, answers):
    answers.put(field.distance(points).tobytes())


def test_a_forked_process_answers_too(field, points):
    """After threads and a bake in the parent: neither leaves a pool behind that the child would wait for."""
    expected = field.distance(points).tobytes()
    context = multiprocessing.get_context("fork")
    answers = context.Queue()
    child = context.Process(target=ask, args=(field, points, answers))
    child.start()
    assert answers.get(timeout=60) == expected
    child.join()

//! Arrays of a mesh to a field.

use crate::field::Field;
use crate::points::{Points, Triples};
use glam::DVec3;
use nearfield_bake::import::TriangleSoup;
use nearfield_bake::lod::add_levels;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Continuity, Settings, Target};
use numpy::{AllowTypeChange, PyArrayDescrMethods, PyArrayLike2, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::{PyRuntimeError, PyTypeError, PyValueError};
use pyo3::prelude::*;
use rayon::ThreadPoolBuilder;
use std::fmt::Display;
use std::num::NonZeroUsize;

/// Bakes a triangle mesh into a field: the same mesh and settings give the same bytes on any machine.
///
/// `error` is a fraction of the diagonal of the mesh's box, `error_abs` the same in mesh units; `lods` is how many levels
/// of detail to add. It runs to its end: an interrupt is noticed afterwards.
#[pyfunction]
#[pyo3(signature = (vertices, faces, *, error = None, error_abs = None, continuity = "c1", margin = None, max_depth = None, samples = None, lods = 0, threads = None))]
#[expect(clippy::too_many_arguments, reason = "they are keywords in Python")]
pub fn bake(
    py: Python<'_>,
    vertices: Points<'_>,
    faces: &Bound<'_, PyAny>,
    error: Option<f64>,
    error_abs: Option<f64>,
    continuity: &str,
    margin: Option<f64>,
    max_depth: Option<u8>,
    samples: Option<u32>,
    lods: u8,
    threads: Option<NonZeroUsize>,
) -> PyResult<Field> {
    let default = Settings::default();
    let settings = Settings {
        error: match (error, error_abs) {
            (None, None) => default.error,
            (Some(fraction), None) => Target::Relative(fraction),
            (None, Some(length)) => Target::Absolute(length),
            (Some(_), Some(_)) => return Err(PyValueError::new_err("give error or error_abs, not both")),
        },
        continuity: match continuity {
            "none" => Continuity::None,
            "c0" => Continuity::C0,
            "c1" => Continuity::C1,
            _ => return Err(PyValueError::new_err(format!("continuity is none, c0 or c1, not {continuity:?}"))),
        },
        margin: margin.unwrap_or(default.margin),
        max_depth: max_depth.unwrap_or(default.max_depth),
        samples: samples.unwrap_or(default.samples),
        ..default
    };
    settings.check().map_err(to_value_error)?;
    let soup = soup(&vertices, faces)?;

    // A pool of its own, gone with the call: threads do not survive a fork.
    let threads = threads.map_or(0, NonZeroUsize::get);
    let pool = ThreadPoolBuilder::new().num_threads(threads).build();
    let pool = pool.map_err(|problem| PyRuntimeError::new_err(problem.to_string()))?;
    let bytes = py.detach(|| {
        pool.install(|| {
            let mesh = CheckedMesh::new(soup).map_err(to_value_error)?;
            let bake = |settings: &Settings| nearfield_bake::bake(&mesh, settings, &Silent);
            let baked = bake(&settings).and_then(|field| add_levels(field, &settings, lods, bake));
            baked.map(|baked| baked.bytes).map_err(to_value_error)
        })
    })?;
    Field::new(bytes)
}

/// The mesh of two arrays, as an importer would deliver it.
fn soup(vertices: &Points<'_>, faces: &Bound<'_, PyAny>) -> PyResult<TriangleSoup> {
    if vertices.shape().len() != 1 {
        return Err(PyValueError::new_err("vertices have the shape (V, 3)"));
    }
    let positions: Vec<DVec3> = match vertices.triples() {
        Triples::F32(points) => points.iter().map(|&point| point.map(f64::from).into()).collect(),
        Triples::F64(points) => points.iter().map(|&point| point.into()).collect(),
    };
    if let Some(index) = positions.iter().position(|position| !position.is_finite()) {
        return Err(PyValueError::new_err(format!("vertex {index} is not finite")));
    }

    // Floats would be cut to integers in silence.
    let kind = faces.cast::<PyUntypedArray>().map_or(b'i', |array| array.dtype().kind());
    if !matches!(kind, b'i' | b'u') {
        return Err(PyTypeError::new_err("faces are an array of integers"));
    }
    let faces: PyArrayLike2<'_, i64, AllowTypeChange> = faces.extract()?;
    if faces.shape()[1] != 3 {
        return Err(PyValueError::new_err("faces have the shape (F, 3): split polygons into triangles first"));
    }
    let in_range = |&index: &i64| u32::try_from(index).ok().filter(|&index| (index as usize) < positions.len());
    let mut triangles = Vec::with_capacity(faces.shape()[0]);
    for (face, row) in faces.as_array().rows().into_iter().enumerate() {
        let corners = row.iter().map(in_range).collect::<Option<Vec<u32>>>();
        let triangle = corners.and_then(|corners| corners.try_into().ok()).ok_or_else(|| {
            PyValueError::new_err(format!("face {face} uses a vertex that is not among the {}", positions.len()))
        })?;
        triangles.push(triangle);
    }
    Ok(TriangleSoup { positions, triangles })
}

fn to_value_error(problem: impl Display) -> PyErr {
    PyValueError::new_err(problem.to_string())
}

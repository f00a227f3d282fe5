//! A field as Python sees it.

use crate::FieldError;
use crate::batch::{answer, answer_pairs, answer_rays, to_array, to_vector_array};
use crate::contract::Contract;
use crate::points::Points;
use nearfield_bake::output;
use numpy::{PyArray2, PyArrayDyn};
use pyo3::exceptions::{PyIndexError, PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::{fs, io};

/// Opens a field file after checking every byte of it.
#[pyfunction]
pub fn open(py: Python<'_>, path: PathBuf) -> PyResult<Field> {
    py.detach(|| Field::new(fs::read(&path).map_err(|error| os_error(&error, &path))?))
}

/// A field from the bytes of its file, which are copied and checked.
#[pyfunction]
pub fn from_bytes(data: &[u8]) -> PyResult<Field> {
    Field::new(data.to_vec())
}

/// A signed distance field. Immutable: share it between threads, pickle it, fork with it.
///
/// Make one with `nearfield.open`, `nearfield.from_bytes` or `nearfield.bake`.
#[pyclass(frozen, module = "nearfield")]
pub struct Field {
    bytes: Arc<[u8]>,
}

impl Field {
    /// Takes bytes that are a sound field, and nothing else.
    pub fn new(bytes: Vec<u8>) -> PyResult<Self> {
        reader::Field::open(&bytes)
            .and_then(|field| field.validate())
            .map_err(|error| FieldError::new_err(error.to_string()))?;
        Ok(Self { bytes: bytes.into() })
    }

    /// The reader's view of the bytes. Opening takes constant time, about a microsecond: less than a call from Python.
    fn view(&self) -> reader::Field<'_> {
        reader::Field::open(&self.bytes).expect("these bytes were opened before, and have not changed since")
    }
}

#[pymethods]
impl Field {
    /// Signed distances from points to the surface: mesh units, negative inside.
    #[pyo3(signature = (points, *, threads = None))]
    fn distance<'py>(
        &self,
        py: Python<'py>,
        points: Points<'py>,
        threads: Option<NonZeroUsize>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f32>>> {
        let field = self.view();
        let distances = answer(py, &points, threads, |points, distances| {
            field.distances(points, distances);
        });
        to_array(py, distances, points.shape())
    }

    /// Signed distances and their gradients, which are near unit length but not normalized.
    #[pyo3(signature = (points, *, threads = None))]
    #[expect(clippy::type_complexity, reason = "the two arrays that Python unpacks")]
    fn distance_and_gradient<'py>(
        &self,
        py: Python<'py>,
        points: Points<'py>,
        threads: Option<NonZeroUsize>,
    ) -> PyResult<(Bound<'py, PyArrayDyn<f32>>, Bound<'py, PyArrayDyn<f32>>)> {
        let field = self.view();
        let (distances, gradients) = answer_pairs(py, &points, threads, |points, distances, gradients| {
            field.distances_and_gradients(points, distances, gradients);
        });
        Ok((to_array(py, distances, points.shape())?, to_vector_array(py, gradients, points.shape())?))
    }

    /// How far points are at least from the true surface, as far as the contract goes: the distance less the largest
    /// measured error. At most 0 where nothing is known, negative inside, never NaN.
    #[pyo3(signature = (points, *, threads = None))]
    fn clearance<'py>(
        &self,
        py: Python<'py>,
        points: Points<'py>,
        threads: Option<NonZeroUsize>,
    ) -> PyResult<Bound<'py, PyArrayDyn<f32>>> {
        let field = self.view();
        let clearances = answer(py, &points, threads, |points, clearances| {
            for (&point, clearance) in points.iter().zip(clearances) {
                *clearance = field.clearance(point);
            }
        });
        to_array(py, clearances, points.shape())
    }

    /// Goes down the gradient to the surface: where it ends, and the field there.
    ///
    /// The end is no farther from the surface than the start; that it is the closest point is not promised.
    #[pyo3(signature = (points, *, threads = None))]
    #[expect(clippy::type_complexity, reason = "the two arrays that Python unpacks")]
    fn closest_point<'py>(
        &self,
        py: Python<'py>,
        points: Points<'py>,
        threads: Option<NonZeroUsize>,
    ) -> PyResult<(Bound<'py, PyArrayDyn<f32>>, Bound<'py, PyArrayDyn<f32>>)> {
        let field = self.view();
        let (ends, residuals) = answer_pairs(py, &points, threads, |points, ends: &mut [[f32; 3]], residuals| {
            for ((&point, end), residual) in points.iter().zip(ends).zip(residuals) {
                let closest = field.closest_point(point);
                (*end, *residual) = (closest.point, closest.residual);
            }
        });
        Ok((to_vector_array(py, ends, points.shape())?, to_array(py, residuals, points.shape())?))
    }

    /// Follows rays to the surface by sphere tracing, inside the box of the field.
    ///
    /// `directions` need no unit length; `length` and `within` are mesh units. A ray stops where the field is at most
    /// `within`: with `contract.max_error` before the true surface, with 0 on the field's.
    #[pyo3(signature = (origins, directions, *, length = f32::INFINITY, within = 0.0, threads = None))]
    fn raycast<'py>(
        &self,
        py: Python<'py>,
        origins: Points<'py>,
        directions: Points<'py>,
        length: f32,
        within: f32,
        threads: Option<NonZeroUsize>,
    ) -> PyResult<Raycast> {
        let shape = origins.shape();
        if shape != directions.shape() {
            return Err(PyValueError::new_err(
                "origins and directions differ in shape; numpy.broadcast_to makes them alike",
            ));
        }
        let field = self.view();
        let rays = answer_rays(py, &origins, &directions, threads, |origin, direction| {
            Ray::from(field.raycast(origin, direction, length, within))
        });

        Ok(Raycast {
            hit: to_array(py, rays.iter().map(|ray| ray.hit).collect(), shape)?.unbind(),
            distance: to_array(py, rays.iter().map(|ray| ray.distance).collect(), shape)?.unbind(),
            point: to_vector_array(py, rays.iter().map(|ray| ray.point).collect(), shape)?.unbind(),
            normal: to_vector_array(py, rays.iter().map(|ray| ray.normal).collect(), shape)?.unbind(),
        })
    }

    /// A level of detail: 0 is the field itself, 1 the next coarser, and so on. Its bytes are copied.
    fn lod(&self, level: usize) -> PyResult<Self> {
        let lod = self.view().lod(level);
        let missing = || PyIndexError::new_err(format!("the field has the levels 0 to {}", self.lod_count() - 1));
        Ok(Self { bytes: lod.ok_or_else(missing)?.bytes().into() })
    }

    /// How many levels of detail there are, the field itself among them.
    #[getter]
    fn lod_count(&self) -> usize {
        self.view().lod_count()
    }

    /// The bytes of the file.
    fn tobytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.bytes)
    }

    /// Writes the file, whole or not at all.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        py.detach(|| output::write(&path, &self.bytes).map_err(|error| os_error(&error, &path)))
    }

    /// Length of the file in bytes.
    #[getter]
    fn nbytes(&self) -> usize {
        self.bytes.len()
    }

    /// Least and greatest corner of the box in which the field was sampled, as an array of shape (2, 3).
    #[getter]
    fn bounds<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray2<f32>>> {
        let reader::Aabb { min, max } = self.view().header().bounds;
        Ok(PyArray2::from_vec2(py, &[min.to_vec(), max.to_vec()])?)
    }

    /// How wrong the field was found to be when it was baked.
    #[getter]
    fn contract(&self) -> Contract {
        self.view().contract().into()
    }

    /// How the field is represented: "grid" or an "octree".
    #[getter]
    fn family(&self) -> String {
        format!("{:?}", self.view().header().family).to_lowercase()
    }

    /// How the baker told inside from outside.
    #[getter]
    fn sign_method(&self) -> String {
        format!("{:?}", self.view().header().sign_method).to_lowercase()
    }

    /// Diagonal of the mesh's bounding box, mesh units.
    #[getter]
    fn diagonal(&self) -> f32 {
        self.view().header().diagonal
    }

    /// Error that the baker was asked for, mesh units.
    #[getter]
    fn target_error(&self) -> f32 {
        self.view().header().target_error
    }

    /// Upper bound of the slope of the field inside its box.
    #[getter]
    fn lipschitz(&self) -> f32 {
        self.view().header().lipschitz
    }

    /// Major and minor version of the format.
    #[getter]
    fn format_version(&self) -> (u16, u16) {
        self.view().header().version.into()
    }

    /// Version of the baker.
    #[getter]
    fn baker_version(&self) -> (u16, u16, u16) {
        self.view().header().baker_version.into()
    }

    /// Hash of the welded mesh; zeros for a field that did not come from one.
    #[getter]
    fn mesh_hash(&self) -> [u8; 16] {
        self.view().header().mesh_hash
    }

    /// Hash of the settings.
    #[getter]
    fn settings_hash(&self) -> [u8; 8] {
        self.view().header().settings_hash
    }

    fn __repr__(&self) -> String {
        format!("<nearfield.Field: {}, {} bytes>", self.family(), self.nbytes())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        let from_bytes = py.import("nearfield")?.getattr("from_bytes")?;
        Ok((from_bytes, (self.tobytes(py),)))
    }
}

/// The error as Python would raise it, with its number and the path.
fn os_error(error: &io::Error, path: &Path) -> PyErr {
    match error.raw_os_error() {
        Some(number) => PyOSError::new_err((number, error.to_string(), path.to_owned())),
        None => PyOSError::new_err(format!("{}: {error}", path.display())),
    }
}

/// What became of rays: one entry a ray in each array.
#[pyclass(frozen, get_all, module = "nearfield")]
pub struct Raycast {
    /// Whether the ray met the surface.
    hit: Py<PyArrayDyn<bool>>,
    /// How far the ray is clear, mesh units: to its hit; infinite for a miss; else to where 512 steps led.
    distance: Py<PyArrayDyn<f32>>,
    /// Where it hit; NaN where it did not.
    point: Py<PyArrayDyn<f32>>,
    /// Unit gradient there; NaN where it did not hit.
    normal: Py<PyArrayDyn<f32>>,
}

#[derive(Clone, Copy, Default)]
struct Ray {
    hit: bool,
    distance: f32,
    point: [f32; 3],
    normal: [f32; 3],
}

impl From<reader::Raycast> for Ray {
    fn from(raycast: reader::Raycast) -> Self {
        let nowhere = [f32::NAN; 3];
        let clear = |distance| Self { hit: false, distance, point: nowhere, normal: nowhere };
        match raycast {
            reader::Raycast::Hit(hit) => {
                Self { hit: true, distance: hit.distance, point: hit.point, normal: hit.normal }
            }
            reader::Raycast::Miss { .. } => clear(f32::INFINITY),
            reader::Raycast::OutOfSteps { clear: distance } => clear(distance),
        }
    }
}

//! Arrays of points, read where they lie.

use numpy::{
    AllowTypeChange, PyArrayDyn, PyArrayLikeDyn, PyArrayMethods, PyReadonlyArrayDyn, PyUntypedArrayMethods, ndarray,
};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use std::borrow::Cow;
use std::ops::Range;

/// An array of shape (..., 3) as a caller gave it: `float32` and `float64` are borrowed, all else becomes `float64`.
pub enum Points<'py> {
    F32(PyReadonlyArrayDyn<'py, f32>),
    F64(PyArrayLikeDyn<'py, f64, AllowTypeChange>),
}

impl<'a, 'py> FromPyObject<'a, 'py> for Points<'py> {
    type Error = PyErr;

    fn extract(object: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        let points = match object.cast::<PyArrayDyn<f32>>() {
            Ok(array) => Self::F32(array.try_readonly()?),
            Err(_) => Self::F64(object.extract()?),
        };
        match points.full_shape() {
            [.., 3] => Ok(points),
            shape => Err(PyValueError::new_err(format!("points have the shape (..., 3), not {shape:?}"))),
        }
    }
}

impl Points<'_> {
    /// The shape without the last axis: that of the answers.
    pub fn shape(&self) -> &[usize] {
        self.full_shape().split_last().map_or(&[], |(_, shape)| shape)
    }

    fn full_shape(&self) -> &[usize] {
        match self {
            Self::F32(array) => array.shape(),
            Self::F64(array) => array.shape(),
        }
    }

    /// The points in row-major order. Copied only where the array is not laid out in that order.
    pub fn triples(&self) -> Triples<'_> {
        match self {
            Self::F32(array) => Triples::F32(in_order(array.as_array())),
            Self::F64(array) => Triples::F64(in_order(array.as_array())),
        }
    }
}

/// Points without Python: what other threads may read.
pub enum Triples<'a> {
    F32(Cow<'a, [[f32; 3]]>),
    F64(Cow<'a, [[f64; 3]]>),
}

impl Triples<'_> {
    pub fn len(&self) -> usize {
        match self {
            Self::F32(points) => points.len(),
            Self::F64(points) => points.len(),
        }
    }

    /// Some of the points as the reader takes them, rounded into `room` where they are not.
    pub fn block<'a>(&'a self, range: Range<usize>, room: &'a mut Vec<[f32; 3]>) -> &'a [[f32; 3]] {
        match self {
            Self::F32(points) => &points[range],
            Self::F64(points) => {
                room.clear();
                room.extend(points[range].iter().map(|point| point.map(|coordinate| coordinate as f32)));
                room
            }
        }
    }
}

fn in_order<T: Copy>(array: ndarray::ArrayViewD<'_, T>) -> Cow<'_, [[T; 3]]> {
    match array.to_slice() {
        Some(slice) => Cow::Borrowed(slice.as_chunks().0),
        None => Cow::Owned(array.rows().into_iter().map(|row| [row[0], row[1], row[2]]).collect()),
    }
}

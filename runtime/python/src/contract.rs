//! How wrong a field may be, as Python sees it.

use pyo3::prelude::*;

/// Errors measured over a set of points, in mesh units.
#[pyclass(frozen, get_all, eq, module = "nearfield")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorStatistics {
    /// Root mean square error.
    rmse: f32,
    /// 99th percentile of the absolute error.
    p99: f32,
    /// Largest absolute error.
    max: f32,
}

#[pymethods]
impl ErrorStatistics {
    fn __repr__(&self) -> String {
        let Self { rmse, p99, max } = self;
        format!("ErrorStatistics(rmse={rmse:e}, p99={p99:e}, max={max:e})")
    }
}

impl From<reader::ErrorStatistics> for ErrorStatistics {
    fn from(reader::ErrorStatistics { rmse, p99, max }: reader::ErrorStatistics) -> Self {
        Self { rmse, p99, max }
    }
}

/// How wrong the field was found to be when it was baked, in mesh units: measurements, not proofs.
#[pyclass(frozen, get_all, eq, module = "nearfield")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contract {
    /// Over points spread evenly over the mesh's bounding box.
    uniform: ErrorStatistics,
    /// Over points within 1 % of the diagonal of the surface.
    band: ErrorStatistics,
    /// Largest error measured anywhere; infinite when nothing was measured.
    max_error: f32,
    /// Largest jump of the value across a face between leaves.
    seam_max: f32,
    /// Points measured, uniform and again in the band.
    sample_count: u32,
    /// Measured points whose sign the sign method could not vouch for.
    doubtful_signs: u32,
}

#[pymethods]
impl Contract {
    fn __repr__(&self) -> String {
        let Self { max_error, sample_count, .. } = self;
        format!("Contract(max_error={max_error:e}, sample_count={sample_count}, ...)")
    }
}

impl From<reader::ErrorContract> for Contract {
    fn from(contract: reader::ErrorContract) -> Self {
        Self {
            uniform: contract.uniform.into(),
            band: contract.band.into(),
            max_error: contract.max_error(),
            seam_max: contract.seam_max,
            sample_count: contract.sample_count,
            doubtful_signs: contract.doubtful_signs,
        }
    }
}

//! The Python module `nearfield`: arrays of points in, arrays of distances out.
//!
//! What a Python programmer reads is `nearfield.pyi` and the doc strings here.

mod bake;
mod batch;
mod contract;
mod field;
mod points;

use pyo3::prelude::*;

pyo3::create_exception!(nearfield, FieldError, pyo3::exceptions::PyValueError, "Bytes that are not a sound field.");

/// Signed distance fields that ship: bake a mesh into a small file, ask it for distance and gradient.
#[pymodule]
mod nearfield {
    #[pymodule_export]
    use super::FieldError;
    #[pymodule_export]
    use super::bake::bake;
    #[pymodule_export]
    use super::contract::{Contract, ErrorStatistics};
    #[pymodule_export]
    use super::field::{Field, Raycast, from_bytes, open};

    #[pymodule_export]
    #[expect(non_upper_case_globals, reason = "this is how Python names it")]
    const __version__: &str = env!("CARGO_PKG_VERSION");
}

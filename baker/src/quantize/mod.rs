//! The only place that rounds: from `f64` to the codes of the file.

pub mod sample;

//! The only place that rounds: what each precision can store, as the reader will decode it.

pub mod codes;
pub mod grid;
pub mod piece;
pub mod rounding;
pub mod sample;

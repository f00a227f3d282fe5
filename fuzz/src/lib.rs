//! What must hold of any bytes: one property a fuzz target.
//!
//! A property panics when it does not hold. The targets look for such bytes, `cargo test` replays those that were found.

#[cfg(feature = "baker")]
mod baking;
mod c_interface;
#[cfg(feature = "baker")]
mod importing;
#[cfg(feature = "baker")]
/// Shared with the tests.
#[path = "../../tests/support/oracle.rs"]
mod oracle;
mod reading;
pub mod structure;

#[cfg(feature = "baker")]
pub use baking::bake_small;
pub use c_interface::c_interface;
#[cfg(feature = "baker")]
pub use importing::import;
pub use reading::{open_and_query, structure_aware, validate_then_query};

/// What must hold of any bytes.
pub type Property = fn(&[u8]);

/// Every property under the name of its target.
pub const PROPERTIES: &[(&str, Property)] = &[
    ("open_and_query", open_and_query),
    ("validate_then_query", validate_then_query),
    ("structure_aware", structure_aware),
    ("c_interface", c_interface),
    #[cfg(feature = "baker")]
    ("import", import),
    #[cfg(feature = "baker")]
    ("bake_small", bake_small),
];

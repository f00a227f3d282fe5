//! Many meshes at once: which there are, which have changed, and what was baked before.

mod cache;
mod change;
mod manifest;
pub mod memory;
mod shard;

pub use cache::Cache;
pub use change::{Change, Inputs, Reason, examine, is_up_to_date};
pub use manifest::{Asset, Manifest, ManifestError};
pub use shard::Shard;

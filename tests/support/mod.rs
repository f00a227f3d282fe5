//! What several promises need.

/// A polynomial octree without a baker.
pub(crate) mod fitted;
pub(crate) mod numbers;
pub(crate) mod oracle;
pub(crate) mod shapes;

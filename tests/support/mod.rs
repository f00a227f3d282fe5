//! What several promises need.

pub(crate) mod numbers;
pub(crate) mod oracle;
pub(crate) mod shapes;

//! A checked mesh to a signed distance at any point.

/// Where the sign comes from, as asked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SignChoice {
    /// Pseudonormals where they can be trusted, winding numbers elsewhere.
    Auto,
    /// Angle-weighted pseudonormals (Bærentzen and Aanæs 2005).
    Pseudonormal,
    /// Generalized winding numbers (Jacobson et al. 2013).
    Winding,
}

//! How long work tells how far it is.

/// Listens to the stages of a bake.
pub trait Progress: Sync {
    /// A stage begins; its length is known only when it can be counted in advance.
    fn stage(&self, name: &'static str, length: Option<u64>);

    /// The stage has moved on by this much.
    fn advance(&self, by: u64);
}

/// Listens to nothing.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn stage(&self, _name: &'static str, _length: Option<u64>) {}

    fn advance(&self, _by: u64) {}
}

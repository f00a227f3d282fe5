//! A Nearfield field as a shape of parry and rapier.
//!
//! ```
//! use nearfield_rapier::{FieldDispatcher, FieldShape};
//! use rapier3d::parry::query::DefaultQueryDispatcher;
//! use rapier3d::parry::query::QueryDispatcher;
//! use rapier3d::prelude::*;
//!
//! fn rock(file: &'static [u8]) -> Result<(Collider, NarrowPhase), nearfield::Error> {
//!     let field = nearfield::Field::open(file)?;
//!     let collider = ColliderBuilder::new(SharedShape::new(FieldShape::new(field))).build();
//!     let narrow_phase = NarrowPhase::with_query_dispatcher(FieldDispatcher.chain(DefaultQueryDispatcher));
//!     Ok((collider, narrow_phase))
//! }
//! # assert!(rock(b"solid cube").is_err());
//! ```
//!
//! Balls and capsules touch a field; points and rays are answered for every use of parry. Other shapes pass through it:
//! neither they nor two fields nor a sweep (continuous collision detection) are covered.

mod contact;
mod dispatcher;
mod mass;
mod shape;

pub use dispatcher::FieldDispatcher;
pub use shape::FieldShape;

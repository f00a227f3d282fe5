//! The promises of Nearfield, one module a promise.

mod distance;
mod support;

//! The promises of Nearfield, one module a promise.

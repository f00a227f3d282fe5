//! Reads Nearfield signed distance fields.
#![no_std]
#![forbid(unsafe_code)]

pub mod layout;

//! Whole fields, written by hand and read back.

mod damage;
mod file;
mod grid;
mod octree;
mod open;
mod outside;
mod specification;
mod tricubic;
mod trilinear;

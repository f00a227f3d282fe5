//! The samples of a tree's lattice: each vertex is evaluated once, ever.

use super::domain::Domain;
use crate::field_function::{FieldFunction, Sample};
use crate::progress::Progress;
use crate::quantize::rounding::Rounding;
use glam::UVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

/// Vertices evaluated between two reports of progress.
const BATCH: usize = 1 << 16;

/// Identifies a sampled vertex: the order in which vertices were first needed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct VertexId(pub u32);

impl VertexId {
    /// As an index.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// All vertices sampled so far.
pub struct Lattice<'a> {
    function: &'a dyn FieldFunction,
    domain: Domain,
    rounding: Rounding,
    ids: FxHashMap<u64, VertexId>,
    vertices: Vec<UVec3>,
    samples: Vec<Sample>,
}

impl<'a> Lattice<'a> {
    /// A lattice without samples.
    pub fn new(function: &'a dyn FieldFunction, domain: Domain, rounding: Rounding) -> Self {
        Self { function, domain, rounding, ids: FxHashMap::default(), vertices: Vec::new(), samples: Vec::new() }
    }

    /// Samples those of the vertices that were not sampled before.
    pub fn evaluate(&mut self, vertices: impl ParallelIterator<Item = UVec3>, progress: &dyn Progress) {
        let mut keys: Vec<u64> = vertices.map(morton).filter(|key| !self.ids.contains_key(key)).collect();
        keys.par_sort_unstable();
        keys.dedup();

        // In Morton order, so that the function is asked about neighbours one after the other.
        self.ids.reserve(keys.len());
        for batch in keys.chunks(BATCH) {
            let vertices: Vec<UVec3> = batch.iter().map(|&key| vertex(key)).collect();
            let points: Vec<_> = vertices.iter().map(|&vertex| self.domain.point(vertex)).collect();
            let mut samples = self.function.sample_all(&points);
            samples.par_iter_mut().for_each(|sample| sample.gradient = self.rounding.gradient(sample.gradient));
            self.samples.append(&mut samples);
            for (&key, vertex) in batch.iter().zip(vertices) {
                let id = u32::try_from(self.vertices.len()).expect("fewer than 2^32 lattice vertices");
                self.ids.insert(key, VertexId(id));
                self.vertices.push(vertex);
            }
            progress.advance(batch.len() as u64);
        }
    }

    /// The identity of a vertex that has been evaluated.
    pub fn id(&self, vertex: UVec3) -> VertexId {
        self.ids[&morton(vertex)]
    }

    /// Lattice coordinates of a vertex.
    pub fn vertex(&self, id: VertexId) -> UVec3 {
        self.vertices[id.index()]
    }

    /// What the function said there: the distance as it is, the gradient as the reader will decode it, since
    /// its rounding is the same at every level.
    pub fn sample(&self, id: VertexId) -> Sample {
        self.samples[id.index()]
    }

    /// How many vertices have been evaluated.
    pub fn len(&self) -> usize {
        self.samples.len()
    }
}

/// Interleaves the bits of three coordinates below 2^21.
fn morton(vertex: UVec3) -> u64 {
    let spread = |t: u32| {
        let t = u64::from(t);
        let t = (t | t << 32) & 0x001f_0000_0000_ffff;
        let t = (t | t << 16) & 0x001f_0000_ff00_00ff;
        let t = (t | t << 8) & 0x100f_00f0_0f00_f00f;
        let t = (t | t << 4) & 0x10c3_0c30_c30c_30c3;
        (t | t << 2) & 0x1249_2492_4924_9249
    };
    spread(vertex.x) | spread(vertex.y) << 1 | spread(vertex.z) << 2
}

/// The inverse of [`morton`].
fn vertex(key: u64) -> UVec3 {
    let gather = |key: u64| {
        let t = key & 0x1249_2492_4924_9249;
        let t = (t | t >> 2) & 0x10c3_0c30_c30c_30c3;
        let t = (t | t >> 4) & 0x100f_00f0_0f00_f00f;
        let t = (t | t >> 8) & 0x001f_0000_ff00_00ff;
        let t = (t | t >> 16) & 0x001f_0000_0000_ffff;
        (t | t >> 32) as u32 & 0x001f_ffff
    };
    UVec3::new(gather(key), gather(key >> 1), gather(key >> 2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn morton_codes_are_reversible_and_ordered_by_octants() {
        for v in [UVec3::ZERO, UVec3::new(1, 2, 3), UVec3::splat((1 << 21) - 1), UVec3::new(1 << 20, 7, 12345)] {
            assert_eq!(vertex(morton(v)), v);
        }
        assert!(morton(UVec3::new(7, 7, 7)) < morton(UVec3::new(8, 0, 0)));
    }
}

//! The samples of a tree's lattice: each vertex is evaluated once, ever.

use super::domain::Domain;
use crate::field_function::{FieldFunction, Sample};
use crate::morton;
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
        let mut keys: Vec<u64> = vertices.map(morton::encode).filter(|key| !self.ids.contains_key(key)).collect();
        keys.par_sort_unstable();
        keys.dedup();

        // In Morton order, so that the function is asked about neighbours one after the other.
        self.ids.reserve(keys.len());
        for batch in keys.chunks(BATCH) {
            let vertices: Vec<UVec3> = batch.iter().map(|&key| morton::decode(key)).collect();
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
        self.ids[&morton::encode(vertex)]
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
    pub fn sample_count(&self) -> usize {
        self.samples.len()
    }
}

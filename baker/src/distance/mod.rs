//! The exact signed distance to a mesh: closest triangle by a tree, sign by pseudonormals or
//! winding numbers.

mod bvh_build;
mod bvh_nearest;
mod local_mesh;
mod pseudonormal;
pub mod triangle;
mod winding;

use crate::field_function::{FieldFunction, Sample};
use crate::mesh::{CheckedMesh, Topology};
use bvh_nearest::{Bvh, Nearest, Scratch};
use glam::DVec3;
use local_mesh::LocalMesh;
use pseudonormal::Pseudonormals;
use rayon::prelude::*;
use winding::WindingTree;

/// Points that one task samples in turn. It bears on speed alone.
const CHUNK: usize = 1024;
/// Closer to the surface than this fraction of the mesh's longest side, the gradient is the
/// pseudonormal: the direction to the closest point drowns in its rounding.
const ON_SURFACE: f64 = 1e-9;

/// How the inside is told from the outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SignMethod {
    /// Angle-weighted pseudonormals: exact on closed, manifold, consistently wound meshes.
    Pseudonormal,
    /// Generalized winding numbers: inside where the number exceeds ½; bears holes and overlaps.
    Winding,
}

/// What was asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SignChoice {
    /// Pseudonormals where they are exact, winding numbers elsewhere.
    #[default]
    Auto,
    /// Pseudonormals on any mesh.
    Pseudonormal,
    /// Winding numbers on any mesh.
    Winding,
}

impl SignChoice {
    /// The method for a mesh.
    pub fn resolve(self, topology: &Topology) -> SignMethod {
        match self {
            Self::Auto if topology.is_closed_and_oriented() => SignMethod::Pseudonormal,
            Self::Pseudonormal => SignMethod::Pseudonormal,
            Self::Auto | Self::Winding => SignMethod::Winding,
        }
    }
}

/// The exact signed distance to a mesh.
///
/// Distances agree with an exhaustive search to rounding (some 1e-15 of the mesh's size), and do not
/// depend on the sign method. The answer at a point depends on the mesh and the point alone.
pub struct SignedDistance {
    mesh: LocalMesh,
    bvh: Bvh,
    pseudonormals: Pseudonormals,
    winding: Option<WindingTree>,
}

impl SignedDistance {
    /// Builds the search tree and what the sign needs.
    ///
    /// # Panics
    /// For 2³⁰ triangles or more.
    pub fn new(mesh: &CheckedMesh, method: SignMethod) -> Self {
        assert!(mesh.triangles.len() < 1 << 30, "a mesh of fewer than 2^30 triangles");
        let mesh = LocalMesh::new(mesh);
        let bvh = bvh_build::build(&mesh);
        let pseudonormals = Pseudonormals::new(&mesh);
        let winding = (method == SignMethod::Winding).then(|| WindingTree::new(&mesh, &bvh));
        Self { mesh, bvh, pseudonormals, winding }
    }

    /// Samples points one after the other: each starts from the answer of the one before.
    fn sample_in_turn(&self, points: &[DVec3], samples: &mut [Sample]) {
        let (mut scratch, mut seed) = (Scratch::new(), None);
        for (sample, &point) in samples.iter_mut().zip(points) {
            (*sample, seed) = self.sample_seeded(point, seed, &mut scratch);
        }
    }

    fn sample_seeded(&self, point: DVec3, seed: Option<u32>, scratch: &mut Scratch) -> (Sample, Option<u32>) {
        let local = self.mesh.frame.to_local(point);
        if !local.is_finite() {
            return (Sample { distance: f64::NAN, gradient: DVec3::ZERO }, seed);
        }
        let nearest = self.bvh.nearest(&self.mesh, local, seed, scratch);
        (self.signed(local, nearest), Some(nearest.triangle))
    }

    fn signed(&self, local: DVec3, Nearest { triangle, closest }: Nearest) -> Sample {
        let offset = local - closest.point;
        let distance = closest.distance_squared.sqrt();
        let on_surface = distance <= ON_SURFACE;

        // The pseudonormal is read only where it is needed: it costs a trip to memory.
        let pseudonormal = || self.pseudonormals.at(&self.mesh, triangle, closest.feature);
        let is_inside = match &self.winding {
            Some(winding) => winding.at(&self.mesh, &self.bvh, local) > 0.5,
            None => offset.dot(pseudonormal()) < 0.0,
        };
        let sign = if is_inside { -1.0 } else { 1.0 };
        let gradient = if on_surface { pseudonormal().normalize_or_zero() } else { offset * (sign / distance) };
        Sample { distance: sign * self.mesh.frame.length_from_local(distance), gradient }
    }
}

impl FieldFunction for SignedDistance {
    /// NaN, with a zero gradient, for a point that is not finite.
    fn sample(&self, point: DVec3) -> Sample {
        self.sample_seeded(point, None, &mut Scratch::new()).0
    }

    fn sample_all(&self, points: &[DVec3]) -> Vec<Sample> {
        let mut samples = vec![Sample::default(); points.len()];
        let chunks = samples.par_chunks_mut(CHUNK).zip(points.par_chunks(CHUNK));
        chunks.for_each(|(samples, points)| self.sample_in_turn(points, samples));
        samples
    }

    /// With winding numbers: between ¼ and ¾ in size, where the holes seen from the point span about
    /// a quarter of its sphere of directions. With pseudonormals: never, as they are for closed
    /// meshes.
    fn sign_is_doubtful(&self, point: DVec3) -> bool {
        self.winding.as_ref().is_some_and(|winding| {
            let number = winding.at(&self.mesh, &self.bvh, self.mesh.frame.to_local(point)).abs();
            (0.25..0.75).contains(&number)
        })
    }
}

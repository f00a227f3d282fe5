//! The exact signed distance to a mesh: closest triangle by a tree, sign by pseudonormals or
//! winding numbers.

mod bvh;
mod bvh_build;
mod bvh_fold;
mod bvh_nearest;
mod local_mesh;
mod neighbours;
mod oriented_box;
mod pseudonormal;
mod solid_angle;
#[cfg(test)]
mod tests;
pub mod triangle;
mod winding;

use crate::field_function::{FieldFunction, Sample};
use crate::mesh::{CheckedMesh, Topology};
use bvh::is_within_reach;
use bvh_nearest::{Finder, Nearest, Scratch};
use glam::DVec3;
use local_mesh::LocalMesh;
use neighbours::nearest_of_each;
use pseudonormal::Pseudonormals;
use rayon::prelude::*;
use winding::WindingTree;

/// Points that one task samples in turn. It bears on speed alone.
const CHUNK: usize = 1024;
/// Closer to the surface than this fraction of the mesh's longest side, the gradient is the
/// pseudonormal: the direction to the closest point drowns in its rounding.
const ON_SURFACE: f64 = 1e-9;

/// A local point outside the box of every mesh.
const BEYOND: DVec3 = DVec3::splat(2.0);

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
    finder: Finder,
    pseudonormals: Pseudonormals,
    winding: Option<WindingTree>,
}

impl SignedDistance {
    /// Builds the search tree and what the sign needs.
    ///
    /// # Panics
    /// For 2²⁸ triangles or more.
    pub fn new(mesh: &CheckedMesh, method: SignMethod) -> Self {
        assert!(mesh.triangles.len() < 1 << 28, "a mesh of fewer than 2^28 triangles");
        let finder = bvh_build::build(&LocalMesh::new(mesh));
        let pseudonormals = Pseudonormals::new(&finder.mesh);
        let winding = (method == SignMethod::Winding).then(|| WindingTree::new(&finder));
        Self { finder, pseudonormals, winding }
    }

    /// Samples points, best each near the one before.
    fn sample_in_turn(&self, points: &[DVec3], samples: &mut [Sample]) {
        let local = |&point| Some(self.finder.mesh.frame.to_local(point)).filter(|p| p.is_finite());
        let searched: Vec<DVec3> = points.iter().map(|point| local(point).unwrap_or_default()).collect();
        nearest_of_each(&self.finder, &searched, |k, nearest| {
            samples[k] = self.signed(searched[k], nearest);
        });
        for (sample, point) in samples.iter_mut().zip(points) {
            if local(point).is_none() {
                *sample = Sample { distance: f64::NAN, gradient: DVec3::ZERO };
            }
        }
    }

    fn signed(&self, local: DVec3, nearest: Nearest) -> Sample {
        let Nearest { triangle, closest } = nearest;
        let offset = local - closest.point;
        let distance = closest.distance_squared.sqrt();
        let sign = if self.is_inside(local, nearest) { -1.0 } else { 1.0 };
        let gradient = if distance > ON_SURFACE {
            offset * (sign / offset.length())
        } else {
            self.pseudonormals.at(&self.finder.mesh, triangle, closest.feature).normalize_or_zero()
        };
        Sample { distance: sign * self.finder.mesh.frame.length_from_local(distance), gradient }
    }

    fn is_inside(&self, local: DVec3, nearest: Nearest) -> bool {
        if let Some(winding) = &self.winding {
            return winding.at(&self.finder, local) > 0.5;
        }
        if !is_within_reach(local) {
            // All triangles look alike from there. The sign is that of any other point beyond the box.
            let nearest = self.finder.nearest(BEYOND, 0, &mut Scratch::new());
            return self.is_inside(BEYOND, nearest);
        }
        let Nearest { triangle, closest } = nearest;
        let pseudonormal = self.pseudonormals.at(&self.finder.mesh, triangle, closest.feature);
        (local - closest.point).dot(pseudonormal) < 0.0
    }
}

impl FieldFunction for SignedDistance {
    /// NaN, with a zero gradient, for a point that is not finite or too far away for its distance to
    /// be.
    fn sample(&self, point: DVec3) -> Sample {
        let mut sample = [Sample::default()];
        self.sample_in_turn(&[point], &mut sample);
        sample[0]
    }

    fn sample_all(&self, points: &[DVec3]) -> Vec<Sample> {
        let mut samples = vec![Sample::default(); points.len()];
        let chunks = samples.par_chunks_mut(CHUNK).zip(points.par_chunks(CHUNK));
        chunks.for_each(|(samples, points)| self.sample_in_turn(points, samples));
        samples
    }

    /// With winding numbers: where the number is between ¼ and ¾ in size, that is, where the holes
    /// span a quarter of all directions or more, or within rounding of the surface. With
    /// pseudonormals: nowhere, for they are meant for closed meshes.
    fn sign_is_doubtful(&self, point: DVec3) -> bool {
        self.winding.as_ref().is_some_and(|winding| {
            let number = winding.at(&self.finder, self.finder.mesh.frame.to_local(point)).abs();
            (0.25..0.75).contains(&number)
        })
    }
}

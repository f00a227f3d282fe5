//! The exact signed distance to a mesh: closest triangle by a tree, sign by pseudonormals or
//! winding numbers.

mod bvh;
mod bvh_build;
mod bvh_fold;
mod bvh_nearest;
mod local_mesh;
mod oriented_box;
mod pseudonormal;
pub mod triangle;
mod winding;

use crate::field_function::{FieldFunction, Sample};
use crate::geometry::Aabb;
use crate::mesh::{CheckedMesh, Topology};
use bvh::Bvh;
use bvh_nearest::{Group, Nearest, Scratch, nearest};
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
        assert!(
            mesh.triangles.len() < 1 << 30,
            "a mesh of fewer than 2^30 triangles"
        );
        let mesh = LocalMesh::new(mesh);
        let (mesh, bvh) = bvh_build::build(&mesh);
        if std::env::var("STATS").is_ok() {
            bvh_build::debug_stats(&bvh, mesh.triangles.len());
        }
        let pseudonormals = Pseudonormals::new(&mesh);
        let winding = (method == SignMethod::Winding).then(|| WindingTree::new(&mesh, &bvh));
        Self {
            mesh,
            bvh,
            pseudonormals,
            winding,
        }
    }

    /// Samples points one after the other, neighbours in groups that share a search.
    fn sample_in_turn(&self, points: &[DVec3], samples: &mut [Sample]) {
        let (mut scratch, mut group) = (Scratch::new(), Group::new());
        let mut radius = FIRST_RADIUS;
        let mut seed = 0;
        let mut start = 0;
        let local: Vec<DVec3> = points
            .iter()
            .map(|&point| self.mesh.frame.to_local(point))
            .collect();
        while start < points.len() {
            let (count, sphere) = leading_group(&local[start..], radius);
            if count >= SMALLEST_GROUP {
                let gathered = group.gather(
                    &self.mesh,
                    &self.bvh,
                    sphere,
                    seed,
                    MOST_SHARED,
                    &mut scratch,
                );
                match gathered {
                    None => {
                        radius = 0.5 * sphere.1;
                        continue;
                    }
                    Some(shared) => {
                        for k in start..start + count {
                            let nearest =
                                group.nearest(&self.mesh, local[k], &mut scratch).unwrap();
                            seed = nearest.triangle;
                            samples[k] = self.signed(local[k], nearest);
                        }
                        if shared < 24 {
                            radius *= 1.5
                        } else if shared > 64 {
                            radius *= 0.75
                        }
                    }
                }
            } else {
                for k in start..start + count {
                    let nearest = nearest(&self.mesh, &self.bvh, local[k], seed, &mut scratch);
                    seed = nearest.triangle;
                    samples[k] = self.signed(local[k], nearest);
                }
            }
            start += count;
        }
    }

    fn sample_seeded(&self, point: DVec3, seed: u32, scratch: &mut Scratch) -> (Sample, u32) {
        let local = self.mesh.frame.to_local(point);
        if !local.is_finite() {
            return (
                Sample {
                    distance: f64::NAN,
                    gradient: DVec3::ZERO,
                },
                seed,
            );
        }
        let nearest = nearest(&self.mesh, &self.bvh, local, seed, scratch);
        (self.signed(local, nearest), nearest.triangle)
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
        let gradient = if on_surface {
            pseudonormal().normalize_or_zero()
        } else {
            offset * (sign / distance)
        };
        Sample {
            distance: sign * self.mesh.frame.length_from_local(distance),
            gradient,
        }
    }
}

fn leading_group(points: &[DVec3], radius: f64) -> (usize, (DVec3, f64)) {
    let mut bounds = Aabb::EMPTY;
    let mut count = 0;
    for &point in points.iter().take(LARGEST_GROUP) {
        let grown = Aabb {
            min: bounds.min.min(point),
            max: bounds.max.max(point),
        };
        if count > 0 && grown.diagonal() > 2.0 * radius {
            break;
        }
        bounds = grown;
        count += 1;
    }
    (count, (bounds.centre(), 0.5 * bounds.diagonal()))
}
const FIRST_RADIUS: f64 = 0.02;
const SMALLEST_GROUP: usize = 3;
const LARGEST_GROUP: usize = 64;
const MOST_SHARED: usize = 160;

impl FieldFunction for SignedDistance {
    /// NaN, with a zero gradient, for a point that is not finite.
    fn sample(&self, point: DVec3) -> Sample {
        self.sample_seeded(point, 0, &mut Scratch::new()).0
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
            let number = winding
                .at(&self.mesh, &self.bvh, self.mesh.frame.to_local(point))
                .abs();
            (0.25..0.75).contains(&number)
        })
    }
}

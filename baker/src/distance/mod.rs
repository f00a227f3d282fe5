//! The exact signed distance to a mesh: closest triangle by a tree, sign by pseudonormals, winding
//! numbers or rays.

mod boundary;
mod bvh;
mod bvh_build;
mod bvh_fold;
mod bvh_nearest;
mod choose;
mod holes;
mod local_mesh;
mod neighbours;
mod oriented_box;
mod pseudonormal;
mod ray_tree;
mod self_intersection;
mod sign;
mod solid_angle;
#[cfg(test)]
mod tests;
pub mod triangle;
mod winding;

pub use choose::SignDecision;

use crate::field_function::{FieldFunction, Sample};
use crate::geometry::Aabb;
use crate::mesh::CheckedMesh;
use crate::morton;
use bvh_nearest::{Finder, Nearest};
use glam::DVec3;
use local_mesh::LocalMesh;
use neighbours::nearest_of_each;
use pseudonormal::Pseudonormals;
use ray_tree::RayTree;
use rayon::prelude::*;
use sign::{Memory, Signs};

/// Points that one task samples in turn: rows of a lattice and cells of an octree, enough of them to lie close together.
/// It bears on speed alone.
const CHUNK: usize = 4096;
/// Closer to the surface than this fraction of the mesh's longest side, the gradient is the
/// pseudonormal: the direction to the closest point drowns in its rounding.
const ON_SURFACE: f64 = 1e-9;

/// A local point outside the box of every mesh.
const BEYOND: DVec3 = DVec3::splat(2.0);

/// How the inside is told from the outside. Triangles are seen as [`CheckedMesh::orientation`] says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SignMethod {
    /// Angle-weighted pseudonormals: exact on closed surfaces that cross themselves nowhere.
    Pseudonormal,
    /// Generalized winding numbers: inside where the number is not zero on closed surfaces, where it
    /// exceeds ½ in size on others; bears holes and overlaps. Where the holes of a piece are small and the
    /// number is between ¼ and ¾ in size, pseudonormals decide.
    Winding,
    /// The majority of seven rays that count whether their crossings are odd: bears triangles that face
    /// all ways.
    Rays,
    /// Nothing is inside the triangles: the field is the unsigned distance less half a thickness.
    Sheet {
        /// How thick the sheet is, mesh units.
        thickness: f64,
    },
}

/// What was asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum SignChoice {
    /// The method that suits the mesh.
    #[default]
    Auto,
    /// Pseudonormals on any mesh.
    Pseudonormal,
    /// Winding numbers on any mesh.
    Winding,
    /// Votes of rays on any mesh.
    Rays,
    /// The unsigned distance less half a thickness, mesh units.
    Sheet {
        /// How thick the sheet is, mesh units.
        thickness: f64,
    },
}

/// The exact signed distance to a mesh.
///
/// Distances agree with an exhaustive search to rounding (some 1e-15 of the mesh's size), and do not
/// depend on the sign method, but for the thickness of sheets. The answer at a point depends on the mesh and
/// the point alone.
pub struct SignedDistance {
    finder: Finder,
    pseudonormals: Pseudonormals,
    signs: Signs,
    /// Half the thickness of a sheet, mesh units.
    half_thickness: f64,
}

impl SignedDistance {
    /// Builds the search tree and what the sign needs.
    ///
    /// # Panics
    /// For 2²⁸ triangles or more.
    pub fn new(mesh: &CheckedMesh, method: SignMethod) -> Self {
        Self::with_finder(find_in(mesh), method)
    }

    /// The same, with the method that the choice comes to on this mesh.
    ///
    /// # Panics
    /// For 2²⁸ triangles or more.
    pub fn choose(mesh: &CheckedMesh, choice: SignChoice) -> (Self, SignDecision) {
        let finder = find_in(mesh);
        let decision = choose::choose(mesh, &finder, choice);
        (Self::with_finder(finder, decision.method), decision)
    }

    fn with_finder(finder: Finder, method: SignMethod) -> Self {
        let half_thickness = match method {
            SignMethod::Sheet { thickness } => 0.5 * thickness,
            _ => 0.0,
        };
        let pseudonormals = Pseudonormals::new(&finder.mesh);
        Self { signs: Signs::new(&finder, method), pseudonormals, finder, half_thickness }
    }

    /// How many pairs of triangles cross, or touch where they are no neighbours.
    pub fn count_self_intersections(&self) -> usize {
        self_intersection::count(&self.finder, &RayTree::new(&self.finder, 0))
    }

    /// How many closed pieces have their outer side inside others, where no open piece confuses it: shells within shells
    /// that face the same way.
    pub fn count_nested_shells(&self, mesh: &CheckedMesh) -> usize {
        choose::count_nested_shells(mesh, &self.finder, &RayTree::new(&self.finder, 0))
    }

    /// Samples points, neighbours in space one after the other.
    fn sample_in_turn(&self, points: &[DVec3], samples: &mut [Sample]) {
        let local = |&point| Some(self.finder.mesh.frame.to_local(point)).filter(|p| p.is_finite());
        let order = along_curve(points.iter().map(|point| local(point).unwrap_or_default()));
        let searched: Vec<DVec3> = order.iter().map(|(_, point)| *point).collect();
        let mut memory = Memory::default();
        nearest_of_each(&self.finder, &searched, |k, nearest| {
            let (place, point) = order[k];
            let is_inside = self.signs.is_inside(&self.finder, &self.pseudonormals, point, nearest, &mut memory);
            samples[place] = self.signed(point, nearest, is_inside);
        });
        for (sample, point) in samples.iter_mut().zip(points) {
            if local(point).is_none() {
                *sample = Sample { distance: f64::NAN, gradient: DVec3::ZERO };
            }
        }
    }

    fn signed(&self, local: DVec3, nearest: Nearest, is_inside: bool) -> Sample {
        let Nearest { triangle, closest } = nearest;
        let offset = local - closest.point;
        let distance = closest.distance_squared.sqrt();
        let sign = if is_inside { -1.0 } else { 1.0 };
        let gradient = if distance > ON_SURFACE {
            offset * (sign / offset.length())
        } else {
            self.pseudonormals.at(&self.finder.mesh, triangle, closest.feature).normalize_or_zero()
        };
        Sample { distance: sign * self.finder.mesh.frame.length_from_local(distance) - self.half_thickness, gradient }
    }
}

/// Points with their places, in the order of a curve that fills their box: blocks share more than rows do.
fn along_curve(points: impl Iterator<Item = DVec3>) -> Vec<(usize, DVec3)> {
    /// Steps of the curve along the longest side.
    const STEPS: f64 = 1024.0;
    let mut order: Vec<(usize, DVec3)> = points.enumerate().collect();
    let bounds = Aabb::around(order.iter().map(|(_, point)| *point));
    let scale = (STEPS - 1.0) / bounds.size().max_element().max(f64::MIN_POSITIVE);
    // Stable, and by the point alone: copies stay in their order.
    order.sort_by_cached_key(|(_, point)| morton::encode(((*point - bounds.min) * scale).as_uvec3()));
    order
}

fn find_in(mesh: &CheckedMesh) -> Finder {
    assert!(mesh.triangles.len() < 1 << 28, "a mesh of fewer than 2^28 triangles");
    bvh_build::build(&LocalMesh::new(mesh))
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
    /// span a quarter of all directions or more. With rays: where two of them or more contradict the others.
    /// On closed surfaces, with pseudonormals, and with sheets: nowhere.
    fn sign_is_doubtful(&self, point: DVec3) -> bool {
        let local = self.finder.mesh.frame.to_local(point);
        local.is_finite() && self.signs.is_doubtful(&self.finder, local)
    }
}

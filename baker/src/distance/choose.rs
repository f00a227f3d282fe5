//! Which sign method suits a mesh.

use super::bvh_nearest::Finder;
use super::ray_tree::RayTree;
use super::self_intersection;
use super::sign::Signs;
use super::{SignChoice, SignMethod};
use crate::geometry::area_vector;
use crate::mesh::{CheckedMesh, Piece, Role};
use crate::random::Draws;
use glam::DVec3;

/// Larger meshes are not searched for self-intersections: the winding number is cheaper.
const MOST_SEARCHED: usize = 1 << 21;
/// Points at which winding numbers and rays are compared.
const TRIALS: usize = 512;
/// Winding numbers that decide nothing at so many of the trials are meaningless.
const MEANINGLESS: usize = TRIALS / 20;

/// What was found out about a mesh's inside, and decided.
#[derive(Clone, Debug, PartialEq)]
pub struct SignDecision {
    /// Where the sign comes from.
    pub method: SignMethod,
    /// Why, as the rest of a sentence that begins with the method.
    pub reason: String,
    /// Pairs of triangles that cross; absent if they were not looked for.
    pub self_intersections: Option<usize>,
}

pub(super) fn choose(mesh: &CheckedMesh, finder: &Finder, choice: SignChoice) -> SignDecision {
    let asked = |method| SignDecision { method, reason: "as asked".into(), self_intersections: None };
    match choice {
        SignChoice::Pseudonormal => asked(SignMethod::Pseudonormal),
        SignChoice::Winding => asked(SignMethod::Winding),
        SignChoice::Rays => asked(SignMethod::Rays),
        SignChoice::Sheet { thickness } => asked(SignMethod::Sheet { thickness }),
        SignChoice::Auto => choose_automatically(mesh, finder),
    }
}

fn choose_automatically(mesh: &CheckedMesh, finder: &Finder) -> SignDecision {
    let oriented = &mesh.oriented;
    let decision = |method, reason: &str, self_intersections| {
        let reason = reason.to_owned();
        SignDecision { method, reason, self_intersections }
    };
    if oriented.is_closed_and_oriented() {
        if mesh.orientation.count(Role::Wall) > 0 {
            return decision(SignMethod::Winding, "for there are walls inside", None);
        }
        if mesh.triangles.len() > MOST_SEARCHED {
            return decision(SignMethod::Winding, "for so large a mesh is not searched for self-intersections", None);
        }
        let rays = RayTree::new(finder, 0);
        return match self_intersection::count(finder, &rays) {
            0 if oriented.components > 1 && count_nested_shells(mesh, finder, &rays) > 0 => {
                decision(SignMethod::Winding, "for there are shells within shells that face the same way", Some(0))
            }
            0 => decision(SignMethod::Pseudonormal, "for the surface is closed and crosses itself nowhere", Some(0)),
            pairs => decision(SignMethod::Winding, "for the surface crosses itself", Some(pairs)),
        };
    }

    let [winding, rays] = [SignMethod::Winding, SignMethod::Rays].map(|method| doubts(mesh, finder, method));
    if winding > MEANINGLESS && rays < winding / 4 {
        return decision(SignMethod::Rays, "for the triangles face all ways, and rays agree on what is inside", None);
    }
    let is_open = oriented.boundary_edges > 0 || oriented.inconsistent_edges > 0;
    let reason = if is_open { "for the surface is not closed" } else { "for more than two triangles share edges" };
    decision(SignMethod::Winding, reason, None)
}

/// How many closed pieces have their outer side inside others.
pub(super) fn count_nested_shells(mesh: &CheckedMesh, finder: &Finder, rays: &RayTree) -> usize {
    /// Above the surface by so much, in the frame of the search: more than rounding, less than any gap that matters.
    const ABOVE: f64 = 1e-9;
    let is_nested = |piece: &Piece| {
        let corners = mesh.seen_corners(piece.first).map(|corner| finder.mesh.frame.to_local(corner));
        let centre = corners.iter().sum::<DVec3>() / 3.0;
        let above = centre + ABOVE * area_vector(corners).normalize_or_zero();
        rays.crossings(finder, above).signed != 0
    };
    mesh.pieces().iter().filter(|piece| piece.is_closed && is_nested(piece)).count()
}

/// At how many of some points in the mesh's box the sign of a method is a guess.
fn doubts(mesh: &CheckedMesh, finder: &Finder, method: SignMethod) -> usize {
    let signs = Signs::new(finder, method);
    let points = (0..TRIALS as u64).map(|number| {
        let mut draws = Draws::new(0, 0, number);
        let fraction = DVec3::new(draws.unit(), draws.unit(), draws.unit());
        mesh.bounds.min + fraction * mesh.bounds.size()
    });
    points.filter(|&point| signs.is_doubtful(finder, finder.mesh.frame.to_local(point))).count()
}

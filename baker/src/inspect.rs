//! What a mesh is like, before anything is baked.

use crate::distance::{SignDecision, SignedDistance};
use crate::field_function::FieldFunction;
use crate::geometry::area_vector;
use crate::mesh::{CheckedMesh, Role};
use crate::octree::domain::Domain;
use crate::random::Draws;
use crate::settings::Settings;
use glam::DVec3;
use rayon::prelude::*;

/// Points of the surface at which the thickness is measured, and as many of the box at which signs are doubted.
pub const SAMPLES: usize = 4_000;
/// Thinner than so many of the smallest cells, a part of the mesh is lost on the field.
const CELLS_ACROSS: f64 = 2.0;
/// Thinner than so many targets, a wall may be lost whatever the cells: the greatest errors of fields are some 4.5 targets,
/// and the middle of a wall is half its thickness inside.
const TARGETS_ACROSS: f64 = 9.0;
/// Doubtful places that are listed.
const PLACES: usize = 64;

/// What a mesh is like. Lengths in mesh units.
#[derive(Clone, Debug)]
pub struct Inspection {
    /// Area of all triangles.
    pub area: f64,
    /// Volume inside, once triangles face as they should; meaningless for an open surface.
    pub volume: f64,
    /// Loops of edges with one triangle.
    pub rims: usize,
    /// Pieces that shared vertices connect and that no rim opens, with a negative volume: cavities of others.
    pub cavities: usize,
    /// Closed pieces whose outer side is inside others: shells within shells that face the same way.
    pub nested: usize,
    /// Triangles that were turned over for the sign.
    pub turned: usize,
    /// Triangles left out because others have the same corners.
    pub duplicates: usize,
    /// Triangles that both sides of a closed surface share.
    pub walls: usize,
    /// Pairs of triangles that cross.
    pub self_intersections: usize,
    /// The sign method that the settings come to, and why.
    pub sign: SignDecision,
    /// Share of points of the mesh's box whose sign is a guess.
    pub doubtful: f64,
    /// The first of these points.
    pub doubtful_places: Vec<[f64; 3]>,
    /// Thickness of what is inside, at points evenly over the surface.
    pub thickness: Option<Thickness>,
}

/// How far it is through the inside, straight away from the surface, at points evenly over it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thickness {
    /// A hundredth of the surface is thinner than this.
    pub p01: f64,
    /// Half of the surface is thinner than this.
    pub median: f64,
    /// Edge of the smallest cell that the settings allow.
    pub smallest_cell: f64,
    /// Share of the surface that is thinner than two such cells.
    pub too_thin: f64,
    /// Target error of the settings.
    pub target: f64,
    /// Share of the surface that is thinner than nine targets: a field of this target may not have it.
    pub too_thin_for_target: f64,
}

/// Looks at a mesh as it would be baked with these settings.
pub fn inspect(mesh: &CheckedMesh, settings: &Settings) -> Inspection {
    let (distance, sign) = SignedDistance::choose(mesh, settings.sign);
    let points = (0..SAMPLES as u64).map(|number| {
        let mut draws = Draws::new(0, 0, number);
        mesh.bounds.min + DVec3::new(draws.unit(), draws.unit(), draws.unit()) * mesh.bounds.size()
    });
    let points: Vec<DVec3> = points.collect();
    let doubtful: Vec<DVec3> = points.into_par_iter().filter(|&point| distance.sign_is_doubtful(point)).collect();
    let pieces = mesh.pieces();

    Inspection {
        area: pieces.iter().map(|piece| piece.area).sum(),
        volume: pieces.iter().map(|piece| piece.volume).sum(),
        rims: mesh.rims(),
        cavities: pieces.iter().filter(|piece| piece.is_closed && piece.volume < 0.0).count(),
        nested: distance.count_nested_shells(mesh),
        turned: mesh.orientation.count(Role::Turned),
        duplicates: mesh.orientation.count(Role::Duplicate),
        walls: mesh.orientation.count(Role::Wall),
        self_intersections: sign.self_intersections.unwrap_or_else(|| distance.count_self_intersections()),
        sign,
        doubtful: doubtful.len() as f64 / SAMPLES as f64,
        doubtful_places: doubtful.iter().take(PLACES).map(|point| point.to_array()).collect(),
        thickness: thickness(mesh, &distance, settings),
    }
}

fn thickness(mesh: &CheckedMesh, distance: &SignedDistance, settings: &Settings) -> Option<Thickness> {
    let domain = Domain::around(&mesh.bounds, settings);
    let smallest_cell = domain.root_edge / f64::from(1u32 << (settings.max_depth - settings.start_depth));

    // Triangles by area: each point has its share of the sum.
    let mut sum = 0.0;
    let sums: Vec<f64> = (0..mesh.triangles.len())
        .map(|triangle| {
            sum += area_vector(mesh.corners(triangle)).length();
            sum
        })
        .collect();
    let depths = (0..SAMPLES).into_par_iter().filter_map(|number| {
        let mut draws = Draws::new(0, 1, number as u64);
        let share = (number as f64 + draws.unit()) / SAMPLES as f64 * sum;
        let triangle = sums.partition_point(|&sum| sum <= share).min(sums.len() - 1);
        let [a, b, c] = mesh.seen_corners(triangle);
        // Evenly over the triangle: the square root turns a square into it.
        let (u, v) = (draws.unit().sqrt(), draws.unit());
        let point = a * (1.0 - u) + b * (u * (1.0 - v)) + c * (u * v);
        let normal = area_vector([a, b, c]).normalize_or_zero();
        depth_below(distance, point, normal, mesh.bounds.diagonal())
    });
    let mut depths: Vec<f64> = depths.collect();
    depths.sort_unstable_by(f64::total_cmp);
    let quantile = |share: f64| depths.get((share * depths.len() as f64) as usize).copied();
    let share_below = |least: f64| depths.partition_point(|&depth| depth < least) as f64 / depths.len() as f64;
    let target = settings.error.absolute(mesh.bounds.diagonal());
    Some(Thickness {
        p01: quantile(0.01)?,
        median: quantile(0.5)?,
        smallest_cell,
        too_thin: share_below(CELLS_ACROSS * smallest_cell),
        target,
        too_thin_for_target: share_below(TARGETS_ACROSS * target),
    })
}

/// How far it is through the inside from a point of the surface against its normal, by steps that the distance
/// allows (Hart 1996, "Sphere tracing"). None where there is no inside.
fn depth_below(distance: &SignedDistance, point: DVec3, normal: DVec3, largest: f64) -> Option<f64> {
    /// Where the way begins and ends, as a part of the diagonal.
    const TOUCH: f64 = 1e-6;
    const STEPS: usize = 200;
    let mut depth = 2.0 * TOUCH * largest;
    for step in 0..STEPS {
        let below = -distance.sample(point - depth * normal).distance;
        if step == 0 && below <= 0.0 {
            return None;
        }
        // The first steps leave the surface; what is as near later on is the other side.
        if below <= TOUCH * largest || depth > largest {
            break;
        }
        depth += below;
    }
    Some(depth)
}

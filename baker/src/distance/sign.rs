//! Inside or outside.

use super::boundary::{Lids, Rim};
use super::bvh::is_within_reach;
use super::bvh_nearest::{Finder, Nearest, Scratch};
use super::holes::continued_triangles;
use super::pseudonormal::Pseudonormals;
use super::ray_tree::{DIRECTIONS, RayTree};
use super::winding::Winding;
use super::{BEYOND, SignMethod};
use glam::DVec3;

/// Rays that vote: an odd number, so that there is always a majority.
const VOTERS: usize = DIRECTIONS;
/// Fewer voices than this against the majority leave no doubt.
const DISSENT: usize = 2;
/// Winding numbers that decide nothing, by their size: holes span a quarter of all directions, or more.
const DOUBTFUL: std::ops::Range<f64> = 0.25..0.75;

/// What the sign of a mesh needs.
pub(super) enum Signs {
    /// The side of the pseudonormal of the closest feature.
    Pseudonormal,
    /// The winding number of a surface without a rim, inside where it is not zero.
    Closed(RayTree),
    /// The winding number of a surface with a rim, inside where it exceeds ½ in size.
    Open(Box<OpenSurface>),
    /// The majority of rays that count their crossings.
    Rays(Vec<RayTree>),
    /// Everything is outside.
    Sheet,
}

/// How much a winding number may be off: more than was measured of lids as dipoles, and what is left of single precision.
pub(super) const NUMBER_ERROR: f64 = 0.01;

/// A surface with a rim.
pub(super) struct OpenSurface {
    rays: RayTree,
    pub(super) lids: Lids,
    /// Triangles whose piece goes on smoothly across its holes: pseudonormals decide what the winding
    /// number does not.
    continued: Vec<bool>,
}

impl OpenSurface {
    /// The winding number at a local point that single precision takes: the crossings of a ray with surface and lids count that
    /// of the closed whole.
    pub(super) fn number(&self, finder: &Finder, point: DVec3, lids: &Winding) -> f64 {
        let whole = self.rays.crossings(finder, point).signed + self.lids.crossings(point);
        f64::from(whole) - lids.number
    }

    /// The quarter of the winding number at a point, and the radius of a ball in which it changes on the surface alone:
    /// that of the whole does in a ball without lids, and decides where that of the lids is small.
    fn judge(&self, finder: &Finder, point: DVec3) -> (Quarter, f64) {
        if !is_within_reach(point) {
            return (OUTSIDE, 0.0);
        }
        let lids = self.lids.winding(point);
        let size = self.number(finder, point, &lids).abs();
        let quarter = [DOUBTFUL.start, 0.5, DOUBTFUL.end].into_iter().filter(|bound| size > *bound).count();
        (quarter, lids.radius_within(DOUBTFUL.start - NUMBER_ERROR))
    }
}

/// Where a winding number is, by its size: below ¼ is outside, above ¾ inside, what is between is doubtful.
type Quarter = usize;
const OUTSIDE: Quarter = 0;
const INSIDE: Quarter = 3;

/// A point whose winding number, or what stands for it, is known.
#[derive(Clone, Copy)]
struct Judged {
    point: DVec3,
    distance: f64,
    quarter: Quarter,
    /// A ball in which the quarter changes on the surface alone.
    centre: DVec3,
    radius: f64,
}

impl Judged {
    /// Whether another point, at this distance from the surface, must be in the same quarter: no surface is between two
    /// points of which one is farther from all surfaces than from the other.
    fn holds_at(&self, point: DVec3, distance: f64) -> bool {
        /// Distances are right to rounding.
        const SURELY: f64 = 0.999_999;
        let apart = self.point.distance_squared(point);
        let reach = SURELY * self.distance.max(distance);
        apart < reach * reach && self.centre.distance(point) < self.radius
    }
}

/// The last point that was judged in each quarter. It saves work, and never bears on an answer.
#[derive(Default)]
pub(super) struct Memory([Option<Judged>; INSIDE + 1]);

impl Memory {
    /// The quarter of a point at this distance; if it does not follow, `judge` finds it and the radius of a ball in
    /// which it changes on the surface alone.
    fn quarter(&mut self, point: DVec3, distance: f64, judge: impl FnOnce() -> (Quarter, f64)) -> Quarter {
        let known = self.0.iter().flatten().find(|known| known.holds_at(point, distance));
        let judged = match known {
            Some(known) => Judged { point, distance, ..*known },
            None => {
                let (quarter, radius) = judge();
                Judged { point, distance, quarter, centre: point, radius }
            }
        };
        self.0[judged.quarter] = Some(judged);
        judged.quarter
    }
}

impl Signs {
    pub(super) fn new(finder: &Finder, method: SignMethod) -> Self {
        match method {
            SignMethod::Pseudonormal => Self::Pseudonormal,
            SignMethod::Sheet { .. } => Self::Sheet,
            SignMethod::Rays => Self::Rays((0..VOTERS).map(|number| RayTree::new(finder, number)).collect()),
            SignMethod::Winding => {
                let rim = Rim::of(&finder.mesh);
                let rays = RayTree::new(finder, 0);
                if rim.loops.is_empty() {
                    return Self::Closed(rays);
                }
                let continued = continued_triangles(&finder.mesh, &rim);
                Self::Open(Box::new(OpenSurface { rays, lids: Lids::new(&finder.mesh, &rim), continued }))
            }
        }
    }

    /// Whether a local point is inside.
    pub(super) fn is_inside(
        &self,
        finder: &Finder,
        pseudonormals: &Pseudonormals,
        point: DVec3,
        nearest: Nearest,
        memory: &mut Memory,
    ) -> bool {
        let distance = nearest.closest.distance_squared.sqrt();
        match self {
            Self::Sheet => false,
            Self::Pseudonormal => behind_pseudonormal(finder, pseudonormals, point, nearest),
            Self::Rays(voters) => votes(finder, voters, point) > VOTERS / 2,
            Self::Closed(rays) => {
                let judge = || {
                    let is_inside = rays.crossings(finder, point).signed != 0;
                    (if is_inside { INSIDE } else { OUTSIDE }, f64::INFINITY)
                };
                memory.quarter(point, distance, judge) == INSIDE
            }
            Self::Open(surface) => match memory.quarter(point, distance, || surface.judge(finder, point)) {
                OUTSIDE => false,
                INSIDE => true,
                _ if surface.continued[nearest.triangle as usize] => {
                    behind_pseudonormal(finder, pseudonormals, point, nearest)
                }
                quarter => quarter > 1,
            },
        }
    }

    /// Whether the sign at a local point is a guess.
    pub(super) fn is_doubtful(&self, finder: &Finder, local: DVec3) -> bool {
        match self {
            Self::Pseudonormal | Self::Closed(_) | Self::Sheet => false,
            Self::Open(surface) => !matches!(surface.judge(finder, local).0, OUTSIDE | INSIDE),
            Self::Rays(voters) => {
                let inside = votes(finder, voters, local);
                inside.min(VOTERS - inside) >= DISSENT
            }
        }
    }
}

/// How many rays count an odd number of crossings.
fn votes(finder: &Finder, voters: &[RayTree], local: DVec3) -> usize {
    voters.iter().filter(|rays| rays.crossings(finder, local).count % 2 == 1).count()
}

fn behind_pseudonormal(finder: &Finder, pseudonormals: &Pseudonormals, local: DVec3, nearest: Nearest) -> bool {
    if !is_within_reach(local) {
        // All triangles look alike from there. The sign is that of any other point beyond the box.
        let nearest = finder.nearest(BEYOND, 0, &mut Scratch::new());
        return behind_pseudonormal(finder, pseudonormals, BEYOND, nearest);
    }
    let Nearest { triangle, closest } = nearest;
    let pseudonormal = pseudonormals.at(&finder.mesh, triangle, closest.feature);
    (local - closest.point).dot(pseudonormal) < 0.0
}

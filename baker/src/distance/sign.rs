//! Inside or outside.

use super::boundary::Rim;
use super::bvh::is_within_reach;
use super::bvh_nearest::{Finder, Nearest, Scratch};
use super::holes::continued_triangles;
use super::pseudonormal::Pseudonormals;
use super::ray_tree::{DIRECTIONS, RayTree};
use super::winding::WindingTree;
use super::{BEYOND, SignMethod};
use glam::DVec3;

/// Rims that are more work are slower to sum up than the tree of dipoles is to walk.
const MOST_WORK: usize = 256;
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
    Open(OpenSurface),
    /// The majority of rays that count their crossings.
    Rays(Vec<RayTree>),
    /// Everything is outside.
    Sheet,
}

/// Winding numbers that decide alike are between two of these where some pieces are continued, and where none is.
const QUARTERS: [f64; 3] = [DOUBTFUL.start, 0.5, DOUBTFUL.end];
const HALVES: [f64; 1] = [0.5];

/// A surface with a rim.
pub(super) struct OpenSurface {
    winding: Winding,
    rim: Rim,
    /// Triangles whose piece goes on smoothly across its holes: pseudonormals decide what the winding
    /// number does not.
    continued: Vec<bool>,
    /// Numbers that decide alike are between two of these.
    bounds: &'static [f64],
}

enum Winding {
    /// Crossings of a ray, and what the rim adds to them.
    Exact(RayTree),
    Dipoles(WindingTree),
}

impl OpenSurface {
    /// The size of the winding number.
    fn number(&self, finder: &Finder, point: DVec3) -> f64 {
        if !is_within_reach(point) {
            return 0.0;
        }
        let number = match &self.winding {
            Winding::Exact(rays) => {
                f64::from(rays.crossings(finder, point).signed) + self.rim.turns(&finder.mesh, point, rays.direction())
            }
            Winding::Dipoles(tree) => tree.at(finder, point),
        };
        number.abs()
    }

    /// Where a number is among the bounds.
    fn quarter_of(&self, number: f64) -> Quarter {
        match (self.bounds.len(), number > 0.5) {
            (1, false) => OUTSIDE,
            (1, true) => INSIDE,
            (_, false) => usize::from(number >= DOUBTFUL.start),
            (_, true) => 2 + usize::from(number >= DOUBTFUL.end),
        }
    }

    /// How much a number may be off: a loop of the rim counts as a dipole from eight radii on (under 0.001), and what
    /// single precision keeps is right to some 0.002; dipoles of the tree were measured to err by up to 0.026.
    fn number_error(&self) -> f64 {
        match self.winding {
            Winding::Exact(_) => 0.004,
            Winding::Dipoles(_) => 0.03,
        }
    }

    /// A ball around a point with this number in which numbers decide alike, but for those across the
    /// surface.
    fn reach(&self, point: DVec3, number: f64) -> f64 {
        let clearance = self.bounds.iter().map(|bound| (number - bound).abs()).fold(f64::INFINITY, f64::min);
        let clearance = clearance - 2.0 * self.number_error();
        if clearance > 0.0 && is_within_reach(point) { self.rim.reach(point, clearance) } else { 0.0 }
    }
}

/// Where a winding number is among [`QUARTERS`], by its size: 0 is outside, 3 inside, what is between is doubtful.
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
        apart < reach * reach && self.centre.distance_squared(point) < self.radius * self.radius
    }
}

/// The last point that was judged in each quarter. It saves work, and never bears on an answer.
#[derive(Default)]
pub(super) struct Memory([Option<Judged>; QUARTERS.len() + 1]);

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
                if rim.edges.is_empty() {
                    return Self::Closed(RayTree::new(finder, 0));
                }
                let continued = continued_triangles(&finder.mesh, &rim);
                let winding = if rim.work() <= MOST_WORK {
                    Winding::Exact(RayTree::new(finder, 0))
                } else {
                    Winding::Dipoles(WindingTree::new(finder))
                };
                let bounds = if continued.contains(&true) { &QUARTERS[..] } else { &HALVES[..] };
                Self::Open(OpenSurface { winding, rim, continued, bounds })
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
            Self::Open(surface) => {
                let judge = || {
                    let number = surface.number(finder, point);
                    (surface.quarter_of(number), surface.reach(point, number))
                };
                match memory.quarter(point, distance, judge) {
                    OUTSIDE => false,
                    INSIDE => true,
                    _ if surface.continued[nearest.triangle as usize] => {
                        behind_pseudonormal(finder, pseudonormals, point, nearest)
                    }
                    quarter => quarter > 1,
                }
            }
        }
    }

    /// Whether the sign at a local point is a guess.
    pub(super) fn is_doubtful(&self, finder: &Finder, local: DVec3) -> bool {
        match self {
            Self::Pseudonormal | Self::Closed(_) | Self::Sheet => false,
            Self::Open(surface) => {
                let is_sure = surface.rim.lids_at_most(local) < DOUBTFUL.start - surface.number_error();
                !is_sure && DOUBTFUL.contains(&surface.number(finder, local))
            }
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

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

/// A surface with a rim.
pub(super) struct OpenSurface {
    winding: Winding,
    /// Triangles whose piece goes on smoothly across its holes: pseudonormals decide what the winding
    /// number does not.
    continued: Vec<bool>,
}

enum Winding {
    Exact { rays: RayTree, rim: Rim },
    Dipoles(WindingTree),
}

impl Winding {
    fn at(&self, finder: &Finder, point: DVec3) -> f64 {
        if !is_within_reach(point) {
            return 0.0;
        }
        match self {
            Self::Exact { rays, rim } => {
                f64::from(rays.crossings(finder, point).signed) + rim.turns(&finder.mesh, point, rays.direction())
            }
            Self::Dipoles(tree) => tree.at(finder, point),
        }
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
                    Winding::Exact { rays: RayTree::new(finder, 0), rim }
                } else {
                    Winding::Dipoles(WindingTree::new(finder))
                };
                Self::Open(OpenSurface { winding, continued })
            }
        }
    }

    /// Whether a local point is inside.
    pub(super) fn is_inside(
        &self,
        finder: &Finder,
        pseudonormals: &Pseudonormals,
        local: DVec3,
        nearest: Nearest,
    ) -> bool {
        match self {
            Self::Sheet => false,
            Self::Closed(rays) => rays.crossings(finder, local).signed != 0,
            Self::Rays(voters) => votes(finder, voters, local) > VOTERS / 2,
            Self::Pseudonormal => behind_pseudonormal(finder, pseudonormals, local, nearest),
            Self::Open(OpenSurface { winding, continued }) => {
                let number = winding.at(finder, local).abs();
                if DOUBTFUL.contains(&number) && continued[nearest.triangle as usize] {
                    behind_pseudonormal(finder, pseudonormals, local, nearest)
                } else {
                    number > 0.5
                }
            }
        }
    }

    /// Whether the sign at a local point is a guess.
    pub(super) fn is_doubtful(&self, finder: &Finder, local: DVec3) -> bool {
        match self {
            Self::Pseudonormal | Self::Closed(_) | Self::Sheet => false,
            Self::Open(OpenSurface { winding, .. }) => DOUBTFUL.contains(&winding.at(finder, local).abs()),
            Self::Rays(voters) => {
                let inside = votes(finder, voters, local);
                inside.min(VOTERS - inside) >= DISSENT
            }
        }
    }

    /// Whether the sign changes nowhere but on the surface: within its distance of a point all signs are alike.
    pub(super) fn changes_on_the_surface_alone(&self) -> bool {
        matches!(self, Self::Closed(_))
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

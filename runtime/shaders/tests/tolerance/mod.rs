//! What answers may differ by: SPEC.md §9, §11.4 and §12.7. The M of the specification is replaced by what the corners of
//! leaves and cells tell of it, which is less.

use nearfield::{Field, Grid, Leaf, Octree, PolynomialOctree};

/// What the distance and each component of the gradient may differ by.
pub(crate) struct Tolerance {
    pub(crate) distance: f32,
    pub(crate) gradient: f32,
}

/// The tolerances of a field.
pub(crate) struct Tolerances<'a> {
    field: Field<'a>,
    /// Of a polynomial octree: every leaf, and how far it reaches beyond its cell, in finest cells.
    reaches: Vec<(Leaf, f32)>,
}

/// What a tolerance is made of, at a point of the box.
struct Scale {
    /// M.
    magnitude: f32,
    /// The length over which it changes.
    length: f32,
    /// Shares of M that distances, and of M / length that gradients may be off by.
    shares: [f32; 2],
}

impl<'a> Tolerances<'a> {
    pub(crate) fn of(field: Field<'a>) -> Self {
        let reaches = field.polynomial_octree().map_or(Vec::new(), |octree| reaches(&octree));
        Self { field, reaches }
    }

    pub(crate) fn at(&self, point: [f32; 3]) -> Tolerance {
        let bounds = self.field.header().bounds;
        let nearest = [0, 1, 2].map(|axis: usize| point[axis].clamp(bounds.min[axis], bounds.max[axis]));
        let away = [0, 1, 2].map(|axis: usize| f64::from(point[axis]) - f64::from(nearest[axis]));
        let away = away.iter().map(|part| part * part).sum::<f64>().sqrt() as f32;

        let Scale { magnitude, length, shares: [of_distance, of_gradient] } = self.scale(nearest);
        let gradient = if away > 0.0 { 2.0_f32.powi(-20) } else { of_gradient * magnitude / length };
        // Zero differs from zero by nothing.
        let positive = |tolerance: f32| tolerance.max(f32::MIN_POSITIVE);
        Tolerance { distance: positive(of_distance * (magnitude + away)), gradient: positive(gradient) }
    }

    fn scale(&self, point: [f32; 3]) -> Scale {
        let low = self.field.header().bounds.min;
        let position = |edges: [f32; 3]| [0, 1, 2].map(|axis: usize| (point[axis] - low[axis]) / edges[axis]);
        let of_grid = |grid: Grid<'_>| scale_of_cell(&grid, position(grid.spacing()).map(|part| part as u32));
        let of_octree = |octree: Octree<'_>| {
            scale_of_leaf(&octree, &octree.leaf_at(position([octree.edge(octree.depth()); 3]).map(|part| part as u32)))
        };
        let of_polynomials =
            |octree: PolynomialOctree<'_>| self.scale_of_leaves(&octree, position([octree.edge(octree.depth()); 3]));
        let (grid, octree) = (self.field.grid().map(of_grid), self.field.octree().map(of_octree));
        let scale = grid.or(octree).or_else(|| self.field.polynomial_octree().map(of_polynomials));
        scale.expect("a family that this test knows")
    }

    /// Over the leaves whose supports hold a position, in finest cells.
    fn scale_of_leaves(&self, octree: &PolynomialOctree<'_>, position: [f32; 3]) -> Scale {
        let holds = |leaf: &Leaf, reach: f32| {
            // At the end of its support a leaf may have a say by one reader and none by the other.
            let reach = 1.001 * reach;
            [0, 1, 2].iter().all(|&axis: &usize| {
                let along = position[axis] - leaf.cell[axis] as f32;
                (-reach..=leaf.edge as f32 + reach).contains(&along)
            })
        };
        let finest = octree.edge(octree.depth());
        let mut scale = Scale { magnitude: 0.0, length: f32::MAX, shares: [2.0_f32.powi(-16), 2.0_f32.powi(-14)] };
        for (leaf, reach) in self.reaches.iter().filter(|(leaf, reach)| holds(leaf, *reach)) {
            let edge = octree.edge(leaf.level);
            let magnitude = sum_of_terms(|local| octree.evaluate(leaf, local.map(|part| part as f32)).0);
            scale.magnitude = scale.magnitude.max(magnitude);
            scale.length = scale.length.min(if *reach > 0.0 { reach * finest } else { edge });
        }
        scale
    }
}

fn scale_of_leaf(octree: &Octree<'_>, leaf: &Leaf) -> Scale {
    let length = octree.edge(leaf.level);
    let magnitude = largest_at_corners([length; 3], |local| octree.evaluate(leaf, local.map(|part| part as f32)));
    Scale { magnitude, length, shares: [2.0_f32.powi(-19), 2.0_f32.powi(-16)] }
}

fn scale_of_cell(grid: &Grid<'_>, cell: [u32; 3]) -> Scale {
    let spacing = grid.spacing();
    let sample = |local: [u32; 3]| grid.sample([0, 1, 2].map(|axis: usize| cell[axis] + local[axis]));
    Scale {
        magnitude: largest_at_corners(spacing, sample),
        length: spacing.into_iter().fold(f32::INFINITY, f32::min),
        shares: [2.0_f32.powi(-18), 2.0_f32.powi(-15)],
    }
}

/// The largest value, and slope along an edge, at the corners of a cell with these edges.
fn largest_at_corners(edges: [f32; 3], answer: impl Fn([u32; 3]) -> (f32, [f32; 3])) -> f32 {
    let corners = (0..8_u32).map(|corner| answer([corner >> 2, corner >> 1 & 1, corner & 1]));
    let largest = |(distance, slope): (f32, [f32; 3])| {
        slope.iter().zip(edges).map(|(part, edge)| (part * edge).abs()).fold(distance.abs(), f32::max)
    };
    corners.map(largest).fold(0.0, f32::max)
}

/// The magnitudes of the coefficients of a polynomial, added up, as far as its values at the corners tell them apart: those
/// of terms with the same sign at every corner are one sum. Legendre polynomials are 1 or -1 there.
fn sum_of_terms(value: impl Fn([u32; 3]) -> f32) -> f32 {
    let corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|corner: u32| value([corner >> 2, corner >> 1 & 1, corner & 1]));
    let of_signs = |signs: u32| {
        let signed = (0..8_u32)
            .zip(corners)
            .map(|(corner, value)| if (corner & signs).count_ones() % 2 == 1 { -value } else { value });
        signed.sum::<f32>().abs() / 8.0
    };
    (0..8).map(of_signs).sum()
}

/// Every leaf and how far it reaches beyond its cell, in finest cells, found from which leaves touch (SPEC.md §12.6).
fn reaches(octree: &PolynomialOctree<'_>) -> Vec<(Leaf, f32)> {
    let leaves: Vec<Leaf> = octree.leaves().collect();
    let touch = |a: &Leaf, b: &Leaf| {
        (0..3).all(|axis| a.cell[axis] <= b.cell[axis] + b.edge && b.cell[axis] <= a.cell[axis] + a.edge)
    };
    let reach = |leaf: &Leaf| {
        let deepest = leaves.iter().filter(|other| touch(leaf, other)).map(|other| other.level).max();
        let support = deepest.map_or(0, |deepest| deepest.saturating_sub(leaf.level)).min(3);
        octree.overlap() * leaf.edge as f32 / (1 << support) as f32
    };
    leaves.iter().map(|leaf| (*leaf, reach(leaf))).collect()
}

use crate::support::fitted::{Fit, ROOTS};
use crate::support::numbers::Numbers;
use crate::vectors::polynomial::PolynomialOctree;
use glam::DVec3;
use nearfield::Field;

const OVERLAPS: [f32; 4] = [0.0, 1.0 / 64.0, 0.2, 0.25];

fn fit(overlap: f32) -> Fit {
    Fit { overlap, tolerance: 8e-3, depth: 4 }
}

/// Positions in finest cells: anywhere, and near the faces, edges and corners of leaves.
fn positions(octree: &PolynomialOctree) -> Vec<DVec3> {
    let mut numbers = Numbers::new(5);
    let extent = f64::from(u32::from(ROOTS) << octree.depth);
    let mut positions: Vec<DVec3> = (0..3000).map(|_| numbers.point(DVec3::ZERO, DVec3::splat(extent))).collect();
    for placed in octree.leaves.iter().step_by(octree.leaves.len().div_ceil(2000)) {
        let corner = DVec3::from_array(placed.cell.map(|cell| cell as f64));
        let edge = placed.edge as f64;
        let mut local = numbers.point(DVec3::ZERO, DVec3::ONE);
        for axis in 0..3 {
            if numbers.unit() < 0.6 {
                let near = 0.3 * f64::from(octree.overlap) * (numbers.unit() - 0.5);
                local[axis] = (numbers.unit() * 2.0).floor() + near;
            }
        }
        positions.push((corner + edge * local).clamp(DVec3::ZERO, DVec3::splat(extent)));
    }
    positions
}

/// The place of a position, which comes back exactly.
fn point(octree: &PolynomialOctree, position: DVec3) -> ([f32; 3], DVec3) {
    let per_cell = octree.root_edge / (1_u32 << octree.depth) as f32;
    let point = [0, 1, 2].map(|axis: usize| octree.box_min[axis] + position[axis] as f32 * per_cell);
    let exact = [0, 1, 2].map(|axis: usize| f64::from((point[axis] - octree.box_min[axis]) / per_cell));
    (point, DVec3::from_array(exact))
}

#[test]
fn the_reader_is_the_sum_over_all_leaves() {
    for overlap in OVERLAPS {
        let fit = fit(overlap);
        let octree = fit.octree();
        let bytes = octree.file().bytes();
        let field = Field::open(&bytes).expect("a field");
        field.validate().expect("a valid field");

        let (mut blended, mut most) = (0, 0);
        for position in positions(&octree) {
            let (point, exact) = point(&octree, position);
            let (value, gradient) = field.distance_and_gradient(point);
            assert_eq!(field.distance(point).to_bits(), value.to_bits());
            let (expected, slope, count) = fit.naive(&octree, exact);
            if overlap == 0.0 && count > 1 {
                continue;
            }
            (blended, most) = (blended + usize::from(count > 1), most.max(count));
            assert!((f64::from(value) - expected).abs() < 2e-6, "{value} is not {expected} at {position}, {overlap}");
            for (part, expected) in gradient.into_iter().zip(slope.to_array()) {
                assert!((f64::from(part) - expected).abs() < 2e-4, "{part} is not {expected} at {position}, {overlap}");
            }
        }
        assert!(overlap == 0.0 || blended > 500 && most >= 5, "{blended} points blended, at most {most} leaves");
    }
}

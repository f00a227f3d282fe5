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

        let extent = f64::from(u32::from(ROOTS) << octree.depth);
        let (mut blended, mut most) = (0, 0);
        for position in positions(&octree) {
            let (point, exact) = point(&octree, position);
            let (value, gradient) = field.distance_and_gradient(point);
            assert_eq!(field.distance(point).to_bits(), value.to_bits());
            let (expected, slope, count) = fit.naive(&octree, exact);
            let polynomials = field.polynomial_octree().expect("polynomials");
            let (alone, _) = polynomials.unblended(point).expect("a point of the box");
            let alone_expected = fit.alone(&octree, exact.min(DVec3::splat(extent - 1e-6)));
            assert!((f64::from(alone) - alone_expected).abs() < 2e-6, "{alone} is not {alone_expected} at {position}");
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

/// Both sides of a face, this far from it, in finest cells. The value jumps by no more than the slope times twice that, and
/// the gradient by no more than its own slope times it: a hundred times less a hundred times nearer.
const SEPARATIONS: [f64; 2] = [0.5 / 16.0, 0.5 / 1024.0];

#[test]
fn seams_vanish_with_the_separation() {
    let fit = fit(0.2);
    let octree = fit.octree();
    let per_cell = f64::from(octree.root_edge) / f64::from(1_u32 << octree.depth);
    let extent = f64::from(u32::from(ROOTS) << octree.depth);
    let mut numbers = Numbers::new(6);
    let [mut jumps, mut turns, mut unblended] = [[0.0_f64; 2]; 3];
    for placed in octree.leaves.iter().step_by(octree.leaves.len().div_ceil(400)) {
        for axis in 0..3 {
            let corner = DVec3::from_array(placed.cell.map(|cell| cell as f64));
            let mut on_face = corner + placed.edge as f64 * numbers.point(DVec3::ZERO, DVec3::ONE);
            on_face[axis] = corner[axis];
            if !(1.0..extent - 1.0).contains(&on_face[axis]) {
                continue;
            }
            for (index, separation) in SEPARATIONS.into_iter().enumerate() {
                let step = DVec3::AXES[axis] * separation;
                let [below, above] = [-step, step].map(|step| fit.naive(&octree, on_face + step));
                jumps[index] = jumps[index].max((above.0 - below.0).abs());
                // A crease in a leaf stays one.
                let turn = (above.1 - below.1).length();
                turns[index] += turn.min(0.2);
                let leaf_alone = fit.alone(&octree, on_face - step) - fit.alone(&octree, on_face + step);
                unblended[index] = unblended[index].max(leaf_alone.abs());
            }
        }
    }
    let steepest = 4.0;
    assert!(jumps[1] < steepest * 2.0 * SEPARATIONS[1] * per_cell, "jumps of {jumps:?}");
    assert!(turns[1] < 0.1 * turns[0], "turns of {turns:?}");
    assert!(unblended[1] > 20.0 * jumps[1], "leaves alone jump by {unblended:?}, blended by {jumps:?}");
}

#[test]
fn a_cursor_answers_as_the_field_does() {
    for overlap in [0.0, 0.2] {
        let octree = fit(overlap).octree();
        let bytes = octree.file().bytes();
        let field = Field::open(&bytes).expect("a field");
        let (mut cursor, mut numbers) = (field.cursor(), Numbers::new(8));
        let extent = DVec3::splat(f64::from(u32::from(ROOTS) << octree.depth));
        for _ in 0..300 {
            let (mut position, aim) = (numbers.point(DVec3::ZERO, extent), numbers.point(DVec3::ZERO, extent));
            for _ in 0..20 {
                let (point, _) = point(&octree, position);
                let (distance, gradient) = field.distance_and_gradient(point);
                let (again, gradient_again) = cursor.distance_and_gradient(point);
                assert_eq!(again.to_bits(), distance.to_bits());
                assert_eq!(cursor.distance(point).to_bits(), distance.to_bits());
                assert_eq!(gradient_again.map(f32::to_bits), gradient.map(f32::to_bits));
                position += 0.05 * (aim - position) + 0.02;
            }
        }
    }
}

/// Rows along x, which stay in a leaf for a while and now and then leave the box, and every so often a point elsewhere.
#[test]
fn a_batch_answers_as_single_points_do() {
    for overlap in [0.0, 0.2] {
        let octree = fit(overlap).octree();
        let bytes = octree.file().bytes();
        let field = Field::open(&bytes).expect("a field");
        let extent = f64::from(u32::from(ROOTS) << octree.depth);
        let mut numbers = Numbers::new(9);
        let mut points = Vec::new();
        for row in 0..200 {
            let start = numbers.point(DVec3::ZERO, DVec3::splat(extent));
            for index in -5..205 {
                points.push(point(&octree, DVec3::new(f64::from(index) / 200.0 * extent, start.y, start.z)).0);
                if (index + row) % 17 == 0 {
                    points.push(point(&octree, numbers.point(DVec3::ZERO, DVec3::splat(extent))).0);
                }
            }
        }
        let (mut distances, mut again) = (vec![f32::NAN; points.len()], vec![f32::NAN; points.len()]);
        let mut gradients = vec![[f32::NAN; 3]; points.len()];
        assert_eq!(field.distances(&points, &mut distances), points.len());
        assert_eq!(field.distances_and_gradients(&points, &mut again, &mut gradients), points.len());
        for (index, &point) in points.iter().enumerate() {
            let (distance, gradient) = field.distance_and_gradient(point);
            assert_eq!(distances[index].to_bits(), distance.to_bits(), "{point:?}");
            assert_eq!(again[index].to_bits(), distance.to_bits(), "{point:?}");
            assert_eq!(gradients[index].map(f32::to_bits), gradient.map(f32::to_bits), "{point:?}");
        }
    }
}

#[test]
fn the_leaves_fill_the_box() {
    let written = fit(0.2).octree();
    let bytes = written.file().bytes();
    let field = Field::open(&bytes).expect("a field");
    let octree = field.polynomial_octree().expect("polynomials");
    assert!(field.octree().is_none() && field.grid().is_none());
    let leaves: Vec<_> = octree.leaves().collect();
    assert_eq!(leaves.len(), written.leaves.len());
    let volume: u64 = leaves.iter().map(|leaf| u64::from(leaf.edge).pow(3)).sum();
    assert_eq!(volume, octree.lattice().iter().map(|&cells| u64::from(cells)).product::<u64>());
    for leaf in leaves {
        assert_eq!(octree.leaf_at(leaf.cell), leaf);
        assert_eq!(octree.leaf_at(leaf.cell.map(|cell| cell + leaf.edge - 1)), leaf);
    }
}

//! No bytes and no point hurt the reader.

use crate::structure::repair;
use nearfield::{Cursor, Field, Leaf};

/// Leaves to look at: a damaged tree may have more than anyone can wait for.
const MOST_LEAVES: usize = 200;

/// Any bytes, and the same with checksums made right: the reader neither panics nor answers a finite point with anything
/// but finite numbers.
pub fn open_and_query(bytes: &[u8]) {
    structure_aware(bytes);
    let mut repaired = bytes.to_vec();
    repair(&mut repaired);
    structure_aware(&repaired);
}

/// A file as it is, which the target's mutator leaves with the right checksums.
pub fn structure_aware(bytes: &[u8]) {
    if let Ok(field) = Field::open(bytes) {
        let is_valid = field.validate().is_ok();
        let leaves = query(&field, bytes);
        levels(&field, bytes, is_valid);
        let octree = field.octree().map(|octree| octree.leaf_count());
        let polynomials = field.polynomial_octree().map(|octree| octree.leaf_count());
        if let Some(leaf_count) = octree.or(polynomials)
            && is_valid
            && leaves < MOST_LEAVES
        {
            assert_eq!(leaves, leaf_count as usize, "leaves of a valid tree");
        }
    }
}

/// What passes validation answers the same alone and in batches, and every leaf within its box.
pub fn validate_then_query(bytes: &[u8]) {
    let mut repaired = bytes.to_vec();
    repair(&mut repaired);
    let Ok(field) = Field::open(&repaired) else { return };
    if field.validate().is_err() {
        return;
    }
    query(&field, &repaired);

    let points: Vec<[f32; 3]> = points(&field, &repaired).collect();
    let (mut distances, mut gradients) = (vec![0.0; points.len()], vec![[0.0; 3]; points.len()]);
    assert_eq!(field.distances_and_gradients(&points, &mut distances, &mut gradients), points.len());
    for ((&point, distance), gradient) in points.iter().zip(&distances).zip(&gradients) {
        let (alone, gradient_alone) = field.distance_and_gradient(point);
        assert_eq!(alone.to_bits(), distance.to_bits(), "at {point:?}");
        assert_eq!(gradient_alone.map(f32::to_bits), gradient.map(f32::to_bits), "at {point:?}");
    }

    let check = |leaf: Leaf, found: Leaf, lattice: [u32; 3]| {
        assert!((0..3).all(|axis| leaf.cell[axis] + leaf.edge <= lattice[axis]), "{leaf:?} exceeds {lattice:?}");
        assert_eq!(found, leaf);
    };
    if let Some(octree) = field.octree() {
        let leaves = octree.leaves().take(MOST_LEAVES);
        leaves.for_each(|leaf| check(leaf, octree.leaf_at(leaf.cell), octree.lattice()));
    }
    if let Some(octree) = field.polynomial_octree() {
        let leaves = octree.leaves().take(MOST_LEAVES);
        leaves.for_each(|leaf| check(leaf, octree.leaf_at(leaf.cell), octree.lattice()));
    }
}

/// Levels of detail are fields like any other, in whichever way they are found.
fn levels(field: &Field<'_>, bytes: &[u8], is_valid: bool) {
    for number in 1..field.lod_count() {
        let level = field.lod(number);
        assert!(!is_valid || level.is_some(), "a level of a valid file does not open");
        level.iter().for_each(|level| _ = query(level, bytes));
    }
    assert!(field.lod(field.lod_count()).is_none(), "more levels than there are");
    for length in [bytes.len() / 4, bytes.len() / 2, bytes.len() - 1] {
        if let Ok(level) = Field::open_prefix(&bytes[..length]) {
            query(&level, bytes);
        }
    }
}

/// Queries at many points; answers the number of leaves that it looked at.
fn query(field: &Field<'_>, bytes: &[u8]) -> usize {
    let mut cursor = field.cursor();
    for point in points(field, bytes) {
        check(field, &mut cursor, point);
    }
    if let Some(grid) = field.grid() {
        let last = grid.resolution().map(|samples| samples - 2);
        for cell in [[0; 3], last, [u32::MAX; 3]] {
            let (distance, gradient) = grid.evaluate(cell, [0.0, 0.5, 1.0]);
            assert!(distance.is_finite() && gradient.iter().all(|component| component.is_finite()), "{cell:?}");
        }
    }
    let finite = |(distance, gradient): (f32, [f32; 3])| {
        assert!(distance.is_finite() && gradient.iter().all(|component| component.is_finite()), "{distance}");
    };
    let inside = [0.0, 0.5, 1.0];
    let octree = field.octree().into_iter();
    let leaves =
        octree.flat_map(|octree| octree.leaves().take(MOST_LEAVES).map(move |leaf| octree.evaluate(&leaf, inside)));
    let polynomials = field.polynomial_octree().into_iter();
    let others = polynomials
        .flat_map(|octree| octree.leaves().take(MOST_LEAVES).map(move |leaf| octree.evaluate(&leaf, inside)));
    leaves.chain(others).map(finite).count()
}

/// Points from the last words of a file: as they are, and scaled into the box.
pub(crate) fn points(field: &Field<'_>, bytes: &[u8]) -> impl Iterator<Item = [f32; 3]> {
    let bounds = field.header().bounds;
    let numbers = bytes.as_chunks::<4>().0.iter().rev().map(|word| f32::from_le_bytes(*word));
    let wild: Vec<f32> = numbers.take(30).collect();
    let within = move |point: [f32; 3]| {
        [0, 1, 2].map(|axis| {
            let (min, max) = (bounds.min[axis], bounds.max[axis]);
            min + point[axis].to_bits() as f32 / u32::MAX as f32 * (max - min)
        })
    };
    let wild = wild.as_chunks::<3>().0.to_vec();
    wild.into_iter().flat_map(move |point| [point, within(point)])
}

fn check(field: &Field<'_>, cursor: &mut Cursor<'_>, point: [f32; 3]) {
    let (distance, gradient) = field.distance_and_gradient(point);
    assert_eq!(distance.to_bits(), cursor.distance(point).to_bits(), "at {point:?}");
    assert_eq!(distance.to_bits(), field.distance(point).to_bits(), "at {point:?}");
    if point.iter().all(|coordinate| coordinate.is_finite()) {
        assert!(distance.is_finite(), "{distance} at {point:?}");
        assert!(gradient.iter().all(|component| component.is_finite()), "at {point:?}");
    }
}

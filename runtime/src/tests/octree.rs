//! Points, leaves and their order.

use std::vec::Vec;

use super::file::{Random, open, three_levels};
use crate::layout::octree;

#[test]
fn leaves_come_in_order_and_tile_the_box() {
    let bytes = three_levels().bytes();
    let octree = open(&bytes).octree().expect("an octree");
    let leaves: Vec<_> = octree.leaves().collect();
    assert_eq!(leaves.len(), octree.leaf_count() as usize);

    let cells: Vec<_> = leaves.iter().map(|leaf| leaf.cell).collect();
    let eighth = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [0, 0, 1], [1, 0, 1], [0, 1, 1], [1; 3]];
    let mut expected = std::vec![[0, 0, 0]];
    expected.extend(eighth.map(|[x, y, z]| [4 + 2 * x, 2 * y, 2 * z]));
    expected.extend(eighth[..3].iter().map(|[x, y, z]| [8 + 2 * x, 2 * y, 2 * z]));
    expected.extend(eighth.map(|[x, y, z]| [10 + x, 2 + y, z]));
    expected.extend(eighth[4..].iter().map(|[x, y, z]| [8 + 2 * x, 2 * y, 2 * z]));
    assert_eq!(cells, expected);

    let volume: u32 = leaves.iter().map(|leaf| leaf.edge.pow(3)).sum();
    assert_eq!(volume, octree.lattice().into_iter().product());
    for leaf in &leaves {
        assert_eq!(u32::from(octree.depth() - leaf.level), leaf.edge.ilog2());
        let last = leaf.cell.map(|least| least + leaf.edge - 1);
        assert_eq!(octree.leaf_at(leaf.cell), *leaf);
        assert_eq!(octree.leaf_at(last), *leaf);
    }
    assert_eq!(octree.leaf_at([u32::MAX; 3]), octree.leaf_at([11, 3, 3]), "clamped");
}

#[test]
fn a_point_on_a_face_belongs_to_the_greater_leaf() {
    let bytes = three_levels().bytes();
    let octree = open(&bytes).octree().expect("an octree");
    let (leaf, local) = octree.locate([3.0, 2.0, 3.0]);
    assert_eq!((leaf.cell, leaf.level, local), ([4, 0, 0], 1, [0.0; 3]));
    let (leaf, local) = octree.locate([2.999_999_8, 2.0, 3.0]);
    assert_eq!((leaf.cell, leaf.level), ([0; 3], 0));
    assert!(local[0] < 1.0 && local[0] > 0.999_999);

    let greatest = octree.bounds().max;
    let (leaf, local) = octree.locate(greatest);
    assert_eq!((leaf.cell, local), ([10, 2, 2], [1.0; 3]), "the box holds its greatest corner");
}

#[test]
fn local_coordinates_stay_within_the_leaf() {
    // An edge that is no power of two, far from the origin.
    let mut file = three_levels();
    file.root_edge = 0.377;
    file.quantum = 0.001;
    file.box_min = [100.1, -7.3, 0.01];
    let bytes = file.bytes();
    let field = open(&bytes);
    let (octree, bounds) = (field.octree().expect("an octree"), field.header().bounds);
    let mut random = Random::new(3);
    for _ in 0..5000 {
        let unit = random.point();
        let point = [0, 1, 2].map(|i| bounds.min[i] + unit[i] * (bounds.max[i] - bounds.min[i]));
        if !octree.lattice.contains(point) {
            continue;
        }
        let (leaf, local) = octree.locate(point);
        assert!(local.iter().all(|t| (0.0..=1.0).contains(t)), "{local:?}");
        let edge = octree.edge(octree.depth());
        for axis in 0..3 {
            let there = bounds.min[axis] + edge * (leaf.cell[axis] as f32 + local[axis] * leaf.edge as f32);
            assert!((there - point[axis]).abs() < 2e-5, "{there} {point:?}");
        }
    }
}

#[test]
fn batches_answer_as_single_points_do() {
    let bytes = three_levels().bytes();
    let field = open(&bytes);
    let mut random = Random::new(4);
    let points: Vec<_> = (0..100).map(|_| random.point().map(|unit| 9.0 * unit)).collect();
    let (mut distances, mut gradients) = ([9.0; 70], [[9.0; 3]; 60]);

    assert_eq!(field.distances(&points[..50], &mut distances), 50);
    assert_eq!(distances[50], 9.0, "nothing beyond the shorter slice is written");
    assert_eq!(field.distances(&points, &mut distances), 70);
    assert_eq!(field.distances_and_gradients(&points, &mut distances, &mut gradients), 60);
    for (index, &point) in points[..60].iter().enumerate() {
        let answer = (distances[index], gradients[index]);
        assert_eq!(answer, field.distance_and_gradient(point));
    }
    assert_eq!(distances[60], field.distance(points[60]), "from the call before");
}

#[test]
fn the_deepest_and_widest_lattice_opens() {
    let mut file = three_levels();
    file.depth = octree::MAX_DEPTH;
    file.root_cells = [3, 1, 1];
    let bytes = file.bytes();
    let octree = open(&bytes).octree().expect("an octree");
    assert_eq!(octree.lattice(), [3 << 16, 1 << 16, 1 << 16]);
    assert_eq!(octree.leaves().count(), 24);
}

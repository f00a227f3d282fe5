//! Welds vertices and drops degenerate triangles.

use crate::geometry::has_area;
use crate::import::TriangleSoup;
use glam::DVec3;
use rayon::prelude::*;
use rustc_hash::FxHashMap;

pub(super) struct Welded {
    pub(super) positions: Vec<DVec3>,
    pub(super) triangles: Vec<[u32; 3]>,
    /// Vertices of the soup that shared a position with an earlier one.
    pub(super) duplicates: usize,
}

const UNUSED: u32 = u32::MAX;

pub(super) fn weld(soup: &TriangleSoup) -> Welded {
    // The first vertex at each position stands for all of them.
    let mut first_at = FxHashMap::default();
    first_at.reserve(soup.positions.len());
    let first: Vec<u32> = (0u32..)
        .zip(&soup.positions)
        .map(|(vertex, &position)| *first_at.entry(bits(position)).or_insert(vertex))
        .collect();
    let duplicates = soup.positions.len() - first_at.len();
    drop(first_at);

    // Triangles that keep three corners and an area.
    let mut triangles: Vec<[u32; 3]> = soup
        .triangles
        .par_iter()
        .map(|triangle| triangle.map(|vertex| first[vertex as usize]))
        .filter(|triangle| has_area(triangle.map(|vertex| soup.positions[vertex as usize])))
        .collect();

    // Vertices that are left, in their order.
    let mut renumbered = vec![UNUSED; soup.positions.len()];
    for &vertex in triangles.as_flattened() {
        renumbered[vertex as usize] = vertex;
    }
    let mut positions = Vec::new();
    for number in renumbered.iter_mut().filter(|number| **number != UNUSED) {
        // Adding zero turns −0 into 0.
        positions.push(soup.positions[*number as usize] + 0.0);
        *number = positions.len() as u32 - 1;
    }
    triangles.par_iter_mut().flatten().for_each(|vertex| *vertex = renumbered[*vertex as usize]);

    Welded { positions, triangles, duplicates }
}

fn bits(position: DVec3) -> [u64; 3] {
    (position + 0.0).to_array().map(f64::to_bits)
}

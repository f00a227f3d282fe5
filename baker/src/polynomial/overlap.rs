//! How far leaves reach into one another, and what the field is where they do (partition of unity, after
//! Ohtake et al. 2003).

use super::cells::{Cell, Cells, Content};
use crate::quantize::piece::Steps;
use crate::sampling::cell::Piece;
use glam::{DVec3, UVec3};
use nearfield::layout::leaf::{MAX_REACH, MAX_SUPPORT};
use rayon::prelude::*;

/// The codes of a leaf that a query would else have to find out from its neighbours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Reach {
    /// The leaf reaches overlap · edge · 2^-support beyond its cell.
    pub support: u8,
    /// No leaf reaches deeper than overlap · edge · 2^(1 - reach) into this one, if it is not 0.
    pub reach: u8,
}

/// The codes of every leaf, by its place among the cells; those of inner cells mean nothing.
pub fn reaches(cells: &Cells) -> Vec<Reach> {
    let supports: Vec<u8> = (0..cells.all.len())
        .into_par_iter()
        .map(|place| {
            let level = cells.all[place].level;
            if matches!(cells.all[place].content, Content::Inner(_)) {
                return 0;
            }
            let mut deepest = level;
            cells.visit_touching(place, |_, other| deepest = deepest.max(other.level));
            (deepest - level).min(MAX_SUPPORT as u8)
        })
        .collect();
    (0..cells.all.len())
        .into_par_iter()
        .map(|place| {
            if matches!(cells.all[place].content, Content::Inner(_)) {
                return Reach::default();
            }
            // A leaf of level l and support s reaches as far as one of level l + s would reach with none.
            let level = i32::from(cells.all[place].level);
            let mut farthest = i32::MAX;
            cells.visit_touching(place, |other, cell| {
                farthest = farthest.min(i32::from(cell.level) + i32::from(supports[other]));
            });
            let reach = farthest.saturating_sub(level).saturating_add(1).clamp(0, MAX_REACH as i32);
            Reach { support: supports[place], reach: reach as u8 }
        })
        .collect()
}

/// The leaves of a field, decoded, for answers in `f64` that take no short cut.
pub struct Blend<'a> {
    cells: &'a Cells,
    overlap: f64,
    pieces: Vec<Option<Piece>>,
    supports: Vec<Support>,
}

/// Where a cell has a say, mesh units: a great leaf has many beside it, of which few have one at any point.
#[derive(Clone, Copy)]
struct Support {
    centre: DVec3,
    /// Half the edge of the cell.
    half: f64,
    /// How far it reaches beyond.
    beyond: f64,
}

impl<'a> Blend<'a> {
    /// Decodes all leaves.
    pub fn new(cells: &'a Cells, reaches: &[Reach], overlap: f64, steps: &Steps) -> Self {
        let mut pieces = vec![None; cells.all.len()];
        for (place, _, coded) in cells.leaves() {
            pieces[place] = Some(steps.decode(coded));
        }
        let support = |(cell, reach): (&Cell, &Reach)| {
            let half = 0.5 * cells.domain.edge(cell.level);
            let beyond = overlap * 2.0 * half / f64::from(1u32 << reach.support);
            Support { centre: cells.domain.point(cell.origin) + half, half, beyond }
        };
        let supports = cells.all.iter().zip(reaches).map(support).collect();
        Self { cells, overlap, pieces, supports }
    }

    /// How far leaves reach beyond their cells at most, as a share of the edge.
    pub fn overlap(&self) -> f64 {
        self.overlap
    }

    /// Value and gradient at a point of the domain, mesh units.
    pub fn evaluate(&self, point: DVec3) -> (f64, DVec3) {
        let domain = &self.cells.domain;
        let place = (point - domain.origin) / domain.edge(domain.depth);
        let last = domain.lattice_size() - UVec3::ONE;
        let here = place.max(DVec3::ZERO).as_uvec3().min(last);
        let mut holder = None;
        self.cells.visit_leaves_in(here, here + UVec3::ONE, |index, cell| {
            let far = cell.origin + domain.lattice_edge(cell.level);
            if cell.origin.cmple(here).all() && here.cmplt(far).all() {
                holder = Some(index);
            }
        });
        self.evaluate_among(&self.near(holder.expect("leaves fill the domain")), point)
    }

    /// A leaf and all others that reach into its cell: of those that touch it, for no other can.
    pub fn near(&self, leaf: usize) -> Vec<usize> {
        let mut near = vec![leaf];
        if self.overlap > 0.0 {
            self.cells.visit_touching(leaf, |other, _| near.push(other));
        }
        near
    }

    /// The same as [`evaluate`](Self::evaluate), of a point in the cell that these leaves are near to.
    pub fn evaluate_among(&self, near: &[usize], point: DVec3) -> (f64, DVec3) {
        if self.overlap == 0.0 {
            return self.leaf(near[0], point);
        }
        let (mut sum, mut sum_gradient) = (0.0, DVec3::ZERO);
        let (mut weights, mut weights_gradient) = (0.0, DVec3::ZERO);
        for &leaf in near {
            let (weight, weight_gradient) = self.weight(leaf, point);
            if weight > 0.0 {
                let (value, gradient) = self.leaf(leaf, point);
                sum += weight * value;
                sum_gradient += weight * gradient + value * weight_gradient;
                weights += weight;
                weights_gradient += weight_gradient;
            }
        }
        let value = sum / weights;
        (value, (sum_gradient - value * weights_gradient) / weights)
    }

    /// Whether a leaf near a point has a say in the answer there.
    pub fn reaches(&self, leaf: usize, point: DVec3) -> bool {
        self.overlap == 0.0 || self.weight(leaf, point).0 > 0.0
    }

    /// What a leaf alone answers anywhere, mesh units.
    pub fn leaf(&self, index: usize, point: DVec3) -> (f64, DVec3) {
        let (local, half) = self.cells.local(index, point);
        let (value, gradient) = self.pieces[index].expect("a leaf has a piece").evaluate(local);
        (value, gradient / half)
    }

    /// Product of smooth steps over the distance inside along each axis.
    fn weight(&self, index: usize, point: DVec3) -> (f64, DVec3) {
        let Support { centre, half, beyond } = self.supports[index];
        let offset = point - centre;
        if offset.abs().max_element() >= half + beyond {
            return (0.0, DVec3::ZERO);
        }
        let (mut steps, mut slopes) = ([0.0; 3], [0.0; 3]);
        for axis in 0..3 {
            let t = (0.5 + (half - offset[axis].abs()) / (2.0 * beyond)).clamp(0.0, 1.0);
            steps[axis] = t * t * (3.0 - 2.0 * t);
            slopes[axis] = -offset[axis].signum() * 6.0 * t * (1.0 - t) / (2.0 * beyond);
        }
        let gradient = DVec3::new(
            slopes[0] * steps[1] * steps[2],
            steps[0] * slopes[1] * steps[2],
            steps[0] * steps[1] * slopes[2],
        );
        (steps[0] * steps[1] * steps[2], gradient)
    }
}

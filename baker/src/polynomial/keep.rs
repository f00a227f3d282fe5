//! Keeps a greatest error: looks for it between the samples of leaves, and fits or splits those again that exceed it.

use super::cells::{Cell, Cells, Content, octant};
use super::choose::{self, Check};
use super::overlap::{self, Blend};
use super::refine::Refinement;
use crate::field_function::Sample;
use crate::quantize::piece::Steps;
use crate::sampling::cell::{CellSamples, POINTS};
use glam::{DVec3, UVec3};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use thiserror::Error;

/// Least number of parts of a leaf along each axis that are probed at first, each at its centre.
const LEAST_PARTS: u32 = 4;
/// Most of these.
const MOST_PARTS: u32 = 64;
/// Greatest edge of such a part, in greatest errors: the distance has kinks wherever two parts of the surface are equally
/// near, and what falls short of one is wrong by no more than the way to the kink.
const PART_EDGE: f64 = 3.0;
/// How often a part is cut into eight while its probe leaves doubt.
const CUTS: u32 = 3;
/// A probe leaves doubt if it errs by this share of the greatest error, or would within its part if the error went on
/// growing as it does there.
const DOUBTFUL_SHARE: f64 = 0.6;
/// How often a cell is fitted with what was found wrong before it is split.
const ATTEMPTS: usize = 3;
/// Leaves that are probed at once.
const BATCH: usize = 1 << 8;

/// A greatest error that the deepest leaves do not keep.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("a leaf of the greatest depth is off by {error:e} at ({}, {}, {})", at.x, at.y, at.z)]
pub struct Unkept {
    /// How far it is off, mesh units.
    pub error: f64,
    /// Where, mesh frame.
    pub at: DVec3,
}

/// A part of a leaf, a cube.
#[derive(Clone, Copy)]
struct Part<'a> {
    /// Where it is, mesh frame.
    centre: DVec3,
    /// Half its edge, mesh units.
    half: f64,
    /// Its leaf and those that reach into that.
    near: &'a [usize],
}

/// A leaf to probe.
struct Suspect {
    leaf: usize,
    /// The cells whose answers have changed since it was probed; none if it was not.
    changed: Vec<usize>,
}

/// What was found wrong with a cell.
#[derive(Default)]
struct Record {
    checks: Vec<Check>,
    attempts: usize,
}

impl Refinement<'_> {
    /// Makes the blended field keep the greatest error of the demand wherever probes find that it does not. No proof: probes
    /// are as dense as the greatest error is small, and denser where it is near.
    ///
    /// # Errors
    /// [`Unkept`] if a leaf at the greatest depth exceeds it however it is fitted.
    pub(super) fn keep(&mut self, cells: &mut Cells, overlap: f64) -> Result<(), Unkept> {
        let mut records: BTreeMap<usize, Record> = BTreeMap::new();
        let mut reaches = overlap::reaches(cells);
        let mut suspects: Vec<Suspect> =
            cells.leaves().map(|(leaf, ..)| Suspect { leaf, changed: Vec::new() }).collect();
        loop {
            let blend = Blend::new(cells, &reaches, overlap, &self.steps);
            let found = self.probe(cells, &blend, &suspects);
            if found.is_empty() {
                return Ok(());
            }
            for &(place, check) in &found {
                records.entry(place).or_default().checks.push(check);
            }

            // Again, with what was found.
            let wrong: BTreeSet<usize> = found.iter().map(|&(place, _)| place).collect();
            let before = cells.all.len();
            self.mend(cells, &wrong, &mut records)?;

            // Where the field could be another now.
            let old = std::mem::replace(&mut reaches, overlap::reaches(cells));
            let is_split =
                |place: usize| matches!(cells.all[place].content, Content::Inner(first) if first as usize >= before);
            let is_changed = |&place: &usize| wrong.contains(&place) || is_split(place) || old[place] != reaches[place];
            suspects = beside(cells, (0..before).filter(is_changed));
        }
    }

    /// Points where the field errs too much, with the leaves that err as much by themselves: the field is a mean of leaves,
    /// so that there is at least one.
    fn probe(&mut self, cells: &Cells, blend: &Blend<'_>, suspects: &[Suspect]) -> Vec<(usize, Check)> {
        let mut found = Vec::new();
        for batch in suspects.chunks(BATCH) {
            let near: Vec<Vec<usize>> = batch.par_iter().map(|suspect| blend.near(suspect.leaf)).collect();
            let mut parts: Vec<Part<'_>> = batch
                .iter()
                .zip(&near)
                .flat_map(|(suspect, near)| {
                    let parts = self.parts_of(cells, blend, suspect.leaf);
                    let parts = parts.map(|(centre, half)| Part { centre, half, near });
                    parts.filter(|part| suspect.is_in_question(cells, blend, part))
                })
                .collect();
            for cut in 0..=CUTS {
                let centres: Vec<DVec3> = parts.iter().map(|part| part.centre).collect();
                let samples = self.sample_all(&centres);
                let looks: Vec<Look> = parts
                    .par_iter()
                    .zip(&samples)
                    .map(|(part, sample)| part.look(cells, blend, sample, self.demand.greatest_at(sample.distance)))
                    .collect();
                let in_doubt = parts.iter().zip(&looks).filter(|(_, look)| look.is_in_doubt && cut < CUTS);
                let smaller = in_doubt.flat_map(|(part, _)| part.eighths()).collect();
                found.extend(looks.into_iter().flat_map(|look| look.wrong));
                parts = smaller;
            }
        }
        found
    }

    /// Centres of the parts of a leaf that are probed first, x fastest, and their half edges, mesh units.
    fn parts_of(&self, cells: &Cells, blend: &Blend<'_>, leaf: usize) -> impl Iterator<Item = (DVec3, f64)> {
        let cell = &cells.all[leaf];
        let (edge, least) = (cells.domain.edge(cell.level), cells.domain.point(cell.origin));
        let (distance, _) = blend.leaf(leaf, least + 0.5 * edge);
        let nearest = (distance.abs() - edge).max(0.0);
        let parts = (edge / (PART_EDGE * self.demand.greatest_at(nearest))).ceil();
        let parts = (parts as u32).clamp(LEAST_PARTS, MOST_PARTS);
        let half = 0.5 * edge / f64::from(parts);
        (0..parts.pow(3)).map(move |index| {
            let part = UVec3::new(index % parts, index / parts % parts, index / parts / parts);
            (least + half * (2.0 * part.as_dvec3() + 1.0), half)
        })
    }

    /// Fits cells again so that they pass their checks, or splits them.
    fn mend(
        &mut self,
        cells: &mut Cells,
        wrong: &BTreeSet<usize>,
        records: &mut BTreeMap<usize, Record>,
    ) -> Result<(), Unkept> {
        let places: Vec<usize> = wrong.iter().copied().collect();
        let points: Vec<DVec3> = places
            .iter()
            .flat_map(|&place| self.points_of(&cells.domain, cells.all[place].origin, cells.all[place].level))
            .collect();
        let samples = self.sample_all(&points);
        for (&place, samples) in places.iter().zip(samples.chunks(POINTS)) {
            let record = records.get_mut(&place).expect("something was found wrong with it");
            record.attempts += 1;
            let level = cells.all[place].level;
            let (edge, tolerance) = (cells.domain.edge(level), self.demand.of(samples));
            let cell = CellSamples { stencil: &self.stencil, samples, edge };
            let again = choose::cheapest(&self.steps, &cell, &cell.fits(), &record.checks, tolerance);
            match again.filter(|_| record.attempts <= ATTEMPTS) {
                Some(coded) => cells.all[place].content = Content::Leaf(Box::new(coded)),
                None if level < cells.domain.depth => {
                    self.split(cells, &[place], level + 1);
                }
                None => return Err(unkept(cells, place, &record.checks, &self.steps)),
            }
        }
        self.complete(cells);
        Ok(())
    }
}

/// What a probe tells.
struct Look {
    /// Whether the field could err too much elsewhere in the part.
    is_in_doubt: bool,
    /// The leaves that err too much at the probe, if the field does.
    wrong: Vec<(usize, Check)>,
}

impl Part<'_> {
    /// Compares the field with the function at the centre.
    fn look(&self, cells: &Cells, blend: &Blend<'_>, sample: &Sample, within: f64) -> Look {
        let (value, gradient) = blend.evaluate_among(self.near, self.centre);
        let error = (value - sample.distance).abs();
        if error > within {
            let errs = |leaf: usize| (blend.leaf(leaf, self.centre).0 - sample.distance).abs() > within;
            let wrong = self.near.iter().filter(|&&leaf| blend.reaches(leaf, self.centre) && errs(leaf));
            let check = |leaf| Check { at: cells.local(leaf, self.centre).0, distance: sample.distance, within };
            return Look { is_in_doubt: false, wrong: wrong.map(|&leaf| (leaf, check(leaf))).collect() };
        }
        let growth = self.half * (gradient - sample.gradient).abs().element_sum();
        let is_in_doubt = error > DOUBTFUL_SHARE * within || error + growth > within;
        Look { is_in_doubt, wrong: Vec::new() }
    }

    fn eighths(self) -> impl Iterator<Item = Self> {
        let half = 0.5 * self.half;
        (0..8).map(move |index| {
            let centre = self.centre + half * (2.0 * octant(index).as_dvec3() - 1.0);
            Self { centre, half, near: self.near }
        })
    }
}

impl Suspect {
    /// Whether a changed cell reaches the part.
    fn is_in_question(&self, cells: &Cells, blend: &Blend<'_>, part: &Part<'_>) -> bool {
        let is_reached = |&place: &usize| {
            let cell = &cells.all[place];
            let edge = cells.domain.edge(cell.level);
            let centre = cells.domain.point(cell.origin) + 0.5 * edge;
            (part.centre - centre).abs().max_element() <= (0.5 + blend.overlap()) * edge + part.half
        };
        self.changed.is_empty() || self.changed.iter().any(is_reached)
    }
}

/// The leaves that changed cells reach or have reached, each with those cells.
fn beside(cells: &Cells, changed: impl Iterator<Item = usize>) -> Vec<Suspect> {
    let mut suspects: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for place in changed {
        let Cell { origin, level, .. } = cells.all[place];
        cells.visit_leaves_in(origin, origin + cells.domain.lattice_edge(level), |leaf, _| {
            suspects.entry(leaf).or_default().push(place);
        });
    }
    suspects.into_iter().map(|(leaf, changed)| Suspect { leaf, changed }).collect()
}

fn unkept(cells: &Cells, place: usize, checks: &[Check], steps: &Steps) -> Unkept {
    let cell = &cells.all[place];
    let Content::Leaf(coded) = &cell.content else { unreachable!("the caller has seen a leaf") };
    let piece = steps.decode(coded);
    let error = |check: &Check| (piece.evaluate(check.at).0 - check.distance).abs();
    let worst = checks.iter().max_by(|a, b| (error(a) / a.within).total_cmp(&(error(b) / b.within)));
    let worst = worst.expect("something was found wrong with it");
    let half = 0.5 * cells.domain.edge(cell.level);
    let at = cells.domain.point(cell.origin) + half * (worst.at + 1.0);
    Unkept { error: error(worst), at }
}

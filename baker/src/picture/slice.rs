//! A plane through a field.

use super::colour;
use super::image::{Image, Rgb};
use super::plane::{Cut, Plane};
use super::scale_bar;
use crate::field_function::FieldFunction;
use glam::DVec3;
use nearfield::{Field, Leaf};
use rayon::prelude::*;

/// What to draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slice {
    /// The plane.
    pub cut: Cut,
    /// Pixels along the longer side of the picture, at least one.
    pub resolution: u32,
    /// Draw the borders of the leaves.
    pub cells: bool,
}

/// About as many isolines between the surface and the farthest point of the picture.
const ISOLINES: f64 = 20.0;

/// Draws a slice: colours by distance, grey isolines at round distances, the surface black. Given the truth, red
/// is where its sign is a guess.
pub fn slice(field: &Field<'_>, request: &Slice, truth: Option<&dyn FieldFunction>) -> Image {
    let section = Section::of(field, request);
    let raster = &section.raster;
    let range = raster.distances.iter().fold(0.0, |range: f32, distance| range.max(distance.abs()));
    let range = f64::from(range.max(f32::MIN_POSITIVE));
    let spacing = round_number(range / ISOLINES);
    let pixels = (0..raster.distances.len()).map(|index| raster.shade(index, range, spacing)).collect();
    section.finish(field, request, truth, pixels)
}

/// Draws the size of the error of a slice, white where there is none, and below it what the colours mean, mesh units.
/// The surface is black, red is where the sign of the truth is a guess, and grey is outside the field's box, where its
/// answers are bounds and not distances.
pub fn error_map(field: &Field<'_>, request: &Slice, truth: &dyn FieldFunction) -> Image {
    let section = Section::of(field, request);
    let raster = &section.raster;
    let points: Vec<DVec3> =
        section.rows.iter().flatten().map(|point| DVec3::from_array(point.map(f64::from))).collect();
    let exact = truth.sample_all(&points);
    let bounds = field.header().bounds;
    let errors: Vec<Option<f64>> = (section.rows.iter().flatten().zip(&raster.distances).zip(exact))
        .map(|((&point, &found), exact)| bounds.contains(point).then(|| (f64::from(found) - exact.distance).abs()))
        .collect();

    let greatest = round_number(errors.iter().flatten().copied().fold(f64::MIN_POSITIVE, f64::max));
    let range = raster.distances.iter().fold(0.0, |range: f32, distance| range.max(distance.abs()));
    let shade = |(index, error): (usize, &Option<f64>)| {
        let Some(error) = error else { return colour::BEYOND };
        let coverage = raster.coverage(index, f64::from(raster.distances[index]), 0.5, range.into());
        colour::mix(colour::of_error(error / greatest), colour::SURFACE, coverage)
    };
    let pixels = errors.iter().enumerate().map(shade).collect();
    scale_bar::below(section.finish(field, request, Some(truth), pixels), greatest, colour::of_error)
}

/// The points of a slice, row by row, and the field's distances there.
struct Section {
    rows: Vec<Vec<[f32; 3]>>,
    raster: Raster,
}

impl Section {
    fn of(field: &Field<'_>, request: &Slice) -> Self {
        let plane = Plane::through(field, &request.cut, request.resolution);
        let rows: Vec<Vec<[f32; 3]>> = (0..plane.height).map(|row| plane.row(row)).collect();
        let distances = rows.par_iter().flat_map_iter(|points| {
            let mut distances = vec![0.0; points.len()];
            field.distances(points, &mut distances);
            distances
        });
        let raster = Raster { width: plane.width, distances: distances.collect() };
        Self { rows, raster }
    }

    /// Draws over the colours what was asked for.
    fn finish(
        &self,
        field: &Field<'_>,
        request: &Slice,
        truth: Option<&dyn FieldFunction>,
        mut pixels: Vec<Rgb>,
    ) -> Image {
        let Self { rows, raster } = self;

        // Borders of the leaves or cells.
        if request.cells {
            let cells: Vec<Cell> = rows.par_iter().flatten_iter().map(|&point| cell_of(field, point)).collect();
            for (index, pixel) in pixels.iter_mut().enumerate() {
                let (right, below) = raster.neighbours(index);
                if cells[index] != cells[right] || cells[index] != cells[below] {
                    *pixel = colour::mix(*pixel, colour::CELL, 0.45);
                }
            }
        }

        // Doubt.
        if let Some(truth) = truth {
            let doubts = |&point: &[f32; 3]| truth.sign_is_doubtful(DVec3::from_array(point.map(f64::from)));
            let doubtful: Vec<bool> = rows.par_iter().flatten_iter().map(doubts).collect();
            for (pixel, _) in pixels.iter_mut().zip(doubtful).filter(|(_, is_doubtful)| *is_doubtful) {
                *pixel = colour::mix(*pixel, colour::DOUBT, 0.7);
            }
        }

        Image::new(raster.width as u32, pixels)
    }
}

struct Raster {
    width: usize,
    distances: Vec<f32>,
}

impl Raster {
    /// The pixels to the right and below, or the pixel itself at the border.
    fn neighbours(&self, index: usize) -> (usize, usize) {
        let right = if (index + 1).is_multiple_of(self.width) { index } else { index + 1 };
        let below = if index + self.width < self.distances.len() { index + self.width } else { index };
        (right, below)
    }

    /// How much of a pixel is covered by a line where `offset`, a distance less that of the line, is zero: its width is
    /// given in pixels, its edge blurred over one. Where the distance hardly changes, compared with `range`, lines stay
    /// narrow.
    fn coverage(&self, index: usize, offset: f64, half_width: f64, range: f64) -> f64 {
        let at = |index: usize| f64::from(self.distances[index]);

        // How much the distance changes from pixel to pixel: what turns a distance into a line's width.
        let (right, below) = self.neighbours(index);
        let (left, above) = (index - (index % self.width).min(1), index.checked_sub(self.width).unwrap_or(index));
        let slope = |from: usize, to: usize, step: usize| {
            let pixels = (to - from) / step;
            if pixels == 0 { 0.0 } else { (at(to) - at(from)) / pixels as f64 }
        };
        let (across, down) = (slope(left, right, 1), slope(above, below, self.width));
        let change = (across * across + down * down).sqrt().max(1e-6 * range);

        (half_width + 0.5 - offset.abs() / change).clamp(0.0, 1.0)
    }

    fn shade(&self, index: usize, range: f64, spacing: f64) -> Rgb {
        let distance = f64::from(self.distances[index]);
        let coverage = |offset: f64, half_width: f64| self.coverage(index, offset, half_width, range);
        let to_isoline = distance - (distance / spacing).round() * spacing;
        let ground = colour::of_distance(distance, range);
        let lined = colour::mix(ground, colour::ISOLINE, 0.6 * coverage(to_isoline, 0.5));
        colour::mix(lined, colour::SURFACE, coverage(distance, 1.0))
    }
}

/// A leaf of an octree or a cell of a grid.
#[derive(PartialEq)]
enum Cell {
    Leaf(Leaf),
    Grid([u32; 3]),
}

/// The leaf or cell that holds the point, or the one nearest to it.
fn cell_of(field: &Field<'_>, point: [f32; 3]) -> Cell {
    let low = field.header().bounds.min;
    let place = |edge: [f32; 3]| [0, 1, 2].map(|axis| ((point[axis] - low[axis]) / edge[axis]) as u32);
    if let Some(octree) = field.octree() {
        return Cell::Leaf(octree.leaf_at(place([octree.edge(octree.depth()); 3])));
    }
    if let Some(octree) = field.polynomial_octree() {
        return Cell::Leaf(octree.leaf_at(place([octree.edge(octree.depth()); 3])));
    }
    Cell::Grid(field.grid().map_or([0; 3], |grid| place(grid.spacing())))
}

/// The number of the form 1, 2 or 5 times a power of ten that is next above `least`.
fn round_number(least: f64) -> f64 {
    let power = libm::pow(10.0, libm::log10(least).floor());
    [1.0, 2.0, 5.0, 10.0]
        .map(|factor| factor * power)
        .into_iter()
        .find(|&number| number >= least)
        .unwrap_or(10.0 * power)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn round_numbers() {
        for (least, expected) in [(0.03, 0.05), (0.011, 0.02), (7.0, 10.0), (120.0, 200.0)] {
            assert!((round_number(least) / expected - 1.0).abs() < 1e-12, "{least}");
        }
    }

    #[test]
    fn a_wide_ramp_is_blue_black_and_warm() {
        let distances: Vec<f32> = (-50..=50).map(|step| step as f32 / 50.0).collect();
        let raster = Raster { width: distances.len(), distances };

        let [red, _, blue] = raster.shade(3, 1.0, 0.1);
        assert!(blue > red, "inside");
        assert_eq!(raster.shade(50, 1.0, 0.1), colour::SURFACE, "surface");
        let [red, _, blue] = raster.shade(97, 1.0, 0.1);
        assert!(red > blue, "outside");
    }
}

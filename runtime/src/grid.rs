//! The uniform grid: its parameters, and from a point to its cell.

use crate::bytes::{Words, f32_at, f32x3_at, u8_at, u16x3_at};
use crate::error::Error;
use crate::header::Aabb;
use crate::layout::{grid as at, limit, precision, range, reconstruction, section};
use crate::math::each_axis;
use crate::section as sections;

/// How a grid answers between its samples. A sample of order k is a polynomial of total degree k.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Reconstruction {
    /// The polynomial of the nearest sample.
    Nearest,
    /// The polynomials of the cell's eight samples, weighted trilinearly (Bán and Valasek 2020, §4).
    Linear,
    /// The same with the terms of degree j reduced to (k + 1 − j) / (k + 1) of themselves, which makes
    /// it exact on polynomials of degree k + 1: for first-order samples, half the gradient.
    Half,
    /// The polynomials weighted by smooth steps that keep their derivatives up to the order: cubic,
    /// quintic, septic (Valasek and Bán 2022).
    Blend,
    /// Tricubic or triquintic Ferguson–Hermite interpolation of the derivatives, those that a sample
    /// does not hold being zero (Valasek and Bán 2022). Order 1 and 2.
    Hermite,
}

/// How the samples of a grid are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum GridPrecision {
    /// A first-order sample in 32 bits, 10 + 10 for the unit gradient and 12 for the distance; distances
    /// alone in 16 bits, derivatives above the first as half floats.
    Packed32,
    /// 16 bits a number.
    F16,
    /// 32 bits a number.
    F32,
}

/// The grid of a field: what a query works with.
#[derive(Clone, Copy, Debug)]
pub struct Grid<'a> {
    pub(crate) samples: Words<'a>,
    /// Base distances of the bricks; a single one if they share it.
    pub(crate) bases: Words<'a>,
    /// Samples to the next row along y and to the next layer along z; and bases, if there are several.
    steps: [usize; 2],
    brick_steps: [usize; 2],
    bounds: Aabb,
    resolution: [u32; 3],
    spacing: [f32; 3],
    cells_per_unit: [f32; 3],
    /// Cells along each axis.
    cells: [f32; 3],
    /// By what the slope of a first-order sample along each axis is multiplied, and 0.
    pub(crate) slope_scale: [f32; 4],
    pub(crate) quantum: f32,
    order: u8,
    reconstruction: Reconstruction,
    pub(crate) precision: GridPrecision,
    has_bricks: bool,
}

impl<'a> Grid<'a> {
    /// The grid of a file whose header has been checked (SPEC.md §11).
    pub(crate) fn open(bytes: &'a [u8], bounds: Aabb) -> Result<Self, Error> {
        let parameter_section = sections::find(bytes, section::GRID)?;
        let parameters = sections::find_bytes(bytes, section::GRID)?;
        let samples = Words::new(sections::find_bytes(bytes, section::SAMPLES)?);

        if parameters.len() != at::LENGTH {
            return Err(Error::GridLength);
        }
        sections::check_sum(bytes, &parameter_section)?;
        if parameters.get(at::RESERVED) != Some(&[0, 0]) {
            return Err(Error::Reserved);
        }

        let order = u8_at(parameters, at::ORDER);
        let reconstruction = reconstruction_of(u8_at(parameters, at::RECONSTRUCTION), order)?;
        let precision = match u8_at(parameters, at::PRECISION).into() {
            precision::PACKED32 => GridPrecision::Packed32,
            precision::F16 => GridPrecision::F16,
            precision::F32 => GridPrecision::F32,
            _ => return Err(Error::GridPrecision),
        };
        let has_bricks = match (u8_at(parameters, at::RANGE), precision) {
            (range::FILE, _) => false,
            (range::BRICK, GridPrecision::Packed32 | GridPrecision::F16) => true,
            _ => return Err(Error::GridPrecision),
        };

        let spacing = f32x3_at(parameters, at::SPACING);
        let quantum = f32_at(parameters, at::QUANTUM);
        let greatest = spacing.into_iter().fold(0.0, f32::max);
        let least = spacing.into_iter().fold(f32::INFINITY, f32::min);
        if !spacing.iter().all(|spacing| (limit::MIN_ROOT_EDGE..=limit::MAX_MAGNITUDE).contains(spacing))
            || greatest > at::MAX_ANISOTROPY * least
            || !(limit::MIN_QUANTUM..=limit::MAX_MAGNITUDE).contains(&quantum)
        {
            return Err(Error::GridScale);
        }

        let resolution = u16x3_at(parameters, at::RESOLUTION);
        if resolution.iter().any(|&samples| samples < at::MIN_RESOLUTION) {
            return Err(Error::GridResolution);
        }
        let resolution = resolution.map(u32::from);
        check_bounds(bounds, resolution, spacing)?;

        // A base is missing from a file whose numbers need none.
        let bases = if precision == GridPrecision::F32 {
            Words::new(&[])
        } else {
            Words::new(sections::find_bytes(bytes, section::BASES)?)
        };
        let share = if reconstruction == Reconstruction::Half { 0.5 } else { 1.0 };
        let [x, y, z] = spacing.map(|spacing| share * spacing);
        let steps = |[x, y, _]: [u32; 3]| [x as usize, x as usize * y as usize];
        let grid = Self {
            samples,
            bases,
            steps: steps(resolution),
            brick_steps: steps(bricks(resolution)),
            bounds,
            resolution,
            spacing,
            cells_per_unit: spacing.map(|spacing| 1.0 / spacing),
            cells: resolution.map(|samples| (samples - 1) as f32),
            slope_scale: [x, y, z, 0.0],
            quantum,
            order,
            reconstruction,
            precision,
            has_bricks,
        };
        let holds = |words: Words<'_>, count: Option<u64>| count.is_some_and(|count| words.len() as u64 >= count);
        if !holds(samples, grid.sample_words()) || !holds(bases, Some(grid.base_words())) {
            return Err(Error::GridResolution);
        }
        Ok(grid)
    }

    /// Samples along x, y, z; each at least 2.
    pub fn resolution(&self) -> [u32; 3] {
        self.resolution
    }

    /// Distance between samples along x, y, z, mesh units, positive.
    pub fn spacing(&self) -> [f32; 3] {
        self.spacing
    }

    /// Order of the samples: the degree of their polynomials, 0 to 3.
    pub fn order(&self) -> u8 {
        self.order
    }

    /// How the grid answers between its samples.
    pub fn reconstruction(&self) -> Reconstruction {
        self.reconstruction
    }

    /// How the samples are stored.
    pub fn precision(&self) -> GridPrecision {
        self.precision
    }

    /// Step of a stored distance, mesh units; meaningless for [`GridPrecision::F32`].
    pub fn quantum(&self) -> f32 {
        self.quantum
    }

    /// Whether each brick of 4 × 4 × 4 samples has a distance range of its own.
    pub fn has_brick_ranges(&self) -> bool {
        self.has_bricks
    }

    /// The box that the samples span.
    pub fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Value and gradient of one sample: mesh units, and without unit. Samples beyond the last count
    /// as it.
    pub fn sample(&self, at: [u32; 3]) -> (f32, [f32; 3]) {
        let at = each_axis(|axis| at[axis].min(self.resolution[axis] - 1));
        let (value, slopes) = self.polynomial(at).at([0.0; 3], [1.0; 4]);
        (value, self.per_unit(slopes))
    }

    /// The greatest spacing, the unit of length of stored second and third derivatives.
    pub(crate) fn unit(&self) -> f32 {
        self.spacing.into_iter().fold(0.0, f32::max)
    }

    /// Words of all samples; `None` beyond what a file can hold.
    pub(crate) fn sample_words(&self) -> Option<u64> {
        let halves = u64::from(self.halves_per_sample());
        let count: u64 = self.resolution.iter().map(|&samples| u64::from(samples)).product();
        Some(count.checked_mul(halves)?.div_ceil(2))
    }

    /// 16-bit halves of a sample.
    #[inline]
    pub(crate) fn halves_per_sample(&self) -> u32 {
        let numbers = [1, 4, 10, 20][usize::from(self.order & 3)];
        match self.precision {
            GridPrecision::F32 => 2 * numbers,
            GridPrecision::F16 => numbers,
            // Distance and gradient take two halves together.
            GridPrecision::Packed32 => numbers.min(2) + numbers.saturating_sub(4),
        }
    }

    /// Words of all base distances.
    pub(crate) fn base_words(&self) -> u64 {
        match (self.precision, self.has_bricks) {
            (GridPrecision::F32, _) => 0,
            (_, false) => 1,
            (_, true) => bricks(self.resolution).map(u64::from).into_iter().product(),
        }
    }

    /// Base distance of the sample at a vertex, in quanta.
    #[inline(never)]
    pub(crate) fn base(&self, vertex: [u32; 3]) -> i32 {
        let brick = if self.has_bricks { self.bricks_of(vertex).0 } else { 0 };
        self.bases.word(brick).cast_signed()
    }

    /// Number of the brick of a vertex, and the steps to those of the next vertices along x, y and z.
    #[inline]
    pub(crate) fn bricks_of(&self, vertex: [u32; 3]) -> (usize, [usize; 3]) {
        let [row, layer] = self.brick_steps;
        const EDGE: u32 = at::BRICK_EDGE;
        // All bits of a step or none of them: branches would be hard to predict.
        let [x, y, z] = each_axis(|axis| usize::from(vertex[axis] % EDGE == EDGE - 1).wrapping_neg());
        (number(each_axis(|axis| vertex[axis] / EDGE), self.brick_steps), [1 & x, row & y, layer & z])
    }

    /// Number of the sample at a vertex, x fastest, and samples to the next row and layer.
    #[inline]
    pub(crate) fn index(&self, vertex: [u32; 3]) -> (usize, [usize; 2]) {
        (number(vertex, self.steps), self.steps)
    }

    /// The cell that holds a point of the box, by its least vertex, and where in it the point is, 0 to 1.
    #[inline]
    pub(crate) fn locate(&self, point: [f32; 3]) -> ([u32; 3], [f32; 3]) {
        let place =
            |axis: usize| place(point[axis], self.bounds.min[axis], self.cells_per_unit[axis], self.cells[axis]);
        let [(x, u), (y, v), (z, w)] = [place(0), place(1), place(2)];
        ([x, y, z], [u, v, w])
    }

    /// The same of several points: apart and in memory, which makes four-wide code.
    #[inline(never)]
    pub(crate) fn locate_each<const COUNT: usize>(
        &self,
        points: &[[f32; 3]; COUNT],
        cell: &mut [[u32; 3]; COUNT],
        local: &mut [[f32; 3]; COUNT],
    ) {
        let (min, cells_per_unit, cells) =
            ([self.bounds.min; COUNT], [self.cells_per_unit; COUNT], [self.cells; COUNT]);
        let axes = min.as_flattened().iter().zip(cells_per_unit.as_flattened()).zip(cells.as_flattened());
        let places = cell.as_flattened_mut().iter_mut().zip(local.as_flattened_mut());
        for ((&coordinate, ((&min, &per_unit), &cells)), (cell, local)) in
            points.as_flattened().iter().zip(axes).zip(places)
        {
            (*cell, *local) = place(coordinate, min, per_unit, cells);
        }
    }

    /// Derivatives by local coordinates to a gradient.
    #[inline]
    pub(crate) fn per_unit(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let [a, b, c] = self.cells_per_unit;
        [x * a, y * b, z * c]
    }
}

/// Bricks along x, y, z.
fn bricks(resolution: [u32; 3]) -> [u32; 3] {
    resolution.map(|samples| samples.div_ceil(at::BRICK_EDGE))
}

/// Number of a place, x fastest, where the next along y and z are so many steps away.
#[inline]
fn number([x, y, z]: [u32; 3], [row, layer]: [usize; 2]) -> usize {
    x as usize + row * y as usize + layer * z as usize
}

/// Along one axis of that many cells, the cell of a coordinate of the box, and where in it that is, 0 to 1. The coordinate less
/// the least is never a NaN, and neither negative: so one comparison does, and a conversion that saturates is not needed.
#[inline]
fn place(coordinate: f32, min: f32, cells_per_unit: f32, cells: f32) -> (u32, f32) {
    // Adding 2²³ rounds to an integer, and leaves it in the lowest bits.
    const ROUNDING: f32 = (1 << 23) as f32;
    let position = (coordinate - min) * cells_per_unit;
    let position = if position < cells { position } else { cells };
    let nearest = (position + ROUNDING) - ROUNDING;
    let floor = if nearest > position { nearest - 1.0 } else { nearest };
    let last = cells - 1.0;
    let floor = if floor < last { floor } else { last };
    ((floor + ROUNDING).to_bits() & ((1 << 23) - 1), position - floor)
}

/// The reconstruction of a code, if samples of this order can be reconstructed so (SPEC.md §11.1).
fn reconstruction_of(code: u8, order: u8) -> Result<Reconstruction, Error> {
    match (code, order) {
        (reconstruction::NEAREST, 0..=at::MAX_ORDER) => Ok(Reconstruction::Nearest),
        (reconstruction::LINEAR, 0..=at::MAX_ORDER) => Ok(Reconstruction::Linear),
        (reconstruction::HALF, 1..=at::MAX_ORDER) => Ok(Reconstruction::Half),
        (reconstruction::BLEND, 1..=at::MAX_ORDER) => Ok(Reconstruction::Blend),
        (reconstruction::HERMITE, 1..=2) => Ok(Reconstruction::Hermite),
        _ => Err(Error::GridReconstruction),
    }
}

/// Checks that the box is what the samples span (SPEC.md §11.1).
fn check_bounds(bounds: Aabb, resolution: [u32; 3], spacing: [f32; 3]) -> Result<(), Error> {
    for axis in 0..3 {
        let (min, max) = (bounds.min[axis], bounds.max[axis]);
        let extent = (resolution[axis] - 1) as f32 * spacing[axis];
        let largest = extent.max(min.abs()).max(max.abs());
        if (max - (min + extent)).abs() > limit::BOX_TOLERANCE * largest {
            return Err(Error::GridBounds);
        }
    }
    Ok(())
}

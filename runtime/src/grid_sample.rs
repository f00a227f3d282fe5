//! From the words of a grid's samples to polynomials.

use crate::grid::{Grid, GridPrecision};
use crate::hermite::Corners;
use crate::layout::packed_sample;
use crate::math::each_lane;
use crate::polynomial::{AXES, NO_AXIS, Polynomial, TERMS};
use crate::sample::{decode_distance, decode_gradient, decode_half, decode_single};

/// Packed first-order samples at the corners of a cell, as they are in the file.
#[derive(Clone, Copy, Default)]
pub(crate) struct PackedCorners {
    words: [u32; 8],
    bases: [i32; 8],
}

/// First-order samples at the corners of a cell: distances, mesh units, and derivatives by x, y, z, without unit.
pub(crate) struct FirstOrder {
    pub(crate) distance: Corners,
    pub(crate) gradient: [Corners; 3],
}

impl FirstOrder {
    pub(crate) const ZERO: Self = Self { distance: [0.0; 8], gradient: [[0.0; 8]; 3] };
}

/// Decodes packed samples. One plain loop that ends in memory, which compilers turn into vectors where they do not inline it
/// into more than a reader of the samples.
#[inline(always)]
fn decode_packed(words: &[u32; 8], bases: &[i32; 8], quantum: f32, corners: &mut FirstOrder) {
    let [by_x, by_y, by_z] = &mut corners.gradient;
    for corner in 0..8 {
        let word = words[corner];
        corners.distance[corner] = decode_distance(bases[corner], word >> packed_sample::DISTANCE_SHIFT, quantum);
        [by_x[corner], by_y[corner], by_z[corner]] = decode_gradient(word);
    }
}

impl Grid<'_> {
    /// The vertex at corner `4 x + 2 y + z` of a cell.
    #[inline]
    pub(crate) fn corner([x, y, z]: [u32; 3], corner: u32) -> [u32; 3] {
        [x + (corner >> 2 & 1), y + (corner >> 1 & 1), z + (corner & 1)]
    }

    /// The distances at the corners of a cell of a grid of order 0.
    #[inline]
    pub(crate) fn distances(&self, cell: [u32; 3]) -> Corners {
        if self.precision == GridPrecision::F32 {
            return self.corner_words(cell).map(decode_single);
        }
        self.packed_distances(cell)
    }

    /// The same of 16-bit codes.
    #[inline(never)]
    fn packed_distances(&self, cell: [u32; 3]) -> Corners {
        let quanta = self.quanta(cell);
        let mut distances = Corners::default();
        for corner in 0..8 {
            distances[corner] = decode_distance(quanta[corner], 0, self.quantum);
        }
        distances
    }

    /// The same before they are decoded: numbers of quanta, or floats.
    #[inline]
    pub(crate) fn stored_distances(&self, cell: [u32; 3]) -> [u32; 8] {
        if self.precision == GridPrecision::F32 {
            self.corner_words(cell)
        } else {
            self.quanta(cell).map(i32::cast_unsigned)
        }
    }

    /// What [`stored_distances`](Self::stored_distances) of many cells stand for.
    #[inline(never)]
    pub(crate) fn decode_each(&self, stored: &[u32], distances: &mut [f32]) {
        let (is_single, quantum) = (self.precision == GridPrecision::F32, self.quantum);
        for (distance, &stored) in distances.iter_mut().zip(stored) {
            *distance = if is_single { decode_single(stored) } else { decode_distance(0, stored, quantum) };
        }
    }

    /// Distances in quanta, from 16-bit codes.
    #[inline(always)]
    fn quanta(&self, cell: [u32; 3]) -> [i32; 8] {
        let rows = self.rows_of(cell);
        let mut quanta = [0; 8];
        self.read_bases(cell, &mut quanta);
        for edge in 0..4 {
            quanta[edge] = quanta[edge].wrapping_add_unsigned(self.samples.half(rows[edge]));
            quanta[4 + edge] = quanta[4 + edge].wrapping_add_unsigned(self.samples.half(rows[edge] + 1));
        }
        quanta
    }

    /// The distance of a sample of order 0.
    #[inline]
    fn lone_distance(&self, at: [u32; 3]) -> f32 {
        let (index, _) = self.index(at);
        if self.precision == GridPrecision::F32 {
            return decode_single(self.samples.word(index));
        }
        decode_distance(self.base(at), self.samples.half(index), self.quantum)
    }

    /// Writes the samples at the corners of a cell of a grid of order 1. Returned by value they would lie twice on the
    /// stack of a microcontroller.
    #[inline(always)]
    pub(crate) fn read_first_order(&self, cell: [u32; 3], corners: &mut FirstOrder) {
        if self.precision == GridPrecision::Packed32 {
            self.read_packed_first_order(cell, corners);
        } else {
            self.read_wide_first_order(cell, corners);
        }
    }

    #[inline(never)]
    fn read_packed_first_order(&self, cell: [u32; 3], corners: &mut FirstOrder) {
        let mut packed = PackedCorners::default();
        self.read_packed(cell, &mut packed);
        decode_packed(&packed.words, &packed.bases, self.quantum, corners);
    }

    /// The same of samples that were read before.
    #[inline(never)]
    pub(crate) fn decode(&self, PackedCorners { words, bases }: &PackedCorners, corners: &mut FirstOrder) {
        decode_packed(words, bases, self.quantum, corners);
    }

    /// Reads the packed samples at the corners of a cell of a grid of order 1.
    #[inline]
    pub(crate) fn read_packed(&self, cell: [u32; 3], PackedCorners { words, bases }: &mut PackedCorners) {
        *words = self.corner_words(cell);
        self.read_bases(cell, bases);
    }

    /// Reads the base distances of the samples at the corners of a cell, in quanta.
    #[inline(always)]
    fn read_bases(&self, cell: [u32; 3], bases: &mut [i32; 8]) {
        let at = |brick: usize| self.bases.word(brick).cast_signed();
        if !self.has_brick_ranges() {
            *bases = [at(0); 8];
            return;
        }
        let (first, [x, y, z]) = self.bricks_of(cell);
        let (beyond, yz) = (first + x, y + z);
        *bases = [
            at(first),
            at(first + z),
            at(first + y),
            at(first + yz),
            at(beyond),
            at(beyond + z),
            at(beyond + y),
            at(beyond + yz),
        ];
    }

    /// The same of samples of several words.
    #[inline(never)]
    fn read_wide_first_order(&self, cell: [u32; 3], corners: &mut FirstOrder) {
        for corner in 0..8 {
            let mut numbers = [0.0; TERMS];
            self.read_stored(Self::corner(cell, corner), &mut numbers);
            let [distance, x, y, z, ..] = numbers;
            // The mask shows the compiler that no index can fail.
            let corner = corner as usize & 7;
            corners.distance[corner] = distance;
            corners.gradient[0][corner] = x;
            corners.gradient[1][corner] = y;
            corners.gradient[2][corner] = z;
        }
    }

    /// The words at the corners of a cell, of samples of one word each.
    #[inline]
    fn corner_words(&self, cell: [u32; 3]) -> [u32; 8] {
        let rows = self.rows_of(cell);
        let [a, b, c, d] = each_lane(|row| self.samples.word(rows[row]));
        let [e, f, g, h] = each_lane(|row| self.samples.word(rows[row] + 1));
        [a, b, c, d, e, f, g, h]
    }

    /// Numbers of the samples at the corners of a cell that are least along x: neighbours along x are neighbours in the
    /// section.
    #[inline]
    fn rows_of(&self, cell: [u32; 3]) -> [usize; 4] {
        let (first, [row, layer]) = self.index(cell);
        [first, first + layer, first + row, first + layer + row]
    }

    /// The samples at the corners of a cell, of any order.
    pub(crate) fn polynomials(&self, cell: [u32; 3]) -> [Polynomial; 8] {
        [0, 1, 2, 3, 4, 5, 6, 7].map(|corner| self.polynomial(Self::corner(cell, corner)))
    }

    /// A sample of any order by local coordinates (SPEC.md §11.3).
    #[inline(never)]
    pub(crate) fn polynomial(&self, at: [u32; 3]) -> Polynomial {
        let mut numbers = [0.0; TERMS];
        self.read_stored(at, &mut numbers);

        // By the spacing along the first axis, and by those along the others in units of the greatest.
        let [x, y, z] = self.spacing();
        let unit = self.unit();
        let (spacing, ratio) = ([x, y, z, 1.0], [x / unit, y / unit, z / unit, 1.0]);
        for (number, [a, b, c]) in numbers.iter_mut().zip(&AXES) {
            // The masks show the compiler that no index can fail.
            *number *= spacing[a & NO_AXIS] * ratio[b & NO_AXIS] * ratio[c & NO_AXIS];
        }
        Polynomial(numbers)
    }

    /// The coefficients of a sample of any order as they are stored; those that it does not have are left alone.
    #[inline(never)]
    fn read_stored(&self, at: [u32; 3], numbers: &mut [f32; TERMS]) {
        let (index, _) = self.index(at);
        let count = match self.order() {
            0 => {
                numbers[0] = self.lone_distance(at);
                return;
            }
            1 => 4,
            2 => 10,
            _ => TERMS,
        };

        let data = self.samples.tail(index * (self.halves_per_sample() / 2) as usize);
        let is_packed = self.precision == GridPrecision::Packed32;
        for (place, number) in numbers.iter_mut().enumerate().take(count) {
            *number = if self.precision == GridPrecision::F32 {
                decode_single(data.word(place))
            } else {
                // Four packed numbers take two halves.
                let half = if is_packed { place.saturating_sub(2) } else { place };
                decode_half(data.half(half) as u16)
            };
        }
        if self.precision != GridPrecision::F32 {
            let word = data.word(0);
            let code = if is_packed { word >> packed_sample::DISTANCE_SHIFT } else { word & 0xFFFF };
            numbers[0] = decode_distance(self.base(at), code, self.quantum);
            if is_packed {
                [numbers[1], numbers[2], numbers[3]] = decode_gradient(word);
            }
        }
    }
}

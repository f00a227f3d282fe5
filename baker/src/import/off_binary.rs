//! Object File Format, binary: `OFF BINARY` and a line end, then 32-bit words.
//!
//! Geomview writes the highest byte first and colours after each face; others write either as they like, and nothing in
//! the file says so. The reading that uses the words up, with indices in range, is the right one.

use super::{Problem, TriangleSoup, push_fan};
use glam::DVec3;

/// What a file can leave unsaid.
#[derive(Clone, Copy)]
struct Reading {
    is_big_endian: bool,
    has_colours: bool,
}

/// Reads what follows the first line. A vertex has so many words, the first three of which are its position.
pub(super) fn parse(bytes: &[u8], words_per_vertex: usize) -> Result<TriangleSoup, Problem> {
    let readings = [(true, true), (true, false), (false, false), (false, true)]
        .map(|(is_big_endian, has_colours)| Reading { is_big_endian, has_colours });
    let soup = readings.into_iter().find_map(|reading| Words { rest: bytes, reading }.soup(words_per_vertex));
    let soup =
        soup.ok_or_else(|| Problem::Truncated { reason: "its binary words do not add up to its counts".into() })?;
    if soup.triangles.is_empty() {
        return Err(Problem::NoTriangles { hint: "" });
    }
    match soup.positions.iter().position(|position| !position.is_finite()) {
        Some(vertex) => Err(Problem::NotFinite { place: format!("vertex {vertex}"), position: soup.positions[vertex] }),
        None => Ok(soup),
    }
}

struct Words<'a> {
    rest: &'a [u8],
    reading: Reading,
}

impl Words<'_> {
    fn next(&mut self) -> Option<u32> {
        let (word, rest) = self.rest.split_first_chunk::<4>()?;
        self.rest = rest;
        Some(if self.reading.is_big_endian { u32::from_be_bytes(*word) } else { u32::from_le_bytes(*word) })
    }

    fn skip(&mut self, words: usize) -> Option<()> {
        self.rest = self.rest.get(words.checked_mul(4)?..)?;
        Some(())
    }

    fn coordinate(&mut self) -> Option<f64> {
        self.next().map(|bits| f32::from_bits(bits).into())
    }

    /// All of it, if this reading is right. Space is taken as words come, never on the word of the counts.
    fn soup(mut self, words_per_vertex: usize) -> Option<TriangleSoup> {
        let (vertices, faces, _edges) = (self.next()?, self.next()?, self.next()?);
        let mut soup = TriangleSoup::default();
        for _ in 0..vertices {
            soup.positions.push(DVec3::new(self.coordinate()?, self.coordinate()?, self.coordinate()?));
            self.skip(words_per_vertex - 3)?;
        }
        let mut polygon = Vec::new();
        for _ in 0..faces {
            polygon.clear();
            for _ in 0..self.next()? {
                polygon.push(self.next().filter(|&vertex| vertex < vertices)?);
            }
            push_fan(&mut soup.triangles, &polygon);
            if self.reading.has_colours {
                let components = self.next()?;
                self.skip(components as usize)?;
            }
        }
        self.rest.is_empty().then_some(soup)
    }
}

//! STL, binary and ASCII.
//!
//! A binary file may start with `solid` too, so its length decides: 84 bytes and 50 a triangle.
//! Normals, names and attribute bytes are not looked at: exporters fill them with anything.

use super::{Problem, TriangleSoup, push_fan};
use glam::DVec3;

const HEADER: usize = 80;
const RECORD: usize = 50;

pub(super) fn is_stl(bytes: &[u8]) -> bool {
    binary_length(bytes) == Some(bytes.len()) || is_ascii(bytes)
}

pub(super) fn parse(bytes: &[u8]) -> Result<TriangleSoup, Problem> {
    match binary_length(bytes) {
        Some(length) if length == bytes.len() || !is_ascii(bytes) => parse_binary(bytes, length),
        None if !is_ascii(bytes) => {
            let reason = format!("a header has {} bytes, but the file has {}", HEADER + 4, bytes.len());
            Err(Problem::Truncated { reason })
        }
        _ => parse_ascii(bytes),
    }
}

/// The length that the count of a binary file announces.
fn binary_length(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(HEADER..)?.first_chunk()?;
    (u32::from_le_bytes(*count) as usize).checked_mul(RECORD)?.checked_add(HEADER + 4)
}

/// A file that starts with `solid` and soon goes on with a facet, or ends.
fn is_ascii(bytes: &[u8]) -> bool {
    const SOON: usize = 1024;
    let bytes = bytes.trim_ascii_start();
    let (Some(word), Some(head)) = (bytes.get(..5), bytes.get(5..bytes.len().min(SOON))) else { return false };
    let mut words = head.split(u8::is_ascii_whitespace);
    word.eq_ignore_ascii_case(b"solid")
        && head.first().is_none_or(u8::is_ascii_whitespace)
        && words.any(|word| word.eq_ignore_ascii_case(b"facet") || word.eq_ignore_ascii_case(b"endsolid"))
}

fn parse_binary(bytes: &[u8], length: usize) -> Result<TriangleSoup, Problem> {
    if bytes.len() < length {
        let reason = format!("its count announces {length} bytes, but there are {}", bytes.len());
        return Err(Problem::Truncated { reason });
    }
    let mut soup = TriangleSoup::default();
    for (number, record) in bytes[HEADER + 4..length].chunks_exact(RECORD).enumerate() {
        // The normal comes first, two attribute bytes last.
        let (numbers, _) = record[12..48].as_chunks::<4>();
        let corners = numbers.chunks_exact(3).map(|xyz| {
            let coordinate = |axis: usize| f64::from(f32::from_le_bytes(xyz[axis]));
            DVec3::new(coordinate(0), coordinate(1), coordinate(2))
        });
        push_polygon(&mut soup, corners, || format!("a corner of triangle {number}"))?;
    }
    check_some(soup)
}

fn parse_ascii(bytes: &[u8]) -> Result<TriangleSoup, Problem> {
    let mut soup = TriangleSoup::default();
    let mut polygon = Vec::new();
    let (mut is_open, mut ends) = (false, false);
    // Old Macintosh files end lines with a carriage return alone.
    let lines = bytes.split(|&byte| byte == b'\n' || byte == b'\r').map(<[u8]>::trim_ascii);
    for line in lines.filter(|line| !line.is_empty()) {
        let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        let keyword = words.next().unwrap_or_default().to_ascii_lowercase();
        let place = || format!("triangle {}", soup.triangles.len());
        match &keyword[..] {
            b"outer" => (is_open, ends) = (true, false),
            b"vertex" if is_open => {
                polygon.push(vertex(words).ok_or_else(|| malformed(&place(), "a vertex is not three numbers"))?)
            }
            b"endloop" if is_open => {
                if polygon.len() < 3 {
                    return Err(malformed(&place(), "a loop has fewer than three vertices"));
                }
                is_open = false;
                let place = place();
                push_polygon(&mut soup, polygon.drain(..), || format!("a corner of {place}"))?;
            }
            b"facet" | b"endfacet" | b"solid" if !is_open => {}
            b"endsolid" if !is_open => ends = true,
            word => {
                let word = String::from_utf8_lossy(word).chars().take(20).collect::<String>();
                return Err(malformed(&place(), &format!("{word:?} is out of place")));
            }
        }
    }
    if !ends {
        let reason = format!("it ends in triangle {}, without endsolid", soup.triangles.len());
        return Err(Problem::Truncated { reason });
    }
    check_some(soup)
}

fn vertex<'a>(words: impl Iterator<Item = &'a [u8]>) -> Option<DVec3> {
    let mut numbers = words.map(|word| std::str::from_utf8(word).ok()?.parse().ok());
    let xyz = [numbers.next()??, numbers.next()??, numbers.next()??];
    numbers.next().is_none().then_some(DVec3::from_array(xyz))
}

/// Adds a polygon with corners of its own: welding comes later, for all formats.
fn push_polygon(
    soup: &mut TriangleSoup,
    corners: impl Iterator<Item = DVec3>,
    place: impl Fn() -> String,
) -> Result<(), Problem> {
    let first = soup.positions.len() as u32;
    for position in corners {
        if !position.is_finite() {
            return Err(Problem::NotFinite { place: place(), position });
        }
        soup.positions.push(position);
    }
    let polygon: Vec<u32> = (first..soup.positions.len() as u32).collect();
    push_fan(&mut soup.triangles, &polygon);
    Ok(())
}

fn check_some(soup: TriangleSoup) -> Result<TriangleSoup, Problem> {
    if soup.triangles.is_empty() { Err(Problem::NoTriangles { hint: "" }) } else { Ok(soup) }
}

fn malformed(place: &str, reason: &str) -> Problem {
    Problem::Malformed { format: "STL", reason: format!("{place}: {reason}") }
}

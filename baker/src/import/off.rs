//! Object File Format: `OFF` with any of the prefixes that add colours, normals or texture
//! coordinates to three-dimensional vertices. ASCII here, binary in [`off_binary`].

use super::off_binary;
use super::{Problem, TriangleSoup, push_fan};
use glam::DVec3;
use std::str::FromStr;

pub(super) fn is_off(bytes: &[u8]) -> bool {
    Lines::new(bytes).next().is_some_and(|line| split_keyword(line.text).is_some())
}

pub(super) fn parse(bytes: &[u8]) -> Result<TriangleSoup, Problem> {
    let mut lines = Lines::new(bytes);
    let first = lines.next().ok_or(Problem::NoTriangles { hint: "" })?;
    let Some((keyword, rest)) = split_keyword(first.text) else {
        return Err(malformed(first.number, "it does not start with OFF"));
    };
    let remedy = "export it as plain OFF";
    if keyword.contains(&b'4') || keyword.contains(&b'n') {
        return Err(Problem::Unsupported { feature: "has vertices of more dimensions".into(), remedy });
    }
    if rest.trim_ascii().starts_with(b"BINARY") {
        let start = bytes.iter().position(|&byte| byte == b'\n').map_or(bytes.len(), |end| end + 1);
        let words = [(&b"N"[..], 3), (b"C", 4), (b"ST", 2)]
            .map(|(prefix, words)| if keyword.windows(prefix.len()).any(|part| part == prefix) { words } else { 0 });
        return off_binary::parse(&bytes[start..], 3 + words.iter().sum::<usize>());
    }

    // The counts: on the first line or the second; the count of edges is never right.
    let counts = if rest.trim_ascii().is_empty() { lines.next() } else { Some(Line { text: rest, ..first }) };
    let counts = counts.ok_or_else(|| truncated("its counts"))?;
    let mut numbers = counts.words();
    let (Some(vertices), Some(faces)) = (number::<usize>(numbers.next()), number::<usize>(numbers.next())) else {
        return Err(malformed(counts.number, "it should have the numbers of vertices and faces"));
    };

    // Space is taken as lines come, never on the word of the counts.
    let mut soup = TriangleSoup::default();
    for vertex in 0..vertices {
        let line = lines.next().ok_or_else(|| truncated(&format!("vertex {vertex} of {vertices}")))?;
        let mut numbers = line.words();
        let mut coordinate = || {
            number::<f64>(numbers.next())
                .ok_or_else(|| malformed(line.number, "a vertex should have three coordinates"))
        };
        let position = DVec3::new(coordinate()?, coordinate()?, coordinate()?);
        if !position.is_finite() {
            return Err(Problem::NotFinite { place: format!("the vertex on line {}", line.number), position });
        }
        soup.positions.push(position);
    }
    let mut polygon = Vec::new();
    for face in 0..faces {
        let line = lines.next().ok_or_else(|| truncated(&format!("face {face} of {faces}")))?;
        let mut numbers = line.words();
        let corners: usize = number(numbers.next()).ok_or_else(|| malformed(line.number, "a face has no count"))?;
        polygon.clear();
        for _ in 0..corners {
            let index: i64 = number(numbers.next())
                .ok_or_else(|| malformed(line.number, &format!("a face should have {corners} vertex indices")))?;
            match u32::try_from(index) {
                Ok(vertex) if (vertex as usize) < vertices => polygon.push(vertex),
                _ => {
                    let place = format!("line {}", line.number);
                    return Err(Problem::IndexOutOfRange { place, index, vertices });
                }
            }
        }
        push_fan(&mut soup.triangles, &polygon);
    }
    if soup.triangles.is_empty() {
        return Err(Problem::NoTriangles { hint: "" });
    }
    Ok(soup)
}

/// A line without its comment.
#[derive(Clone, Copy)]
struct Line<'a> {
    text: &'a [u8],
    /// Counted from one.
    number: usize,
}

impl<'a> Line<'a> {
    fn words(&self) -> impl Iterator<Item = &'a [u8]> {
        self.text.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty())
    }
}

/// The lines that say something.
struct Lines<'a> {
    rest: &'a [u8],
    number: usize,
}

impl<'a> Lines<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        Self { rest: bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes), number: 0 }
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        while !self.rest.is_empty() {
            let end = self.rest.iter().position(|&byte| byte == b'\n').map_or(self.rest.len(), |end| end + 1);
            let (line, rest) = self.rest.split_at(end);
            self.rest = rest;
            self.number += 1;
            let text = line.split(|&byte| byte == b'#').next().unwrap_or_default().trim_ascii();
            if !text.is_empty() {
                return Some(Line { text, number: self.number });
            }
        }
        None
    }
}

/// The keyword of a first line and what follows it.
fn split_keyword(line: &[u8]) -> Option<(&[u8], &[u8])> {
    let end = line.iter().position(u8::is_ascii_whitespace).unwrap_or(line.len());
    let (keyword, rest) = line.split_at(end);
    let mut prefix = keyword.strip_suffix(b"OFF")?;
    for part in [&b"ST"[..], b"C", b"N", b"4", b"n"] {
        prefix = prefix.strip_prefix(part).unwrap_or(prefix);
    }
    prefix.is_empty().then_some((keyword, rest))
}

fn number<T: FromStr>(word: Option<&[u8]>) -> Option<T> {
    std::str::from_utf8(word?).ok()?.parse().ok()
}

fn malformed(line: usize, reason: &str) -> Problem {
    Problem::Malformed { format: "OFF", reason: format!("line {line}: {reason}") }
}

fn truncated(missing: &str) -> Problem {
    Problem::Truncated { reason: format!("{missing} is missing") }
}

//! Wavefront OBJ, parsed by `tobj`.
//!
//! Only positions and faces matter here, so `tobj` is shown nothing else: neither the names of
//! materials and groups, in whatever encoding, nor faulty texture coordinates can spoil a mesh. Faces
//! whose names are not wanted are left out on the way.

use super::options::NamesMet;
use super::{Problem, Selection, TriangleSoup};
use glam::DVec3;
use std::io::{self, BufRead, Read};
use tobj::LoadError;

/// Statements with which a file may start so that it passes for an OBJ without the extension.
const KEYWORDS: [&[u8]; 12] = [b"v", b"vt", b"vn", b"vp", b"f", b"o", b"g", b"s", b"l", b"p", b"mtllib", b"usemtl"];

pub(super) fn looks_like_obj(bytes: &[u8]) -> bool {
    let mut statements = Statements::new(bytes);
    statements.next_statement().is_some_and(|statement| {
        statement.split(u8::is_ascii_whitespace).next().is_some_and(|word| KEYWORDS.contains(&word))
    })
}

pub(super) fn parse(bytes: &[u8], selection: &Selection) -> Result<TriangleSoup, Problem> {
    let mut text = GeometryText::new(bytes, selection);
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    let loaded = tobj::load_obj_buf(&mut text, &options, |_| Err(LoadError::OpenFileFailed));
    let (models, _) = loaded.map_err(|error| match error {
        LoadError::FaceVertexOutOfBounds => index_out_of_range(bytes),
        _ => Problem::Malformed { format: "OBJ", reason: format!("line {}: {error}", text.statements.line) },
    })?;

    // Without names there is one model; `tobj` keeps the vertices that faces use.
    let mut soup = TriangleSoup::default();
    for tobj::Model { mesh, .. } in models {
        let base = soup.positions.len() as u32;
        soup.positions.extend(mesh.positions.chunks_exact(3).map(DVec3::from_slice));
        let corners = mesh.indices.chunks_exact(3);
        soup.triangles.extend(corners.map(|corner| [0, 1, 2].map(|k| base + corner[k])));
    }
    if soup.triangles.is_empty() {
        let nothing = selection.is_everything();
        return Err(if nothing { Problem::NoTriangles { hint: "" } } else { text.part.met.nothing_selected() });
    }
    match soup.positions.iter().find(|position| !position.is_finite()) {
        Some(&position) => Err(Problem::NotFinite { place: "a vertex that a face uses".into(), position }),
        None => Ok(soup),
    }
}

/// Finds the face behind an error that `tobj` reports without its place.
fn index_out_of_range(bytes: &[u8]) -> Problem {
    let mut statements = Statements::new(bytes);
    let vertices = Statements::new(bytes).count_vertices();
    let mut vertices_so_far = 0;
    while let Some(statement) = statements.next_statement() {
        let text = String::from_utf8_lossy(statement);
        let mut words = text.split_ascii_whitespace();
        match words.next() {
            Some("v") => vertices_so_far += 1,
            Some("f") => {
                // A negative index counts back from the vertices so far.
                let in_range =
                    |index: i64| (1..=vertices as i64).contains(&index) || (-vertices_so_far..0).contains(&index);
                let indices = words.filter_map(|word| word.split('/').next()?.parse::<i64>().ok());
                if let Some(index) = indices.into_iter().find(|&index| !in_range(index)) {
                    return Problem::IndexOutOfRange { place: format!("line {}", statements.line), index, vertices };
                }
            }
            _ => {}
        }
    }
    Problem::Malformed { format: "OBJ", reason: LoadError::FaceVertexOutOfBounds.to_string() }
}

/// Statements of the file: comments cut off, lines that a backslash continues joined, none blank.
struct Statements<'a> {
    rest: &'a [u8],
    /// Last line read, counted from one.
    line: usize,
    joined: Vec<u8>,
}

impl<'a> Statements<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        let rest = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        Self { rest, line: 0, joined: Vec::new() }
    }

    fn next_statement(&mut self) -> Option<&[u8]> {
        self.joined.clear();
        while !self.rest.is_empty() {
            let end = self.rest.iter().position(|&byte| byte == b'\n');
            let (line, rest) = self.rest.split_at(end.map_or(self.rest.len(), |end| end + 1));
            self.rest = rest;
            self.line += 1;

            let line = line.split(|&byte| byte == b'#').next().unwrap_or_default().trim_ascii();
            let continued = line.strip_suffix(b"\\");
            self.joined.extend_from_slice(continued.unwrap_or(line));
            if continued.is_some() {
                self.joined.push(b' ');
            } else if !self.joined.trim_ascii().is_empty() {
                break;
            }
        }
        let statement = self.joined.trim_ascii();
        (!statement.is_empty()).then_some(statement)
    }

    fn count_vertices(mut self) -> usize {
        let mut count = 0;
        while let Some(statement) = self.next_statement() {
            count += usize::from(is_statement(statement, b'v'));
        }
        count
    }
}

fn is_statement(statement: &[u8], keyword: u8) -> bool {
    statement[0] == keyword && statement.get(1).is_none_or(u8::is_ascii_whitespace)
}

/// Cuts a vertex to its position, unless a single weight follows: `tobj` wants a colour at every
/// vertex or at none.
fn without_colour(vertex: &[u8]) -> &[u8] {
    let is_gap = |k: &usize| vertex[*k].is_ascii_whitespace() && !vertex[k - 1].is_ascii_whitespace();
    let mut gaps = (1..vertex.len()).filter(is_gap).skip(3);
    match (gaps.next(), gaps.next()) {
        (Some(end_of_position), Some(_)) => &vertex[..end_of_position],
        _ => vertex,
    }
}

/// The part of the file that the statements have come to.
#[derive(Default)]
struct Part {
    /// The object, then the groups: each whole and, as groups may be several, word by word.
    object: Vec<String>,
    groups: Vec<String>,
    material: Option<String>,
    met: NamesMet,
}

impl Part {
    /// Takes in a statement that names something.
    fn enter(&mut self, statement: &[u8]) {
        let text = String::from_utf8_lossy(statement);
        let Some((keyword, name)) = text.split_once(|c: char| c.is_ascii_whitespace()) else { return };
        let name = name.trim_ascii();
        let words = name.split_ascii_whitespace().filter(|&word| word != name);
        match keyword {
            "o" => self.object = vec![name.to_owned()],
            "g" => self.groups = [name].into_iter().chain(words).map(str::to_owned).collect(),
            "usemtl" => {
                self.met.materials.insert(name.to_owned());
                self.material = Some(name.to_owned());
                return;
            }
            _ => return,
        }
        self.met.nodes.insert(name.to_owned());
    }

    fn is_wanted(&self, selection: &Selection) -> bool {
        selection.takes(self.object.iter().chain(&self.groups).map(String::as_str), self.material.as_deref())
    }
}

/// The file as `tobj` sees it: one line a vertex or a face, and nothing else.
struct GeometryText<'a> {
    statements: Statements<'a>,
    /// None if every face is wanted.
    selection: Option<&'a Selection>,
    part: Part,
    pending: Vec<u8>,
    consumed: usize,
}

impl<'a> GeometryText<'a> {
    fn new(bytes: &'a [u8], selection: &'a Selection) -> Self {
        let selection = Some(selection).filter(|selection| !selection.is_everything());
        let statements = Statements::new(bytes);
        Self { statements, selection, part: Part::default(), pending: Vec::new(), consumed: 0 }
    }
}

impl BufRead for GeometryText<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.consumed == self.pending.len() {
            self.pending.clear();
            self.consumed = 0;
            while let Some(statement) = self.statements.next_statement() {
                if is_statement(statement, b'v') {
                    self.pending.extend_from_slice(without_colour(statement));
                } else if is_statement(statement, b'f') {
                    if self.selection.is_some_and(|selection| !self.part.is_wanted(selection)) {
                        continue;
                    }
                    self.pending.extend_from_slice(statement);
                } else {
                    if self.selection.is_some() {
                        self.part.enter(statement);
                    }
                    continue;
                }
                self.pending.push(b'\n');
                break;
            }
        }
        Ok(&self.pending[self.consumed..])
    }

    fn consume(&mut self, amount: usize) {
        self.consumed += amount;
    }
}

impl Read for GeometryText<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.fill_buf()?.read(buffer)?;
        self.consume(count);
        Ok(count)
    }
}

//! Stanford PLY, ASCII and binary of both byte orders, polygons and triangle strips, parsed by `ply-rs-bw`.

use super::{Problem, TriangleSoup, push_fan, push_strip};
use glam::DVec3;
use ply_rs_bw::parser::{ParseError, Parser, Reader};
use ply_rs_bw::ply::{
    ElementDef, Encoding, Header, Property, PropertyAccess, PropertyAccessResult, PropertyType, ScalarType,
};
use std::io::{BufRead, ErrorKind};

pub(super) fn is_ply(bytes: &[u8]) -> bool {
    bytes.starts_with(b"ply") && bytes.get(3).is_some_and(u8::is_ascii_whitespace)
}

pub(super) fn parse(bytes: &[u8]) -> Result<TriangleSoup, Problem> {
    let parser = Parser::<Record>::new();
    let mut reader = Reader::new(bytes);
    let header = parser.read_header(&mut reader).map_err(problem)?;
    check_counts(&header, reader.get_ref().len())?;

    let mut soup = TriangleSoup::default();
    for element in header.elements.values() {
        for number in 0..element.count {
            let record = read_record(&parser, &mut reader, &header, element)
                .map_err(|error| at_record(error, element, number))?;
            match element.name.as_str() {
                "vertex" => soup.positions.push(record.position(number)?),
                "face" => record.push_face(&mut soup, number)?,
                "tristrips" => record.push_strips(&mut soup, number)?,
                _ => {}
            }
        }
    }
    check_indices(&soup)?;
    if soup.triangles.is_empty() {
        return Err(Problem::NoTriangles { hint: "" });
    }
    Ok(soup)
}

/// Compares the counts of the header with the bytes that follow, so that a header cannot claim
/// more than its file could hold.
fn check_counts(header: &Header, payload: usize) -> Result<(), Problem> {
    let mut needed = 0u128;
    for element in header.elements.values() {
        let size: usize = match header.encoding {
            // A digit and a separator each.
            Encoding::Ascii => 2 * element.properties.len(),
            _ => element.properties.values().map(|property| least_bytes(&property.data_type)).sum(),
        };
        if size == 0 && element.count > 0 {
            let reason = format!("element \"{}\" has no properties", element.name);
            return Err(Problem::Malformed { format: "PLY", reason });
        }
        needed += size as u128 * element.count as u128;
    }
    // The last separator of a text may be missing.
    if needed > payload as u128 + 1 {
        let reason = format!("its header announces at least {needed} bytes, but {payload} follow");
        return Err(Problem::Truncated { reason });
    }
    Ok(())
}

fn least_bytes(property: &PropertyType) -> usize {
    let (PropertyType::Scalar(scalar) | PropertyType::List(scalar, _)) = property;
    match scalar {
        ScalarType::Char | ScalarType::UChar => 1,
        ScalarType::Short | ScalarType::UShort => 2,
        ScalarType::Int | ScalarType::UInt | ScalarType::Float => 4,
        ScalarType::Double => 8,
    }
}

fn read_record(
    parser: &Parser<Record>,
    reader: &mut Reader<&[u8]>,
    header: &Header,
    element: &ElementDef,
) -> Result<Record, ParseError> {
    match header.encoding {
        Encoding::BinaryLittleEndian => parser.read_little_endian_element(reader.get_mut(), element),
        Encoding::BinaryBigEndian => parser.read_big_endian_element(reader.get_mut(), element),
        Encoding::Ascii => {
            let mut line = String::new();
            while line.trim_ascii().is_empty() {
                line.clear();
                if reader.get_mut().read_line(&mut line)? == 0 {
                    return Err(std::io::Error::from(ErrorKind::UnexpectedEof).into());
                }
            }
            parser.read_ascii_element(&line, element)
        }
    }
}

fn problem(error: ParseError) -> Problem {
    // The parser's reasons run over several lines.
    let reason = error.to_string().split_whitespace().collect::<Vec<_>>().join(" ");
    match error.kind() {
        ErrorKind::UnexpectedEof => Problem::Truncated { reason },
        _ => Problem::Malformed { format: "PLY", reason },
    }
}

fn at_record(error: ParseError, element: &ElementDef, number: usize) -> Problem {
    let ElementDef { name, count, .. } = element;
    match problem(error) {
        Problem::Truncated { .. } => Problem::Truncated { reason: format!("it ends in {name} {number} of {count}") },
        Problem::Malformed { format, reason } => {
            Problem::Malformed { format, reason: format!("{name} {number}: {reason}") }
        }
        other => other,
    }
}

fn check_indices(soup: &TriangleSoup) -> Result<(), Problem> {
    let vertices = soup.positions.len();
    match soup.triangles.iter().flatten().find(|&&index| index as usize >= vertices) {
        Some(&index) => Err(Problem::IndexOutOfRange { place: "a face".into(), index: index.into(), vertices }),
        None => Ok(()),
    }
}

/// One element of the payload: what a vertex or a face says about the surface.
struct Record {
    xyz: [Option<f64>; 3],
    polygon: Option<Vec<i64>>,
}

impl Record {
    fn position(&self, number: usize) -> Result<DVec3, Problem> {
        let [Some(x), Some(y), Some(z)] = self.xyz else {
            return Err(Problem::Malformed { format: "PLY", reason: "vertices have no x, y and z".into() });
        };
        let position = DVec3::new(x, y, z);
        if position.is_finite() {
            Ok(position)
        } else {
            Err(Problem::NotFinite { place: format!("vertex {number}"), position })
        }
    }

    fn push_face(&self, soup: &mut TriangleSoup, number: usize) -> Result<(), Problem> {
        let polygon = vertices(self.list("face")?, "face", number, soup.positions.len())?;
        push_fan(&mut soup.triangles, &polygon);
        Ok(())
    }

    /// A list of strips: −1 ends one and begins the next, wound anew.
    fn push_strips(&self, soup: &mut TriangleSoup, number: usize) -> Result<(), Problem> {
        let strips = self.list("tristrips")?.split(|&index| index == -1);
        for strip in strips {
            let strip = vertices(strip, "tristrips", number, soup.positions.len())?;
            push_strip(&mut soup.triangles, &strip);
        }
        Ok(())
    }

    fn list(&self, element: &str) -> Result<&[i64], Problem> {
        self.polygon.as_deref().ok_or_else(|| {
            let reason = format!("element \"{element}\" has no list vertex_indices");
            Problem::Malformed { format: "PLY", reason }
        })
    }
}

/// Indices as vertices. That they are in range is checked at the end: vertices may come later.
fn vertices(indices: &[i64], element: &str, number: usize, vertices: usize) -> Result<Vec<u32>, Problem> {
    let vertex = |&index: &i64| {
        let place = || format!("{element} {number}");
        u32::try_from(index).map_err(|_| Problem::IndexOutOfRange { place: place(), index, vertices })
    };
    indices.iter().map(vertex).collect()
}

impl PropertyAccess for Record {
    fn new() -> Self {
        Self { xyz: [None; 3], polygon: None }
    }

    fn set_property(&mut self, name: &str, value: Property) -> PropertyAccessResult {
        let known = match name {
            "x" => scalar(&value).map(|x| self.xyz[0] = Some(x)),
            "y" => scalar(&value).map(|y| self.xyz[1] = Some(y)),
            "z" => scalar(&value).map(|z| self.xyz[2] = Some(z)),
            "vertex_indices" | "vertex_index" => indices(value).map(|list| self.polygon = Some(list)),
            _ => return PropertyAccessResult::Ignored,
        };
        known.map_or(PropertyAccessResult::UnsupportedType, |()| PropertyAccessResult::Set)
    }
}

fn scalar(value: &Property) -> Option<f64> {
    match *value {
        Property::Char(v) => Some(v.into()),
        Property::UChar(v) => Some(v.into()),
        Property::Short(v) => Some(v.into()),
        Property::UShort(v) => Some(v.into()),
        Property::Int(v) => Some(v.into()),
        Property::UInt(v) => Some(v.into()),
        Property::Float(v) => Some(v.into()),
        Property::Double(v) => Some(v),
        _ => None,
    }
}

fn indices(value: Property) -> Option<Vec<i64>> {
    fn widen<T: Into<i64>>(list: Vec<T>) -> Option<Vec<i64>> {
        Some(list.into_iter().map(Into::into).collect())
    }
    match value {
        Property::ListChar(list) => widen(list),
        Property::ListUChar(list) => widen(list),
        Property::ListShort(list) => widen(list),
        Property::ListUShort(list) => widen(list),
        Property::ListInt(list) => widen(list),
        Property::ListUInt(list) => widen(list),
        _ => None,
    }
}

//! Numbers out of buffers (glTF 2.0 specification, section 3.6.2).

use super::buffers::Buffers;
use super::document::{Accessor, Document, Sparse};
use super::{Problem, malformed};
use glam::DVec3;

/// How a number is stored.
#[derive(Clone, Copy, PartialEq)]
enum Component {
    I8,
    U8,
    I16,
    U16,
    U32,
    F32,
}

impl Component {
    fn of_code(code: u32) -> Result<Self, Problem> {
        match code {
            5120 => Ok(Self::I8),
            5121 => Ok(Self::U8),
            5122 => Ok(Self::I16),
            5123 => Ok(Self::U16),
            5125 => Ok(Self::U32),
            5126 => Ok(Self::F32),
            _ => Err(malformed(format!("component type {code} is unknown"))),
        }
    }

    fn bytes(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::U32 | Self::F32 => 4,
        }
    }

    /// The number at the start of these bytes, of which there are enough.
    fn read(self, bytes: &[u8]) -> f64 {
        let low = || u16::from_le_bytes([bytes[0], bytes[1]]);
        let word = || u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]);
        match self {
            Self::I8 => f64::from(bytes[0] as i8),
            Self::U8 => f64::from(bytes[0]),
            Self::I16 => f64::from(low() as i16),
            Self::U16 => f64::from(low()),
            Self::U32 => f64::from(word()),
            Self::F32 => f64::from(f32::from_bits(word())),
        }
    }

    /// What a normalized number is divided by.
    fn full_scale(self) -> f64 {
        match self {
            Self::I8 => 127.0,
            Self::U8 => 255.0,
            Self::I16 => 32767.0,
            Self::U16 => 65535.0,
            Self::U32 | Self::F32 => 1.0,
        }
    }
}

/// Positions of vertices, in the frame of their mesh.
pub(super) fn positions(document: &Document, buffers: &Buffers<'_>, number: usize) -> Result<Vec<DVec3>, Problem> {
    let accessor = accessor(document, number)?;
    let component = Component::of_code(accessor.component_type)?;
    if accessor.shape != "VEC3" || component == Component::U32 {
        return Err(malformed(format!("accessor {number} holds no positions")));
    }
    let numbers = numbers(accessor, buffers, number, component, 3)?;
    let position = |xyz: &[f64]| {
        let position = DVec3::from_slice(xyz);
        if accessor.normalized { (position / component.full_scale()).max(DVec3::NEG_ONE) } else { position }
    };
    Ok(numbers.chunks_exact(3).map(position).collect())
}

/// Indices of vertices.
pub(super) fn indices(document: &Document, buffers: &Buffers<'_>, number: usize) -> Result<Vec<u32>, Problem> {
    let accessor = accessor(document, number)?;
    let component = Component::of_code(accessor.component_type)?;
    if accessor.shape != "SCALAR" || !matches!(component, Component::U8 | Component::U16 | Component::U32) {
        return Err(malformed(format!("accessor {number} holds no indices")));
    }
    let numbers = numbers(accessor, buffers, number, component, 1)?;
    Ok(numbers.into_iter().map(|index| index as u32).collect())
}

fn accessor(document: &Document, number: usize) -> Result<&Accessor, Problem> {
    document.accessors.get(number).ok_or_else(|| malformed(format!("accessor {number} is not there")))
}

/// All numbers of an accessor, `width` an element.
fn numbers(
    accessor: &Accessor,
    buffers: &Buffers<'_>,
    number: usize,
    component: Component,
    width: usize,
) -> Result<Vec<f64>, Problem> {
    let mut numbers = match accessor.buffer_view {
        Some(view) => elements(buffers, view, accessor.byte_offset, accessor.count, component, width)?,
        // Zero, but for the sparse ones. No file means more of these than it has bytes.
        None if accessor.sparse.is_some() && accessor.count <= buffers.len() => vec![0.0; accessor.count * width],
        None => return Err(malformed(format!("accessor {number} has no data"))),
    };
    let Some(Sparse { count, indices, values }) = &accessor.sparse else { return Ok(numbers) };

    let index_component = Component::of_code(indices.component_type)?;
    let places = elements(buffers, indices.buffer_view, indices.byte_offset, *count, index_component, 1)?;
    let values = elements(buffers, values.buffer_view, values.byte_offset, *count, component, width)?;
    for (place, value) in places.into_iter().zip(values.chunks_exact(width)) {
        let start = place as usize * width;
        let target = numbers.get_mut(start..start + width);
        target
            .ok_or_else(|| malformed(format!("accessor {number} has a sparse index out of range")))?
            .copy_from_slice(value);
    }
    Ok(numbers)
}

/// Elements of a buffer view from an offset on.
fn elements(
    buffers: &Buffers<'_>,
    view: usize,
    offset: usize,
    count: usize,
    component: Component,
    width: usize,
) -> Result<Vec<f64>, Problem> {
    let (bytes, stride) = buffers.view(view)?;
    let size = width * component.bytes();
    let stride = stride.filter(|&stride| stride > 0).unwrap_or(size);
    if stride < size {
        return Err(malformed(format!("buffer view {view} has elements that overlap")));
    }
    let end =
        count.checked_sub(1).map_or(Some(0), |last| last.checked_mul(stride)?.checked_add(size)?.checked_add(offset));
    if end.is_none_or(|end| end > bytes.len()) {
        return Err(malformed(format!("an accessor leaves buffer view {view}")));
    }
    let element = |start: usize| (0..width).map(move |k| component.read(&bytes[start + k * component.bytes()..]));
    Ok((0..count).flat_map(|number| element(offset + number * stride)).collect())
}

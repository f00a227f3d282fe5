//! Dense trilinear grids, the plain way: what a field has to beat.

mod bc4;

use crate::subject::Subject;
use crate::{Family, Kind, Measured};
use bc4::Blocks;
use glam::{DVec3, UVec3, Vec3};
use half::f16;
use nearfield_bake::field_function::FieldFunction;
use nearfield_bake::verify::BAND;

/// Where narrow grids are clamped, as a share of the diagonal.
pub(crate) const NARROW: f64 = 0.02;
const RESOLUTIONS: [u32; 7] = [16, 32, 48, 64, 96, 128, 192];

/// Samples, x fastest, and where they are.
struct Grid {
    min: Vec3,
    per_spacing: Vec3,
    counts: UVec3,
    /// What stored values count in, mesh units.
    scale: f32,
    storage: Storage,
}

enum Storage {
    F32(Vec<f32>),
    F16(Vec<f16>),
    /// Steps of 1/127.
    Snorm8(Vec<i8>),
    Bc4(Blocks),
}

/// Name, how far values may be (none: as far as the farthest), and how they are stored.
type Variant = (&'static str, Option<f64>, fn(&[f32], UVec3) -> Storage);

const VARIANTS: [Variant; 6] = [
    ("f32", None, |values, _| Storage::F32(values.to_vec())),
    ("f16", None, |values, _| Storage::F16(values.iter().map(|&value| f16::from_f32(value)).collect())),
    ("8 bits", None, |values, _| Storage::Snorm8(values.iter().map(|&value| snorm8(value)).collect())),
    ("BC4", None, |values, counts| Storage::Bc4(Blocks::encode(values, counts))),
    ("8 bits, narrow", Some(NARROW), |values, _| Storage::Snorm8(values.iter().map(|&value| snorm8(value)).collect())),
    ("BC4, narrow", Some(NARROW), |values, counts| Storage::Bc4(Blocks::encode(values, counts))),
];

pub(crate) fn families(subject: &Subject) -> Vec<Family> {
    let mut families: Vec<Family> = VARIANTS
        .iter()
        .map(|&(name, range, _)| {
            let kind = if range.is_some() { Kind::Narrow } else { Kind::Everywhere };
            Family { name, kind, fields: Vec::new() }
        })
        .collect();
    let diagonal = subject.mesh.bounds.diagonal();
    let min = subject.mesh.bounds.min - BAND * diagonal;
    let size = subject.mesh.bounds.size() + 2.0 * BAND * diagonal;
    for resolution in RESOLUTIONS {
        // Spaced alike along all sides, which the grid covers or exceeds.
        let spacing = size.max_element() / f64::from(resolution - 1);
        let counts = (size / spacing - 1e-9).ceil().as_uvec3() + 1;
        let distances = sample(subject, min, spacing, counts);
        let farthest = distances.iter().fold(0.0f64, |farthest, distance| farthest.max(distance.abs()));
        for (family, (_, range, store)) in families.iter_mut().zip(VARIANTS) {
            let scale = range.map_or(farthest, |range| range * diagonal);
            let values: Vec<f32> =
                distances.iter().map(|distance| (distance / scale).clamp(-1.0, 1.0) as f32).collect();
            let grid = Grid {
                min: min.as_vec3(),
                per_spacing: Vec3::splat((1.0 / spacing) as f32),
                counts,
                scale: scale as f32,
                storage: store(&values, counts),
            };
            let figures = grid.measure(subject);
            family.fields.push(Measured { setting: resolution.to_string(), bytes: grid.bytes(), figures });
        }
    }
    families
}

/// Exact distances, a layer at a time.
fn sample(subject: &Subject, min: DVec3, spacing: f64, counts: UVec3) -> Vec<f64> {
    let layer = |z: u32| {
        let rows = (0..counts.y).flat_map(move |y| (0..counts.x).map(move |x| UVec3::new(x, y, z)));
        let points: Vec<DVec3> = rows.map(|at| min + spacing * at.as_dvec3()).collect();
        subject.distance.sample_all(&points).into_iter().map(|sample| sample.distance)
    };
    (0..counts.z).flat_map(layer).collect()
}

fn snorm8(value: f32) -> i8 {
    (127.0 * value).round() as i8
}

impl Grid {
    fn bytes(&self) -> usize {
        match &self.storage {
            Storage::F32(values) => 4 * values.len(),
            Storage::F16(values) => 2 * values.len(),
            Storage::Snorm8(values) => values.len(),
            Storage::Bc4(blocks) => blocks.bytes(),
        }
    }

    /// One loop for each storage, so that none pays for the others.
    fn measure(&self, subject: &Subject) -> crate::Figures {
        let [nx, ny, _] = self.counts.to_array();
        let place = |[x, y, z]: [u32; 3]| (x + nx * (y + ny * z)) as usize;
        match &self.storage {
            Storage::F32(values) => subject.measure(|point| self.trilinear(point, |at| values[place(at)])),
            Storage::F16(values) => subject.measure(|point| self.trilinear(point, |at| values[place(at)].to_f32())),
            Storage::Snorm8(values) => {
                subject.measure(|point| self.trilinear(point, |at| f32::from(values[place(at)]) / 127.0))
            }
            Storage::Bc4(blocks) => subject.measure(|point| self.trilinear(point, |at| blocks.value(at))),
        }
    }

    #[inline]
    fn trilinear(&self, point: [f32; 3], value: impl Fn([u32; 3]) -> f32) -> f32 {
        let place = ((Vec3::from(point) - self.min) * self.per_spacing).max(Vec3::ZERO);
        let least = place.as_uvec3().min(self.counts - 2);
        let t = (place - least.as_vec3()).min(Vec3::ONE);
        let [x, y, z] = least.to_array();
        let row = |y, z| {
            let (a, b) = (value([x, y, z]), value([x + 1, y, z]));
            a + (b - a) * t.x
        };
        let layer = |z| {
            let (a, b) = (row(y, z), row(y + 1, z));
            a + (b - a) * t.y
        };
        let (a, b) = (layer(z), layer(z + 1));
        (a + (b - a) * t.z) * self.scale
    }
}

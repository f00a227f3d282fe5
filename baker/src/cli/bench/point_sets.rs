//! Where a field is asked while the clock runs.

use glam::Vec3;
use nearfield::Field;
use nearfield_bake::random::Draws;
use nearfield_bake::verify::BAND;

/// Points a set.
const COUNT: u64 = 1 << 16;
/// Points along a row and rows a layer of the coherent set.
const ROW: u64 = 128;

const RANDOM_STREAM: u64 = 11;
const BAND_STREAM: u64 = 12;

/// Anywhere in the field's box, in no order.
pub(super) fn random(field: &Field<'_>) -> Vec<[f32; 3]> {
    (0..COUNT).map(|index| anywhere(field, &mut Draws::new(0, RANDOM_STREAM, index)).to_array()).collect()
}

/// Row by row through evenly spaced layers of the field's box.
pub(super) fn coherent(field: &Field<'_>) -> Vec<[f32; 3]> {
    let bounds = field.header().bounds;
    let (min, size) = (Vec3::from(bounds.min), Vec3::from(bounds.max) - Vec3::from(bounds.min));
    let layers = COUNT / (ROW * ROW);
    let middle = |index: u64, count: u64| (index as f32 + 0.5) / count as f32;

    (0..COUNT)
        .map(|index| {
            let (x, y, z) = (index % ROW, index / ROW % ROW, index / (ROW * ROW));
            (min + size * Vec3::new(middle(x, ROW), middle(y, ROW), middle(z, layers))).to_array()
        })
        .collect()
}

/// Within the band, in no order: points pulled to the surface along the gradient, then moved away by
/// up to the band's width. Fewer, or none, where the field has hardly any surface.
pub(super) fn band(field: &Field<'_>) -> Vec<[f32; 3]> {
    let reach = BAND as f32 * field.header().diagonal;
    let bounds = field.header().bounds;
    let (min, max) = (Vec3::from(bounds.min), Vec3::from(bounds.max));

    (0..4 * COUNT)
        .filter_map(|index| {
            let mut draws = Draws::new(0, BAND_STREAM, index);
            let mut point = anywhere(field, &mut draws);
            for _ in 0..2 {
                let (distance, gradient) = field.distance_and_gradient(point.to_array());
                point -= distance * Vec3::from(gradient);
            }
            point += draws.direction().as_vec3() * (reach * draws.unit() as f32);

            let inside_box = point.cmpge(min).all() && point.cmple(max).all();
            let in_band = field.distance(point.to_array()).abs() <= reach;
            (inside_box && in_band).then_some(point.to_array())
        })
        .take(COUNT as usize)
        .collect()
}

fn anywhere(field: &Field<'_>, draws: &mut Draws) -> Vec3 {
    let bounds = field.header().bounds;
    let (min, size) = (Vec3::from(bounds.min), Vec3::from(bounds.max) - Vec3::from(bounds.min));
    min + size * Vec3::new(draws.unit() as f32, draws.unit() as f32, draws.unit() as f32)
}

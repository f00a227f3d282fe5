//! The colours of a distance: blue inside, warm outside, pale at the surface.

use super::image::Rgb;

/// Colour of the surface itself.
pub(super) const SURFACE: Rgb = [12, 12, 14];
/// Colour of the isolines.
pub(super) const ISOLINE: Rgb = [96, 96, 100];
/// Colour of the borders of leaves.
pub(super) const CELL: Rgb = [40, 44, 52];

/// Colour of places whose sign is a guess.
pub(super) const DOUBT: Rgb = [214, 12, 24];

/// Shades on either side of the surface: more than the eye tells apart, few enough for small files.
const SHADES: f64 = 128.0;

const INSIDE: [Rgb; 3] = [[222, 238, 250], [88, 158, 214], [10, 54, 112]];
const OUTSIDE: [Rgb; 3] = [[255, 246, 228], [246, 178, 98], [150, 50, 8]];

/// Colour of a signed distance, on a scale whose deepest colours stand for `range`.
///
/// The square root spreads the colours near the surface, where distances matter.
pub(super) fn of_distance(distance: f64, range: f64) -> Rgb {
    let depth = (distance.abs() / range).clamp(0.0, 1.0).sqrt();
    let depth = (depth * SHADES).round() / SHADES;
    let [near, middle, far] = if distance < 0.0 { INSIDE } else { OUTSIDE };

    if depth < 0.5 { mix(near, middle, 2.0 * depth) } else { mix(middle, far, 2.0 * depth - 1.0) }
}

/// `share` of `over`, the rest of `under`.
pub(super) fn mix(under: Rgb, over: Rgb, share: f64) -> Rgb {
    std::array::from_fn(|channel| {
        let (under, over) = (f64::from(under[channel]), f64::from(over[channel]));
        (under + (over - under) * share).round() as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inside_is_blue_outside_is_warm_and_the_ends_are_the_ends() {
        assert_eq!(of_distance(-1.0, 1.0), INSIDE[2]);
        assert_eq!(of_distance(5.0, 1.0), OUTSIDE[2]);
        assert_eq!(of_distance(0.25, 1.0), OUTSIDE[1]);
        let ([red_in, _, blue_in], [red_out, _, blue_out]) = (of_distance(-0.5, 1.0), of_distance(0.5, 1.0));
        assert!(blue_in > red_in && red_out > blue_out);
    }
}

//! The colours of a distance: blue inside, warm outside, pale at the surface.

use super::image::Rgb;

/// Colour of the surface itself.
pub(super) const SURFACE: Rgb = [12, 12, 14];
/// Colour of the isolines.
pub(super) const ISOLINE: Rgb = [96, 96, 100];
/// Colour of the borders of leaves.
pub(super) const CELL: Rgb = [40, 44, 52];

/// Colour of places that the field does not cover.
pub(super) const BEYOND: Rgb = [176, 176, 178];

/// Colour of places whose sign is a guess.
pub(super) const DOUBT: Rgb = [214, 12, 24];

/// Shades on either side of the surface: more than the eye tells apart, few enough for small files.
const SHADES: f64 = 128.0;

const INSIDE: [Rgb; 3] = [[222, 238, 250], [88, 158, 214], [10, 54, 112]];
const OUTSIDE: [Rgb; 3] = [[255, 246, 228], [246, 178, 98], [150, 50, 8]];

/// From nothing to the greatest error: darker is worse, in print too.
const ERROR: [Rgb; 5] = [[255, 255, 255], [253, 212, 118], [214, 84, 72], [96, 22, 112], [14, 6, 40]];

/// Colour of an error, a share of the greatest one.
pub(super) fn of_error(share: f64) -> Rgb {
    let stops = (ERROR.len() - 1) as f64;
    let share = share.clamp(0.0, 1.0) * stops;
    let below = share.floor().min(stops - 1.0);
    mix(ERROR[below as usize], ERROR[below as usize + 1], share - below)
}

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
    fn a_larger_error_is_darker() {
        let light = |share: f64| of_error(share).map(u32::from).iter().sum::<u32>();
        let lights: Vec<u32> = (0..=20).map(|step| light(f64::from(step) / 20.0)).collect();
        assert!(lights.windows(2).all(|pair| pair[0] > pair[1]), "{lights:?}");
        assert_eq!((of_error(0.0), of_error(1.0), of_error(9.0)), (ERROR[0], ERROR[4], ERROR[4]));
    }

    #[test]
    fn inside_is_blue_outside_is_warm_and_the_ends_are_the_ends() {
        assert_eq!(of_distance(-1.0, 1.0), INSIDE[2]);
        assert_eq!(of_distance(5.0, 1.0), OUTSIDE[2]);
        assert_eq!(of_distance(0.25, 1.0), OUTSIDE[1]);
        let ([red_in, _, blue_in], [red_out, _, blue_out]) = (of_distance(-0.5, 1.0), of_distance(0.5, 1.0));
        assert!(blue_in > red_in && red_out > blue_out);
    }
}

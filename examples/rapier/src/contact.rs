//! Where a ball or a capsule touches a field.

use nearfield::Field;
use rapier3d::math::{Pose, Real, Vector};
use rapier3d::parry::shape::Shape;

/// Stretches into which a capsule's segment is divided in search of its deepest points: what is deep within one stretch
/// only is found if an end of the stretch shows it.
const STRETCHES: usize = 8;
/// Halvings of the stretches around such a point.
const HALVINGS: usize = 8;

/// Most touches of one ball.
const MOST: usize = 4;
/// Touches whose normals are closer than 45 degrees are one.
const SAME: Real = 0.7;
/// A slope below this is that of a centre between several places, and points to none of them.
const BETWEEN: Real = 0.75;
/// Most steps of the walk to a touch, and the cosine at which it has arrived: 11 degrees.
const WALK: usize = 8;
const SETTLED: Real = 0.98;
/// Where the walks start: the faces and the corners of a cube.
const AROUND: [Vector; 14] = [
    Vector::NEG_X,
    Vector::X,
    Vector::NEG_Y,
    Vector::Y,
    Vector::NEG_Z,
    Vector::Z,
    Vector::new(-1.0, -1.0, -1.0),
    Vector::new(1.0, -1.0, -1.0),
    Vector::new(-1.0, 1.0, -1.0),
    Vector::new(1.0, 1.0, -1.0),
    Vector::new(-1.0, -1.0, 1.0),
    Vector::new(1.0, -1.0, 1.0),
    Vector::new(-1.0, 1.0, 1.0),
    Vector::new(1.0, 1.0, 1.0),
];

/// All points within a radius of a segment: a capsule, or a ball where the ends are one.
pub(crate) struct Rounded {
    ends: [Vector; 2],
    radius: Real,
}

impl Rounded {
    /// The shape, if it is one.
    pub(crate) fn of(shape: &dyn Shape) -> Option<Self> {
        if let Some(ball) = shape.as_ball() {
            return Some(Self { ends: [Vector::ZERO; 2], radius: ball.radius });
        }
        let capsule = shape.as_capsule()?;
        Some(Self { ends: [capsule.segment.a, capsule.segment.b], radius: capsule.radius })
    }
}

/// One place where they touch, or nearly.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Touch {
    /// On the field's surface, its frame.
    pub(crate) on_field: Vector,
    /// On the other's surface, the other's frame.
    pub(crate) on_other: Vector,
    /// Unit vector out of the field, its frame.
    pub(crate) normal: Vector,
    /// From surface to surface, negative where they overlap.
    pub(crate) distance: Real,
}

/// The touches of at most `reach`: of balls around the ends of the segment, and around where it is deepest between them.
///
/// `pose` takes the other's frame to the field's. A ball out of reach takes one query, one in reach some thirty; a capsule's
/// segment takes nine more, and sixteen for each place between its ends.
pub(crate) fn touches<'a>(
    field: &'a Field<'_>,
    other: &'a Rounded,
    pose: &'a Pose,
    reach: Real,
) -> impl Iterator<Item = Touch> + 'a {
    let [a, b] = other.ends.map(|end| pose * end);
    // A ball has one centre.
    let is_segment = a != b;
    let ends = [Some(a), is_segment.then_some(b)].into_iter().flatten();
    let between = is_segment.then(|| deepest_between(field, a, b)).into_iter().flatten();

    let to_other = move |touch: Touch| Touch { on_other: pose.inverse_transform_point(touch.on_other), ..touch };
    ends.chain(between).flat_map(move |centre| touches_of_ball(field, centre, other.radius, reach)).map(to_other)
}

/// The touches of a ball, with `on_other` in the field's frame.
///
/// The first is where the centre is closest. One alone is not enough: in a hole or a groove a ball touches several places, and
/// is held only by all of them together. The others are where the field is lowest over the ball's surface.
fn touches_of_ball(field: &Field<'_>, centre: Vector, radius: Real, reach: Real) -> impl Iterator<Item = Touch> {
    let mut touches = [None; MOST];
    let mut count = 0;
    let (distance, gradient) = field.distance_and_gradient(centre.into());
    if distance - radius > reach {
        return touches.into_iter().flatten();
    }

    let slope = Vector::from(gradient).length();
    if distance <= 0.0 || slope > BETWEEN {
        // Without a slope there is no way to push.
        touches[count] = (slope > 0.0).then(|| {
            let normal = Vector::from(gradient) / slope;
            let (on_field, on_other) = (centre - normal * distance, centre - normal * radius);
            Touch { on_field, on_other, normal, distance: distance - radius }
        });
        count += 1;
    }
    if distance <= 0.0 {
        return touches.into_iter().flatten();
    }

    for start in AROUND.map(Vector::normalize) {
        let is_known = touches.iter().flatten().any(|known| known.normal.dot(-start) > SAME);
        // From the place that is sought to the nearest start it is at most 0.6 radii, and no slope is steeper than 1.
        if count == MOST || is_known || field.distance((centre + start * radius).into()) > reach + 0.6 * radius {
            continue;
        }
        let is_new = |touch: &Touch| touches.iter().flatten().all(|known| known.normal.dot(touch.normal) < SAME);
        let lowest = lowest_on_ball(field, centre, radius, start);
        if let Some(touch) = lowest.filter(|touch| touch.distance <= reach).filter(is_new) {
            touches[count] = Some(touch);
            count += 1;
        }
    }
    touches.into_iter().flatten()
}

/// The place on a ball's surface to which a walk from `direction` leads, ever lower and to where the slope points from; none if
/// it does not settle.
fn lowest_on_ball(field: &Field<'_>, centre: Vector, radius: Real, direction: Vector) -> Option<Touch> {
    let place = |direction: Vector| {
        let on_other = centre + direction * radius;
        let (distance, gradient) = field.distance_and_gradient(on_other.into());
        let normal = Vector::from(gradient).try_normalize()?;
        Some((direction, Touch { on_field: on_other - normal * distance, on_other, normal, distance }))
    };

    let mut stride = 1.0;
    let mut lowest = place(direction)?;
    for _ in 0..WALK {
        let (direction, touch) = lowest;
        if direction.dot(touch.normal) < -SETTLED {
            return Some(touch);
        }
        let next = place(direction.lerp(-touch.normal, stride).try_normalize()?)?;
        // A step that leads no lower is tried again at half its length.
        if next.1.distance < touch.distance {
            lowest = next;
        } else {
            stride *= 0.5;
        }
    }
    None
}

/// Where the field has a lowest value between two points and not at either.
fn deepest_between(field: &Field<'_>, a: Vector, b: Vector) -> impl Iterator<Item = Vector> {
    let depth = move |share: Real| field.distance(a.lerp(b, share).into());
    let share = |stretch: usize| stretch as Real / STRETCHES as Real;
    let depths: [Real; STRETCHES + 1] = std::array::from_fn(|stretch| depth(share(stretch)));

    let is_lowest = move |&stretch: &usize| {
        let [before, here, after] = [depths[stretch - 1], depths[stretch], depths[stretch + 1]];
        here < before && here <= after
    };
    (1..STRETCHES).filter(is_lowest).map(move |stretch| {
        // The middle stays the lowest of three.
        let (mut middle, mut lowest, mut width) = (share(stretch), depths[stretch], share(1));
        for _ in 0..HALVINGS {
            width *= 0.5;
            for candidate in [middle - width, middle + width] {
                let value = depth(candidate);
                if value < lowest {
                    (lowest, middle) = (value, candidate);
                }
            }
        }
        a.lerp(b, middle)
    })
}

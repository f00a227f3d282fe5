// A view of a field's surface by sphere tracing (Hart 1996) with the occlusion and the soft shadow of `nearfield render`
// (after Pujol and Chica 2023, section 7.2), and of a plane through the field.

struct View {
    eye: vec3<f32>,
    // Width of a pixel one unit in front of the eye.
    pixel: f32,
    forward: vec3<f32>,
    // Diagonal of the box, mesh units.
    size: f32,
    right: vec3<f32>,
    // Half the width of the picture one unit in front of the eye.
    half_width: f32,
    up: vec3<f32>,
    // Half its height.
    half_height: f32,
    // What is on this side of a plane is cut away: a unit vector, or zero. The eye is on that side too.
    cut: vec3<f32>,
    // Where the plane is along that vector.
    cut_at: f32,
    // The surface drawn is where the distance is this, mesh units.
    offset: f32,
    // The distance of the deepest colours of the plane, and that between its lines, mesh units.
    deepest: f32,
    spacing: f32,
    // Rays a pixel along each axis.
    antialias: u32,
    // Bits SHOW_.
    show: u32,
}

@group(0) @binding(1) var<uniform> view: View;

const SHOW_OCCLUSION: u32 = 1u;
const SHOW_SHADOW: u32 = 2u;
// Red, green and blue are the gradient's x, y and z.
const SHOW_NORMALS: u32 = 4u;

// Steps after which a ray is taken for lost along a surface.
const MAX_STEPS: u32 = 512u;
// A ray has arrived within this part of a pixel.
const ARRIVED: f32 = 0.25;
const CLAY: vec3<f32> = vec3(0.62, 0.60, 0.56);
const BACKGROUND: vec3<f32> = vec3(1.0);
// Direction of the lamp, as the camera sees it: right, up, back.
const LAMP: vec3<f32> = vec3(-0.55, 0.8, 0.6);
// How sharp shadows are: the sine of the lamp's angular radius is about one over this.
const SHADOW_SHARPNESS: f32 = 12.0;
const PROBES: u32 = 5u;
// Sum of the probes' weights.
const ALL_PROBES: f32 = (1.0 - 0.7 * 0.7 * 0.7 * 0.7 * 0.7) / (1.0 - 0.7);

// What an evaluation of the field is for.
const TRACE: u32 = 0u;
const OCCLUSION: u32 = 1u;
const SHADOW: u32 = 2u;
const PLANE: u32 = 3u;

@fragment
fn pixel(at: Corner) -> @location(0) vec4<f32> {
    let field = nearfield_open();
    let middle = view.forward + view.right * (at.place.x * view.half_width) + view.up * (at.place.y * view.half_height);
    var sum = vec3(0.0);
    for (var index = 0u; index < view.antialias * view.antialias; index++) {
        let within = (vec2(f32(index % view.antialias), f32(index / view.antialias)) + 0.5) / f32(view.antialias) - 0.5;
        let place = within * view.pixel;
        sum += colour(field, normalize(middle + view.right * place.x + view.up * place.y));
    }
    let linear = clamp(sum / f32(view.antialias * view.antialias), vec3(0.0), vec3(1.0));
    let encoded = select(1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055, 12.92 * linear, linear <= vec3(0.0031308));
    return vec4(encoded, 1.0);
}

// Where a half line enters and leaves the box: distances along it, the first at least 0.
fn through(field: Field, origin: vec3<f32>, direction: vec3<f32>) -> vec2<f32> {
    // A direction within a face would divide 0 by 0.
    let safe = select(direction, vec3(1e-20), abs(direction) < vec3(1e-20));
    let low = (field.low - origin) / safe;
    let high = (field.high - origin) / safe;
    let enter = min(low, high);
    let leave = max(low, high);
    return vec2(max(max(enter.x, enter.y), max(enter.z, 0.0)), min(min(leave.x, leave.y), leave.z));
}

// How far one may go in any direction from where the field says `distance` without crossing zero: by its slope, and by its
// error, since within `distance` - 2 errors the true distance is at least the error.
fn safe_step(distance: f32, slope: f32, error: f32) -> f32 {
    return max(distance / slope, distance - 2.0 * error);
}

fn direction_of(seen: vec3<f32>) -> vec3<f32> {
    return normalize(view.right * seen.x + view.up * seen.y - view.forward * seen.z);
}

// Linear colour of the half line from the eye.
//
// The field is evaluated at one place of the code, whatever for: compilers of shaders write the whole reader out at each.
fn colour(field: Field, direction: vec3<f32>) -> vec3<f32> {
    var interval = through(field, view.eye, direction);
    var phase = TRACE;

    // The plane, if the half line meets it within the box.
    let beyond = dot(view.cut, view.eye) - view.cut_at;
    if any(view.cut != vec3(0.0)) && beyond > 0.0 {
        let toward = -dot(view.cut, direction);
        if toward * interval.y <= beyond {
            return BACKGROUND;
        }
        if toward * interval.x < beyond {
            interval.x = beyond / toward;
            phase = PLANE;
        }
    }
    if interval.x >= interval.y {
        return BACKGROUND;
    }

    let slope = max(nearfield_slope(), 1.0);
    let error = nearfield_error();
    let lamp = direction_of(LAMP);
    var travelled = interval.x;
    var place = view.eye + direction * travelled;
    var steps = 0u;
    // Of what has been hit: the place, the way out of it, the lamp's part of its light, how hidden it is.
    var point: vec3<f32>;
    var normal: vec3<f32>;
    var facing = 0.0;
    var hidden = 0.0;
    var weight = 1.0;
    var lit = 1.0;
    var leave = 0.0;
    loop {
        let answer = nearfield_evaluate(field, place);
        let distance = answer.distance - view.offset;
        steps += 1u;

        if phase == PLANE {
            return colour_of_distance(distance, view.pixel * travelled);
        } else if phase == TRACE {
            let near = ARRIVED * view.pixel * travelled;
            if distance >= near && steps <= MAX_STEPS {
                travelled += max(safe_step(distance, slope, error), near);
                if travelled > interval.y {
                    return BACKGROUND;
                }
                place = view.eye + direction * travelled;
                continue;
            }
            point = place;
            normal = answer.gradient / max(length(answer.gradient), 1e-30);
            // Inside out, or seen from within: both sides are lit alike.
            normal = select(normal, -normal, dot(normal, direction) > 0.0);
            if (view.show & SHOW_NORMALS) != 0u {
                return 0.5 * normal + 0.5;
            }
            facing = max(dot(normal, lamp), 0.0);
            phase = OCCLUSION;
            steps = 0u;
        } else if phase == OCCLUSION {
            let height = 0.12 * view.size * f32(steps) / f32(PROBES);
            hidden += weight * clamp(1.0 - distance / height, 0.0, 1.0);
            weight *= 0.7;
        } else {
            lit = min(lit, SHADOW_SHARPNESS * distance / travelled);
            travelled += max(safe_step(distance, slope, error), 2e-3 * view.size);
        }

        // Up the normal, then to the lamp.
        if phase == OCCLUSION && ((view.show & SHOW_OCCLUSION) == 0u || steps == PROBES) {
            if facing == 0.0 || (view.show & SHOW_SHADOW) == 0u {
                break;
            }
            phase = SHADOW;
            // Off the surface, so that its own roundness does not count.
            leave = through(field, point + normal * (1e-3 * view.size), lamp).y;
            travelled = 4e-3 * view.size;
        }
        if phase == OCCLUSION {
            place = point + normal * (0.12 * view.size * f32(steps + 1u) / f32(PROBES));
        } else {
            if travelled >= leave || lit <= 0.0 {
                break;
            }
            place = point + normal * (1e-3 * view.size) + lamp * travelled;
        }
    }

    let open = 1.0 - hidden / ALL_PROBES;
    let soft = clamp(lit, 0.0, 1.0);
    let light = soft * soft * (3.0 - 2.0 * soft);
    let sky = 0.24 + 0.12 * dot(normal, view.up);
    return CLAY * (sky * open + 0.95 * facing * light * (0.5 + 0.5 * open));
}

// Linear colour of a distance on the plane, as `nearfield slice` has them: blue inside, warm outside, lines at equal
// distances, the surface black. `pixel` is the width of a pixel there.
fn colour_of_distance(distance: f32, pixel: f32) -> vec3<f32> {
    let depth = 2.0 * sqrt(clamp(abs(distance) / view.deepest, 0.0, 1.0));
    let is_inside = distance < 0.0;
    let near = select(vec3(255.0, 246.0, 228.0), vec3(222.0, 238.0, 250.0), is_inside);
    let middle = select(vec3(246.0, 178.0, 98.0), vec3(88.0, 158.0, 214.0), is_inside);
    let far = select(vec3(150.0, 50.0, 8.0), vec3(10.0, 54.0, 112.0), is_inside);
    let ground = select(mix(near, middle, depth), mix(middle, far, depth - 1.0), depth > 1.0);
    let to_line = distance - round(distance / view.spacing) * view.spacing;
    let line = clamp(1.0 - abs(to_line) / pixel, 0.0, 1.0);
    let surface = clamp(1.5 - abs(distance) / pixel, 0.0, 1.0);
    let encoded = mix(mix(ground, vec3(96.0, 96.0, 100.0), 0.6 * line), vec3(12.0, 12.0, 14.0), surface) / 255.0;
    return select(pow((encoded + 0.055) / 1.055, vec3(2.4)), encoded / 12.92, encoded <= vec3(0.04045));
}

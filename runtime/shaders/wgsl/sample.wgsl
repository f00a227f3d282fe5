// Arithmetic with a fixed order of operations, words and the sample codec (SPEC.md §8).

fn float(index: u32) -> f32 {
    return bitcast<f32>(word(index));
}

// The number, or the greatest float where it is infinity. Told by its bits, whose order is that of numbers.
fn finite(number: f32) -> f32 {
    return bitcast<f32>(min(bitcast<i32>(number), 0x7F7FFFFF));
}

fn byte_of(bits: u32, number: u32) -> u32 {
    return (bits >> (8u * number)) & 0xFFu;
}

// 2 to the power of minus `exponent`, for exponents up to 126.
fn power_of_half(exponent: u32) -> f32 {
    return bitcast<f32>((127u - min(exponent, 126u)) << 23u);
}

fn copy_sign(magnitude: f32, sign: f32) -> f32 {
    return bitcast<f32>(bitcast<u32>(abs(magnitude)) | (bitcast<u32>(sign) & 0x80000000u));
}

// Bits that are set. GLSL ES 3.00 cannot count them by itself.
fn count_bits(bits: u32) -> u32 {
    let pairs = bits - ((bits >> 1u) & 0x55555555u);
    let nibbles = (pairs & 0x33333333u) + ((pairs >> 2u) & 0x33333333u);
    return (((nibbles + (nibbles >> 4u)) & 0x0F0F0F0Fu) * 0x01010101u) >> 24u;
}

// 1/√x for x from 1/3 to 1.
fn reciprocal_sqrt(x: f32) -> f32 {
    let seed = 2.8898656 - x * (4.8495786 - x * (4.646499 - x * 1.6896812));
    let half = 0.5 * x;
    let coarse = seed * (1.5 - half * (seed * seed));
    return coarse + coarse * (0.5 - half * (coarse * coarse));
}

// Length, at most the greatest float, and unit direction of a finite vector that is not zero.
fn length_and_direction(vector: vec3<f32>) -> Answer {
    let largest = max(max(abs(vector.x), abs(vector.y)), abs(vector.z));
    let scaled = vector / largest;
    // On the octahedron |x| + |y| + |z| = 1 the squared length lies in 1/3 to 1.
    let taxicab = abs(scaled.x) + abs(scaled.y) + abs(scaled.z);
    let place = scaled / taxicab;
    let squared = place.x * place.x + place.y * place.y + place.z * place.z;
    let reciprocal = reciprocal_sqrt(squared);
    let length = finite(taxicab * (squared * reciprocal) * largest);
    return Answer(length, place * reciprocal);
}

// Unit gradient of an octahedral code, which is in the low 20 bits (Meyer et al. 2010).
fn decode_gradient(code: u32) -> vec3<f32> {
    let codes = vec2<i32>(vec2(code & GRADIENT_MASK, (code >> GRADIENT_BITS) & GRADIENT_MASK)) - GRADIENT_CENTRE;
    let flat = vec2<f32>(codes) * GRADIENT_STEP;
    // The lower half of the octahedron is folded over the edges of the square.
    let z = 1.0 - abs(flat.x) - abs(flat.y);
    let fold = max(-z, 0.0);
    let x = flat.x - copy_sign(fold, flat.x);
    let y = flat.y - copy_sign(fold, flat.y);
    return vec3(x, y, z) * reciprocal_sqrt(x * x + y * y + z * z);
}

// Value of the half float in the low 16 bits; 0 for an infinity or a NaN.
fn decode_half(bits: u32) -> f32 {
    let sign = (bits & 0x8000u) << 16u;
    let exponent = (bits >> 10u) & 31u;
    let fraction = bits & 0x3FFu;
    if exponent == 0u {
        return bitcast<f32>(sign | bitcast<u32>(f32(fraction) * SUBNORMAL_STEP));
    }
    return bitcast<f32>(sign | select(((exponent + 112u) << 23u) | (fraction << 13u), 0u, exponent == 31u));
}

const SUBNORMAL_STEP: f32 = 1.0 / 16777216.0;

// The low and the high half of a word.
fn decode_halves(bits: u32) -> vec2<f32> {
    return vec2(decode_half(bits), decode_half(bits >> 16u));
}

// Distance of a code, mesh units.
fn decode_distance(base: i32, code: u32, quantum: f32) -> f32 {
    return f32(base + i32(code)) * quantum;
}

// The float of a sample; 0 for what a valid file does not hold.
fn decode_float(bits: u32) -> f32 {
    return select(0.0, bitcast<f32>(bits), (bits & 0x7FFFFFFFu) <= MAX_MAGNITUDE_BITS);
}

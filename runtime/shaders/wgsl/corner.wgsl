// A triangle that covers the picture.

struct Corner {
    @builtin(position) position: vec4<f32>,
    // -1 to 1, to the right and up.
    @location(0) place: vec2<f32>,
}

@vertex
fn corner(@builtin(vertex_index) index: u32) -> Corner {
    let place = vec2(f32(index & 1u) * 4.0 - 1.0, f32(index >> 1u) * 4.0 - 1.0);
    return Corner(vec4(place, 0.0, 1.0), place);
}

// Calls every function of the door, so that a translation of one entry point holds the whole reader.

@fragment
fn pixel(@location(0) point: vec3<f32>) -> @location(0) vec4<f32> {
    let field = nearfield_open();
    let answer = nearfield_evaluate(field, point);
    return vec4(answer.gradient, nearfield_distance(field, point) + nearfield_slope() + nearfield_error());
}

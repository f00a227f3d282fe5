// Distance and gradient at each of a list of points.

// x, y, z of each point.
@group(0) @binding(1) var<storage, read> points: array<f32>;
// Distance and gradient's x, y, z of each point.
@group(0) @binding(2) var<storage, read_write> answers: array<vec4<f32>>;

@compute @workgroup_size(64)
fn query(@builtin(global_invocation_id) invocation: vec3<u32>) {
    let index = invocation.x;
    if index >= arrayLength(&answers) || 3u * index + 2u >= arrayLength(&points) {
        return;
    }
    let point = vec3(points[3u * index], points[3u * index + 1u], points[3u * index + 2u]);
    let answer = nearfield_evaluate(nearfield_open(), point);
    answers[index] = vec4(answer.distance, answer.gradient);
}

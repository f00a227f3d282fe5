use crate::support::{Bench, Outcome};
use std::fs;

#[test]
fn binary_points_give_binary_answers() {
    let bench = Bench::new();
    bench.bake_cube();
    let points: Vec<[f32; 3]> = vec![[0.5, 0.5, 0.5], [0.25, 0.75, 1.2], [3.0, 0.5, 0.5], [0.1, 0.2, 0.3]];
    bench.write("points.f32", points.as_flattened().iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>());
    let text: String = points.iter().map(|[x, y, z]| format!("{x} {y} {z}\n")).collect();

    // Binary, from file to file and from pipe to pipe.
    bench.run("query cube.nfd --points points.f32 -o distances.f32").succeeds();
    let distances = floats(&fs::read(bench.path("distances.f32")).expect("the answers"));
    let input = fs::read(bench.path("points.f32")).expect("the points");
    let piped = bench.run_with_input("query cube.nfd --points - -o - --gradient", &input);
    let answers = floats(&piped.succeeds().output.stdout);

    // Text.
    let spoken = bench.run_with_input("query cube.nfd --gradient", text.as_bytes());
    let lines: Vec<f32> =
        spoken.succeeds().stdout().split_ascii_whitespace().map(|number| number.parse().expect("a number")).collect();

    assert_eq!(distances.len(), points.len());
    assert_eq!(answers.len(), 4 * points.len());
    assert_eq!(answers, lines, "text carries every bit");
    for (distance, answer) in distances.iter().zip(answers.chunks(4)) {
        assert_eq!(*distance, answer[0], "the gradient does not change the distance");
    }
}

#[test]
fn rays_and_closest_points_meet_the_surface() {
    let bench = Bench::new();
    bench.bake_cube();
    let rays: [[f32; 6]; 3] =
        [[0.5, 0.4, 3.0, 0.0, 0.0, -2.0], [0.5, 0.4, 3.0, 0.0, 0.0, 1.0], [0.3, 0.6, -0.5, 0.1, 0.0, 0.9]];
    let points: [[f32; 3]; 2] = [[0.5, 0.4, 0.9], [0.3, -0.05, 0.5]];
    let bytes = |numbers: &[f32]| numbers.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>();
    let text = |numbers: &[f32]| numbers.iter().map(f32::to_string).collect::<Vec<_>>().join(" ") + "\n";
    bench.write("rays.f32", bytes(rays.as_flattened()));
    bench.write("points.f32", bytes(points.as_flattened()));
    let ray_lines: String = rays.iter().map(|ray| text(ray)).collect();
    let point_lines: String = points.iter().map(|point| text(point)).collect();

    // Both ways and the field's own answers agree to the bit.
    bench.run("raycast cube.nfd --rays rays.f32 -o hits.f32").succeeds();
    let hits = floats(&fs::read(bench.path("hits.f32")).expect("the hits"));
    let spoken = bench.run_with_input("raycast cube.nfd", ray_lines.as_bytes()).succeeds().stdout();
    let field = fs::read(bench.path("cube.nfd")).expect("the field");
    let field = nearfield::Field::open(&field).expect("a field");
    assert_eq!(hits.len(), 8 * rays.len());
    for ((ray, hit), line) in rays.iter().zip(hits.chunks(8)).zip(spoken.lines()) {
        let &[x, y, z, u, v, w] = ray;
        match field.raycast([x, y, z], [u, v, w], f32::INFINITY, 0.0) {
            nearfield::Raycast::Hit(expected) => {
                let [a, b, c] = expected.point;
                let [d, e, f] = expected.normal;
                assert_eq!(hit, [1.0, expected.distance, a, b, c, d, e, f]);
                assert_eq!(line, format!("hit {}", text(&hit[1..]).trim_end()));
            }
            nearfield::Raycast::Miss { .. } => assert_eq!((hit, line), ([0.0; 8].as_slice(), "miss")),
            nearfield::Raycast::OutOfSteps { clear } => panic!("out of steps at {clear}"),
        }
    }
    assert_eq!(hits.iter().step_by(8).copied().collect::<Vec<f32>>(), [1.0, 0.0, 1.0]);
    assert!((hits[1] - 2.0).abs() < 0.02, "the top of the cube is 2 below: {}", hits[1]);

    bench.run("closest-point cube.nfd --points points.f32 -o ends.f32").succeeds();
    let ends = floats(&fs::read(bench.path("ends.f32")).expect("the ends"));
    let spoken = bench.run_with_input("closest-point cube.nfd", point_lines.as_bytes()).succeeds().stdout();
    for ((&point, end), line) in points.iter().zip(ends.chunks(4)).zip(spoken.lines()) {
        let nearfield::ClosestPoint { point: [x, y, z], residual, .. } = field.closest_point(point);
        assert_eq!(end, [x, y, z, residual]);
        assert_eq!(line, text(end).trim_end());
    }

    // In JSON, and shorter than the way to the cube.
    let json = |outcome: Outcome| -> Vec<serde_json::Value> {
        outcome.succeeds().stdout().lines().map(|line| serde_json::from_str(line).expect("JSON")).collect()
    };
    let ends = json(bench.run_with_input("closest-point cube.nfd --json", point_lines.as_bytes()));
    assert!(ends[0]["steps"].as_u64().expect("a number") >= 1 && ends[0]["point"][2].is_number(), "{}", ends[0]);
    let hits = json(bench.run("raycast cube.nfd --rays rays.f32 --json --length 1"));
    assert_eq!(
        hits.iter().map(|hit| hit["end"].as_str()).collect::<Vec<_>>(),
        [Some("miss"), Some("miss"), Some("hit")]
    );
    assert!(hits[2]["normal"][2].as_f64().expect("a number") < -0.9, "{}", hits[2]);
    let distances = json(bench.run("query cube.nfd --points points.f32 --gradient --json"));
    assert_eq!(distances[1]["gradient"].as_array().map(Vec::len), Some(3));

    bench.run_with_input("raycast cube.nfd", b"0 0 0 1 0\n").fails(3, &["line 1", "dx dy dz"]);
    bench.run("raycast cube.nfd --rays points.f32 --length 0 -o out.f32").succeeds();
    bench.run("raycast cube.nfd --length -1").fails(2, &["--length"]);
}

fn floats(bytes: &[u8]) -> Vec<f32> {
    let (numbers, rest) = bytes.as_chunks::<4>();
    assert!(rest.is_empty(), "whole floats");
    numbers.iter().map(|&number| f32::from_le_bytes(number)).collect()
}

#[test]
fn points_that_are_no_points_end_with_3() {
    let bench = Bench::new();
    bench.bake_cube();
    bench.write("half.f32", [0; 18]);

    bench.run_with_input("query cube.nfd", b"0 0 0\n0 0\n").fails(3, &["line 2", "x y z"]);
    bench.run("query cube.nfd --points half.f32 -o out.f32").fails(3, &["half.f32"]);
    bench.run("query cube.nfd --points missing.f32 -o out.f32").fails(3, &["missing.f32"]);
    bench.run("bench cube.nfd --points half.f32").fails(3, &["half.f32"]);
    assert!(!bench.path("out.f32").exists(), "no partial file");
}

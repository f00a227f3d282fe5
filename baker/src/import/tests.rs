//! Files in every dialect, and files that are wrong in every way.

use super::*;

const CUBE_VERTICES: &str = "v 0 0 0\nv 0 0 1\nv 0 1 0\nv 0 1 1\nv 1 0 0\nv 1 0 1\nv 1 1 0\nv 1 1 1\n";
const CUBE_QUADS: [[usize; 4]; 6] =
    [[1, 2, 4, 3], [5, 7, 8, 6], [1, 5, 6, 2], [3, 4, 8, 7], [1, 3, 7, 5], [2, 6, 8, 4]];

fn cube(face: impl Fn([usize; 4]) -> String) -> String {
    CUBE_VERTICES.to_owned() + &CUBE_QUADS.map(face).concat()
}

fn plain_cube() -> TriangleSoup {
    obj::parse(cube(|[a, b, c, d]| format!("f {a} {b} {c} {d}\n")).as_bytes()).unwrap()
}

#[track_caller]
fn expect_cube(text: &str) {
    assert_eq!(obj::parse(text.as_bytes()).unwrap(), plain_cube());
}

#[track_caller]
fn message(result: Result<TriangleSoup, Problem>) -> String {
    let message = result.expect_err("this file is wrong").to_string();
    assert!(!message.contains('\n'), "one sentence: {message}");
    message
}

#[test]
fn obj_quads_become_fans() {
    let soup = plain_cube();
    assert_eq!((soup.positions.len(), soup.triangles.len()), (8, 12));
    let [a, b, c] = soup.triangles[1].map(|vertex| soup.positions[vertex as usize]);
    assert_eq!([a, b, c], [DVec3::ZERO, DVec3::new(0.0, 1.0, 1.0), DVec3::new(0.0, 1.0, 0.0)]);
}

#[test]
fn obj_negative_indices_count_back() {
    expect_cube(&cube(|face| {
        let [a, b, c, d] = face.map(|index| index as i64 - 9);
        format!("f {a} {b} {c} {d}\n")
    }));
}

#[test]
fn obj_survives_crlf_comments_names_and_attributes() {
    let text = cube(|[a, b, c, d]| format!("g side  {a}\nf {a}/1/1 {b}//1 {c}/1 {d} # a quad\n"));
    let text = format!("\u{feff}# caf\u{e9}\nmtllib none.mtl\no cube\nvt 0 0\nvn 0 0 1\nusemtl m\ns off\n{text}");
    expect_cube(&text.replace('\n', "\r\n"));
}

#[test]
fn obj_names_may_be_in_any_encoding() {
    let mut bytes = b"o caf\xe9\n".to_vec();
    bytes.extend(cube(|[a, b, c, d]| format!("f {a} {b} {c} {d}\n")).bytes());
    assert_eq!(obj::parse(&bytes).unwrap(), plain_cube());
}

#[test]
fn obj_lines_may_be_continued_and_points_and_lines_are_no_faces() {
    expect_cube(&cube(|[a, b, c, d]| format!("f {a} {b} \\\n  {c} {d}\nl {a} {b} {c}\np {d}\n")));
}

#[test]
fn obj_colours_may_follow_some_vertices() {
    let text = cube(|[a, b, c, d]| format!("f {a} {b} {c} {d}\n"));
    expect_cube(&text.replacen("v 0 0 1\n", "v 0 0 1 1.0 0.5 0.25\n", 1));
}

#[test]
fn obj_weights_divide() {
    let text = cube(|[a, b, c, d]| format!("f {a} {b} {c} {d}\n"));
    expect_cube(&text.replacen("v 1 1 1\n", "v 2 2 2 2\n", 1));
}

#[test]
fn obj_index_out_of_range_names_the_line() {
    let said = message(obj::parse(b"v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 99\n"));
    assert!(said.contains("line 5 uses vertex index 99") && said.contains("3 vertices"), "{said}");
    for index in ["0", "-4", "-9223372036854775808", "9223372036854775807"] {
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 {index}\n");
        let said = message(obj::parse(text.as_bytes()));
        assert!(said.contains(index) && said.contains("line 4"), "{said}");
    }
}

#[test]
fn obj_nonsense_names_the_line() {
    for text in ["v 0 0 0\nv 1 oops 0\n", "v 0 0 0\nf 1 x 1\n", "v 0 0 0\nv 1\n"] {
        let said = message(obj::parse(text.as_bytes()));
        assert!(said.contains("OBJ: line 2"), "{said}");
    }
}

#[test]
fn vertices_must_be_finite() {
    for number in ["nan", "inf", "1e999"] {
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 {number} 0\nf 1 2 3\n");
        let said = message(obj::parse(text.as_bytes()));
        assert!(said.contains("which is no point"), "{said}");
    }
    let said = message(ply::parse(&binary_ply("little", f32::to_le_bytes, u32::to_le_bytes, f32::NAN)));
    assert!(said.contains("vertex 2 is (0, NaN, 0)"), "{said}");
}

#[test]
fn files_without_triangles_are_refused() {
    for text in ["", "# nothing\n", "v 0 0 0\n", "v 0 0 0\nv 1 1 1\nl 1 2\n"] {
        assert!(message(obj::parse(text.as_bytes())).contains("holds no triangles"), "{text:?}");
    }
    let empty = "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n";
    assert!(message(ply::parse(empty.as_bytes())).contains("holds no triangles"));
    let strips = "ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n0\n";
    assert!(message(ply::parse(strips.as_bytes())).contains("only triangle strips"));
}

const ASCII_PLY: &str = "ply\nformat ascii 1.0\ncomment c\nelement vertex 4\nproperty double x\n\
    property double y\nproperty double z\nproperty uchar red\nelement face 1\n\
    property list uchar uint vertex_index\nproperty int flags\nend_header\n\
    0 0 0 255\n1 0 0 255\n\n1 1 0 255\n0 1 0 255\n4 0 1 2 3 7\n";

#[test]
fn ascii_ply_reads_polygons_among_other_properties() {
    for text in [ASCII_PLY.to_owned(), ASCII_PLY.replace('\n', "\r\n"), ASCII_PLY.trim_end().to_owned()] {
        let soup = ply::parse(text.as_bytes()).unwrap();
        assert_eq!(soup.positions[2], DVec3::new(1.0, 1.0, 0.0));
        assert_eq!(soup.triangles, [[0, 1, 2], [0, 2, 3]]);
    }
}

fn binary_ply(endian: &str, float: fn(f32) -> [u8; 4], int: fn(u32) -> [u8; 4], y_of_last: f32) -> Vec<u8> {
    let mut bytes = format!(
        "ply\nformat binary_{endian}_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
         property float z\nelement face 1\nproperty list uchar uint vertex_indices\nend_header\n"
    )
    .into_bytes();
    for coordinate in [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, y_of_last, 0.0] {
        bytes.extend(float(coordinate));
    }
    bytes.push(3);
    for index in [0, 1, 2] {
        bytes.extend(int(index));
    }
    bytes
}

#[test]
fn binary_ply_reads_either_byte_order() {
    let little = ply::parse(&binary_ply("little", f32::to_le_bytes, u32::to_le_bytes, 1.0)).unwrap();
    let big = ply::parse(&binary_ply("big", f32::to_be_bytes, u32::to_be_bytes, 1.0)).unwrap();
    assert_eq!(little, big);
    assert_eq!((little.positions[2], little.triangles[0]), (DVec3::Y, [0, 1, 2]));
}

#[test]
fn every_truncation_of_a_ply_is_refused() {
    let binary = binary_ply("little", f32::to_le_bytes, u32::to_le_bytes, 1.0);
    for bytes in [&binary, ASCII_PLY.trim_end().as_bytes()] {
        // The last number of a text may lose digits unnoticed; it has one here.
        for length in 0..bytes.len() {
            message(ply::parse(&bytes[..length]));
        }
    }
    assert!(message(ply::parse(&binary[..binary.len() - 3])).contains("cut short"));
}

#[test]
fn a_lying_ply_header_is_refused_at_once() {
    for (from, to) in [
        ("vertex 4", "vertex 4000000000"),
        ("vertex 4", "vertex 18446744073709551615"),
        ("face 1", "face 4000000000"),
        ("end_header", "element nothing 18446744073709551615\nend_header"),
        ("4 0 1 2 3", "18446744073709551615 0 1 2 3"),
    ] {
        message(ply::parse(ASCII_PLY.replacen(from, to, 1).as_bytes()));
    }
    let mut bytes = b"ply\nformat binary_little_endian 1.0\nelement face 1\n\
        property list uint uint vertex_indices\nend_header\n"
        .to_vec();
    bytes.extend([0xff; 16]);
    assert!(message(ply::parse(&bytes)).contains("cut short"));
}

#[test]
fn ply_indices_are_checked() {
    for index in ["4", "4294967295"] {
        let said = message(ply::parse(ASCII_PLY.replacen("0 1 2 3", &format!("0 1 {index} 3"), 1).as_bytes()));
        assert!(said.contains(&format!("vertex index {index}, but there are 4")), "{said}");
    }
    let signed = ASCII_PLY.replace("uchar uint", "uchar int").replacen("0 1 2 3", "0 1 -1 3", 1);
    assert!(message(ply::parse(signed.as_bytes())).contains("face 0 uses vertex index -1"));
}

#[test]
fn the_content_decides_before_the_extension() {
    let folder = tempfile::tempdir().unwrap();
    let cube = cube(|[a, b, c, d]| format!("f {a} {b} {c} {d}\n"));
    for (name, content) in
        [("a.obj", &*cube), ("b.txt", &cube), ("c", &cube), ("d.OBJ", &cube), ("e.obj", ASCII_PLY), ("f", ASCII_PLY)]
    {
        let path = folder.path().join(name);
        fs::write(&path, content).unwrap();
        read(&path).unwrap_or_else(|error| panic!("{name}: {error}"));
    }

    let path = folder.path().join("g.stl");
    fs::write(&path, "solid nothing\nendsolid\n").unwrap();
    let error = read(&path).unwrap_err();
    assert!(matches!(error.problem, Problem::UnknownFormat), "{error}");
    assert!(error.to_string().contains("g.stl") && error.to_string().contains("OBJ, PLY"), "{error}");

    let missing = read(folder.path().join("missing.obj")).unwrap_err();
    assert!(matches!(missing.problem, Problem::Unreadable(_)), "{missing}");
}

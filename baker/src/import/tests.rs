//! Files in every dialect, and files that are wrong in every way.

use super::*;

fn parse_obj(bytes: &[u8]) -> Result<TriangleSoup, Problem> {
    obj::parse(bytes, &Selection::default())
}

const CUBE_VERTICES: &str = "v 0 0 0\nv 0 0 1\nv 0 1 0\nv 0 1 1\nv 1 0 0\nv 1 0 1\nv 1 1 0\nv 1 1 1\n";
const CUBE_QUADS: [[usize; 4]; 6] =
    [[1, 2, 4, 3], [5, 7, 8, 6], [1, 5, 6, 2], [3, 4, 8, 7], [1, 3, 7, 5], [2, 6, 8, 4]];

fn cube(face: impl Fn([usize; 4]) -> String) -> String {
    CUBE_VERTICES.to_owned() + &CUBE_QUADS.map(face).concat()
}

fn plain_cube() -> TriangleSoup {
    parse_obj(cube(|[a, b, c, d]| format!("f {a} {b} {c} {d}\n")).as_bytes()).unwrap()
}

#[track_caller]
fn expect_cube(text: &str) {
    assert_eq!(parse_obj(text.as_bytes()).unwrap(), plain_cube());
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
    assert_eq!(parse_obj(&bytes).unwrap(), plain_cube());
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
    let said = message(parse_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 99\n"));
    assert!(said.contains("line 5 uses vertex index 99") && said.contains("3 vertices"), "{said}");
    for index in ["0", "-4", "-9223372036854775808", "9223372036854775807"] {
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 {index}\n");
        let said = message(parse_obj(text.as_bytes()));
        assert!(said.contains(index) && said.contains("line 4"), "{said}");
    }
}

#[test]
fn obj_nonsense_names_the_line() {
    for text in ["v 0 0 0\nv 1 oops 0\n", "v 0 0 0\nf 1 x 1\n", "v 0 0 0\nv 1\n"] {
        let said = message(parse_obj(text.as_bytes()));
        assert!(said.contains("OBJ: line 2"), "{said}");
    }
}

#[test]
fn vertices_must_be_finite() {
    for number in ["nan", "inf", "1e999"] {
        let text = format!("v 0 0 0\nv 1 0 0\nv 0 {number} 0\nf 1 2 3\n");
        let said = message(parse_obj(text.as_bytes()));
        assert!(said.contains("which is no point"), "{said}");
    }
    let said = message(ply::parse(&binary_ply("little", f32::to_le_bytes, u32::to_le_bytes, f32::NAN)));
    assert!(said.contains("vertex 2 is (0, NaN, 0)"), "{said}");
}

#[test]
fn files_without_triangles_are_refused() {
    for text in ["", "# nothing\n", "v 0 0 0\n", "v 0 0 0\nv 1 1 1\nl 1 2\n"] {
        assert!(message(parse_obj(text.as_bytes())).contains("holds no triangles"), "{text:?}");
    }
    let empty = "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nend_header\n";
    assert!(message(ply::parse(empty.as_bytes())).contains("holds no triangles"));
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

const OFF_TRIANGLE: &str = "COFF 3 1 0 # counts\n0 0 0 255\n# comment\n1 0 0 255\n0 1 0 255\n3 0 1 2 0.5\n";

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

    let path = folder.path().join("g.dae");
    fs::write(&path, "<COLLADA/>\n").unwrap();
    let error = read(&path).unwrap_err();
    assert!(matches!(error.problem, Problem::UnknownFormat), "{error}");
    assert!(error.to_string().contains("g.dae") && error.to_string().contains("OBJ, STL"), "{error}");

    // An extension that lies, or says nothing.
    let triangle =
        "solid s\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";
    for (name, content) in [("h.obj", triangle), ("i.ply", OFF_TRIANGLE), ("j", OFF_TRIANGLE), ("k.stl", ASCII_PLY)] {
        let path = folder.path().join(name);
        fs::write(&path, content).unwrap();
        read(&path).unwrap_or_else(|error| panic!("{name}: {error}"));
    }

    let missing = read(folder.path().join("missing.obj")).unwrap_err();
    assert!(matches!(missing.problem, Problem::Unreadable(_)), "{missing}");
}

#[test]
fn ply_strips_alternate_and_restart() {
    let text = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
        element tristrips 1\nproperty list int int vertex_indices\nend_header\n\
        0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 4 -1 4 3 0\n";
    let soup = ply::parse(text.as_bytes()).unwrap();
    assert_eq!(soup.triangles, [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0]]);
    let said = message(ply::parse(text.replace("-1", "-2").as_bytes()));
    assert!(said.contains("tristrips 0 uses vertex index -2"), "{said}");
}

/// A square of two triangles and a square: words of counts, vertices of three coordinates and of `extra` words, faces.
fn binary_off(head: &str, extra: usize, colours: bool, word: impl Fn(u32) -> [u8; 4]) -> Vec<u8> {
    let mut words = vec![4, 2, 0];
    for [x, y] in [[0.0f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]] {
        words.extend([x, y, 0.5].map(f32::to_bits));
        words.extend(vec![7; extra]);
    }
    for face in [&[0, 1, 2][..], &[0, 1, 2, 3]] {
        words.push(face.len() as u32);
        words.extend(face);
        if colours {
            words.extend([1, 0]);
        }
    }
    [head.as_bytes(), words.into_iter().flat_map(word).collect::<Vec<u8>>().as_slice()].concat()
}

#[test]
fn binary_off_is_read_in_both_byte_orders_with_and_without_colours() {
    for (head, extra) in [("OFF BINARY\n", 0), ("NOFF BINARY\r\n", 3), ("STCNOFF BINARY\n", 9)] {
        for colours in [false, true] {
            for bytes in
                [binary_off(head, extra, colours, u32::to_be_bytes), binary_off(head, extra, colours, u32::to_le_bytes)]
            {
                let soup = off::parse(&bytes).unwrap();
                assert_eq!(soup.triangles, [[0, 1, 2], [0, 1, 2], [0, 2, 3]], "{head:?} {colours}");
                assert_eq!(soup.positions[2], DVec3::new(1.0, 1.0, 0.5));
                for cut in head.len()..bytes.len() {
                    // Without its colours a face may pass for two of a file without any.
                    if let Ok(rest) = off::parse(&bytes[..cut]) {
                        assert!(colours && rest != soup, "{head:?} cut at {cut}");
                    }
                }
            }
        }
    }
    let not_finite = binary_off("OFF BINARY\n", 0, false, |word| {
        if word == 0.5f32.to_bits() { f32::NAN.to_bits() } else { word }.to_be_bytes()
    });
    assert!(message(off::parse(&not_finite)).contains("vertex 0"));
}

#[test]
fn off_reads_counts_on_either_line_and_checks_indices() {
    let triangle = off::parse(OFF_TRIANGLE.as_bytes()).unwrap();
    assert_eq!((triangle.positions[1], &triangle.triangles[..]), (DVec3::X, &[[0, 1, 2]][..]));
    let quad = off::parse(b"OFF\r\n4 1 4\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n4 0 1 2 3").unwrap();
    assert_eq!(quad.triangles, [[0, 1, 2], [0, 2, 3]]);

    for (from, to, said) in [
        ("3 0 1 2", "3 0 1 3", "line 6 uses vertex index 3"),
        ("3 0 1 2", "3 0 1 -1", "vertex index -1"),
        ("1 0 0", "1 nan 0", "which is no point"),
        ("1 0 0", "1 0", "line 4: a vertex should have three coordinates"),
        ("COFF 3 1", "COFF 4000000000 1", "cut short"),
        ("COFF 3 1", "COFF 3 4000000000", "cut short: face 1 of 4000000000"),
        ("3 0 1 2", "4000000000 0 1 2", "line 6"),
        ("COFF", "4OFF", "not supported"),
        ("COFF 3 1", "COFF 3 0", "no triangles"),
    ] {
        let message = message(off::parse(OFF_TRIANGLE.replacen(from, to, 1).replace("1 0 255", "1 0").as_bytes()));
        assert!(message.contains(said), "{to}: {message}");
    }
}

/// Two triangles, each record with attribute bytes set.
fn binary_stl(header: &[u8]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, b' ');
    bytes.extend(2u32.to_le_bytes());
    for z in [0.0f32, 1.0] {
        for number in [0.0, 0.0, f32::NAN, 0.0, 0.0, z, 1.0, 0.0, z, 0.0, 1.0, z] {
            bytes.extend(number.to_le_bytes());
        }
        bytes.extend([0xff, 0xff]);
    }
    bytes
}

#[test]
fn binary_stl_may_start_with_solid() {
    for header in [&b"solid facet normal"[..], b"COLOR=", b""] {
        let soup = stl::parse(&binary_stl(header)).unwrap();
        assert_eq!((soup.positions.len(), soup.triangles.len()), (6, 2));
        assert_eq!(soup.positions[5], DVec3::new(0.0, 1.0, 1.0));
    }
}

#[test]
fn every_truncation_of_a_stl_is_refused() {
    let bytes = binary_stl(b"made by nobody");
    for length in 0..bytes.len() {
        assert!(message(stl::parse(&bytes[..length])).contains("cut short"), "{length}");
    }
    let ascii = b"solid s\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid";
    stl::parse(ascii).unwrap();
    for length in 0..ascii.len() {
        message(stl::parse(&ascii[..length]));
    }
}

#[test]
fn ascii_stl_tells_where_it_is_wrong() {
    let text = "solid vertex\rfacet\rOUTER LOOP\rvertex 0 0 0\rvertex 1 0 0\rvertex 0 1 0\rendloop\rendfacet\rendsolid vertex\r";
    assert_eq!(stl::parse(text.as_bytes()).unwrap().triangles, [[0, 1, 2]]);
    for (from, to, said) in [
        ("1 0 0", "1 0 inf", "a corner of triangle 0 is (1, 0, inf)"),
        ("1 0 0", "1 0", "a vertex is not three numbers"),
        ("vertex 1 0 0\r", "", "fewer than three"),
        ("endloop", "lopp", "out of place"),
        ("endsolid", "solid", "without endsolid"),
    ] {
        let message = message(stl::parse(text.replacen(from, to, 1).as_bytes()));
        assert!(message.contains(said), "{to}: {message}");
    }
}

#[test]
fn names_select_the_parts_of_an_obj() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no body\ng left side\nusemtl steel\nf 1 2 3\n\
        g right\nf 1 2 4\no wheel 1\nusemtl rubber\nf 2 3 4\n";
    let names = |with: &[&str], without: &[&str]| {
        let owned = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
        Names::new(&owned(with), &owned(without)).unwrap()
    };
    let count = |nodes: Names, materials: Names| {
        obj::parse(text.as_bytes(), &Selection { nodes, materials }).map(|soup| soup.triangles.len())
    };
    assert_eq!(count(names(&["body"], &[]), Names::default()).unwrap(), 2);
    assert_eq!(count(names(&["side"], &[]), Names::default()).unwrap(), 1);
    assert_eq!(count(names(&[], &["wheel*"]), Names::default()).unwrap(), 2);
    assert_eq!(count(Names::default(), names(&["{steel,rubber}"], &["rub*"])).unwrap(), 2);
    assert_eq!(count(names(&["right"], &[]), names(&["steel"], &[])).unwrap(), 1);
    let said = count(names(&["door"], &[]), Names::default()).unwrap_err().to_string();
    assert!(said.contains("body, left side, right, wheel 1") && said.contains("rubber, steel"), "{said}");
    assert!(Names::new(&["[".to_owned()], &[]).is_err());
}

#[test]
fn a_mesh_is_turned_then_scaled() {
    let mut positions = [DVec3::new(1.0, 2.0, 3.0)];
    let turned = |up, is_y_up| {
        let mut positions = positions;
        Placement { scale: 2.0, up }.apply(&mut positions, is_y_up).unwrap();
        positions[0].to_array()
    };
    assert_eq!(turned(None, false), [2.0, 4.0, 6.0]);
    assert_eq!(turned(Some(Up::Z), false), [2.0, -6.0, 4.0]);
    assert_eq!(turned(Some(Up::Z), true), [2.0, -6.0, 4.0]);
    assert_eq!(turned(Some(Up::Y), false), [2.0, 6.0, -4.0]);
    assert_eq!(turned(Some(Up::Y), true), [2.0, 4.0, 6.0]);
    assert!(Placement { scale: f64::MAX, up: None }.apply(&mut positions, false).is_err());
}

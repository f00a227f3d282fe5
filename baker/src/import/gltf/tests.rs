//! Scenes of one triangle, in every way that glTF knows to write it.

use super::super::{Names, inputs, read};
use super::buffers::BASE64;
use super::*;
use base64::Engine;
use glam::DVec3;
use serde_json::{Value, json};
use std::fs;

/// Corners (0, 0, 0), (1, 0, 0), (0, 1, 0) as f32, then the indices 0, 1, 2 as u16.
fn contents() -> Vec<u8> {
    let corners = [0.0f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0];
    let indices = [0u16, 1, 2].map(u16::to_le_bytes);
    [corners.map(f32::to_le_bytes).concat(), indices.concat()].concat()
}

fn scene() -> Value {
    json!({
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "part"}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"name": "steel"}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}
        ],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 6}],
        "buffers": [{"byteLength": 42}]
    })
}

fn glb(scene: &Value, contents: &[u8]) -> Vec<u8> {
    let mut text = scene.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut binary = contents.to_vec();
    binary.resize(binary.len().next_multiple_of(4), 0);
    let length = (28 + text.len() + binary.len()) as u32;
    let word = |word: usize| (word as u32).to_le_bytes();
    [
        MAGIC,
        &2u32.to_le_bytes(),
        &length.to_le_bytes(),
        &word(text.len()),
        CHUNK_JSON,
        &text,
        &word(binary.len()),
        CHUNK_BINARY,
        &binary,
    ]
    .concat()
}

fn parse_scene(scene: &Value) -> Result<TriangleSoup, Problem> {
    parse(&glb(scene, &contents()), Path::new(""), &Selection::default())
}

fn corners(soup: &TriangleSoup) -> Vec<DVec3> {
    soup.triangles.as_flattened().iter().map(|&vertex| soup.positions[vertex as usize]).collect()
}

const TRIANGLE: [DVec3; 3] = [DVec3::ZERO, DVec3::X, DVec3::Y];

#[track_caller]
fn expect_problem(change: impl FnOnce(&mut Value), said: &str) {
    let mut scene = scene();
    change(&mut scene);
    let message = parse_scene(&scene).expect_err("this scene is wrong").to_string();
    assert!(message.contains(said) && !message.contains('\n'), "{message}");
}

#[test]
fn a_binary_file_is_read() {
    assert_eq!(corners(&parse_scene(&scene()).unwrap()), TRIANGLE);
    let bytes = glb(&scene(), &contents());
    for length in 0..bytes.len() {
        assert!(parse(&bytes[..length], Path::new(""), &Selection::default()).is_err(), "{length}");
    }
}

#[test]
fn buffers_lie_beside_the_text_or_inside() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("part.gltf");
    let mut scene = scene();

    scene["buffers"][0]["uri"] = "two%20words.bin".into();
    fs::write(&path, scene.to_string()).unwrap();
    let missing = read(&path).unwrap_err().to_string();
    assert!(missing.contains("two words.bin cannot be read"), "{missing}");
    let buffer = folder.path().join("two words.bin");
    fs::write(&buffer, contents()).unwrap();
    assert_eq!(corners(&read(&path).unwrap()), TRIANGLE);
    assert_eq!(inputs(&path).unwrap(), [path.clone(), buffer.clone()]);
    fs::write(&buffer, &contents()[1..]).unwrap();
    assert!(read(&path).unwrap_err().to_string().contains("cut short"));

    let data = BASE64.encode(contents());
    for data in [&data[..], data.trim_end_matches('=')] {
        scene["buffers"][0]["uri"] = format!("data:application/octet-stream;base64,{data}").into();
        fs::write(&path, scene.to_string()).unwrap();
        assert_eq!(corners(&read(&path).unwrap()), TRIANGLE);
    }
    assert_eq!(inputs(&path).unwrap(), std::slice::from_ref(&path));

    for place in ["https://example.org/a.bin", "/dev/zero", "C:\\a.bin", "", "data:;base64,%%%%", "."] {
        scene["buffers"][0]["uri"] = place.into();
        fs::write(&path, scene.to_string()).unwrap();
        let message = read(&path).unwrap_err().to_string();
        assert!(!message.contains('\n'), "{place}: {message}");
    }
}

#[test]
fn nodes_move_what_is_below_them_and_mirrors_turn_it_over() {
    let mut scene = scene();
    scene["nodes"] = json!([
        {"children": [1, 2], "scale": [2, 2, 2]},
        {"mesh": 0, "translation": [1, 0, 0]},
        {"mesh": 0, "matrix": [-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]}
    ]);
    let [x, y] = [DVec3::X, DVec3::Y].map(|axis| 2.0 * axis);
    let expected = [x, 2.0 * x, x + y, DVec3::ZERO, y, -x];
    assert_eq!(corners(&parse_scene(&scene).unwrap()), expected);

    scene.as_object_mut().unwrap().remove("scenes");
    assert_eq!(corners(&parse_scene(&scene).unwrap()), expected);
}

#[test]
fn positions_may_be_quantized_or_sparse() {
    let mut quantized = scene();
    quantized["accessors"][0] =
        json!({"bufferView": 0, "componentType": 5120, "normalized": true, "count": 3, "type": "VEC3"});
    quantized["bufferViews"][0] = json!({"buffer": 0, "byteLength": 12, "byteStride": 4});
    quantized["extensionsRequired"] = json!(["KHR_mesh_quantization"]);
    let mut bytes = contents();
    bytes[..12].copy_from_slice(&[0, 0, 0, 99, 127, 0, 0, 99, 0, 129, 0, 99]);
    let soup = parse(&glb(&quantized, &bytes), Path::new(""), &Selection::default()).unwrap();
    assert_eq!(corners(&soup), [DVec3::ZERO, DVec3::X, -DVec3::Y]);

    // Zeros, but for vertices 1 and 2: indices 1 and 2 of the index buffer, values from the positions.
    let mut sparse = scene();
    sparse["accessors"][0] = json!({
        "componentType": 5126, "count": 3, "type": "VEC3",
        "sparse": {
            "count": 2,
            "indices": {"bufferView": 1, "byteOffset": 2, "componentType": 5123},
            "values": {"bufferView": 0, "byteOffset": 12}
        }
    });
    assert_eq!(corners(&parse_scene(&sparse).unwrap()), TRIANGLE);
}

#[test]
fn names_of_nodes_hold_for_what_is_below() {
    let mut scene = scene();
    scene["nodes"] = json!([{"children": [1, 2], "name": "car"}, {"mesh": 0, "name": "door"}, {"mesh": 0}]);
    let count = |nodes: &[&str], without: &[&str]| {
        let owned = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
        let nodes = Names::new(&owned(nodes), &owned(without)).unwrap();
        let selection = Selection { nodes, ..Selection::default() };
        parse(&glb(&scene, &contents()), Path::new(""), &selection).map(|soup| soup.triangles.len())
    };
    assert_eq!(count(&["car"], &[]).unwrap(), 2);
    assert_eq!(count(&["car"], &["door"]).unwrap(), 1);
    assert_eq!(count(&["d*"], &[]).unwrap(), 1);
    let said = count(&["boat"], &[]).unwrap_err().to_string();
    assert!(said.contains("car, door") && said.contains("steel"), "{said}");
}

#[test]
fn strips_and_fans_become_triangles_and_points_vanish() {
    let mut scene = scene();
    for mode in [5, 6] {
        scene["meshes"][0]["primitives"][0]["mode"] = mode.into();
        assert_eq!(corners(&parse_scene(&scene).unwrap()), TRIANGLE);
    }
    expect_problem(|scene| scene["meshes"][0]["primitives"][0]["mode"] = 1.into(), "no triangles");
    expect_problem(|scene| scene["meshes"][0]["primitives"][0]["mode"] = 7.into(), "mode 7");
}

#[test]
fn what_is_wrong_is_said() {
    expect_problem(|scene| scene["asset"]["version"] = "1.0".into(), "version 1.0");
    expect_problem(|scene| scene["nodes"][0]["children"] = json!([0]), "node 0 is in the scene twice");
    expect_problem(|scene| scene["nodes"][0]["mesh"] = 7.into(), "mesh 7 is not there");
    expect_problem(|scene| scene["scene"] = 1.into(), "scene 1 is not there");
    expect_problem(|scene| scene["accessors"][0]["count"] = 4.into(), "leaves buffer view 0");
    expect_problem(|scene| scene["accessors"][0]["count"] = u64::MAX.into(), "leaves buffer view 0");
    expect_problem(|scene| scene["accessors"][0]["componentType"] = 1.into(), "component type 1");
    expect_problem(|scene| scene["accessors"][0]["count"] = 2.into(), "uses vertex index 2");
    expect_problem(|scene| scene["bufferViews"][0]["byteOffset"] = 40.into(), "leaves its buffer");
    expect_problem(|scene| scene["bufferViews"][0]["byteStride"] = 4.into(), "overlap");
    expect_problem(|scene| scene["buffers"][0]["byteLength"] = 99.into(), "cut short");
    let scales = json!([{"children": [1], "scale": [1e200, 1, 1]}, {"mesh": 0, "scale": [1e200, 1, 1]}]);
    expect_problem(|scene| scene["nodes"] = scales, "which is no point");
    expect_problem(|scene| scene["extensionsRequired"] = json!(["KHR_draco_mesh_compression"]), "KHR_draco");
    expect_problem(
        |scene| {
            let accessor = &mut scene["accessors"][0];
            accessor["bufferView"] = Value::Null;
            accessor["count"] = 4_000_000_000u64.into();
        },
        "accessor 0 has no data",
    );
}

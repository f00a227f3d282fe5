//! No mesh file hurts the importers.

use nearfield_bake::import;
use nearfield_bake::mesh::CheckedMesh;
use std::fs;
use std::sync::LazyLock;
use tempfile::TempDir;

/// The first byte chooses.
const EXTENSIONS: [&str; 7] = ["obj", "ply", "stl", "off", "gltf", "glb", "mesh"];

static FOLDER: LazyLock<TempDir> = LazyLock::new(|| tempfile::tempdir().expect("a folder for meshes"));

/// The first byte chooses the extension, the others are the file: it is refused, or its triangles are what they should be.
pub fn import(bytes: &[u8]) {
    let Some((&choice, contents)) = bytes.split_first() else { return };
    let extension = EXTENSIONS[usize::from(choice) % EXTENSIONS.len()];
    let path = FOLDER.path().join(format!("mesh-{:?}.{extension}", std::thread::current().id()));
    fs::write(&path, contents).expect("the mesh is written");
    let Ok(soup) = import::read(&path) else { return };

    assert!(!soup.triangles.is_empty(), "an empty mesh was read");
    assert!(soup.positions.iter().all(|position| position.is_finite()), "a position is not finite");
    let count = soup.positions.len() as u32;
    assert!(soup.triangles.as_flattened().iter().all(|&index| index < count), "an index is out of range");

    if let Ok(mesh) = CheckedMesh::new(soup) {
        let positions = mesh.positions.len() as u32;
        assert!(mesh.triangles.as_flattened().iter().all(|&index| index < positions), "an index is out of range");
        let _volume = mesh.signed_volume();
    }
}

//! A field looks as the mesh that it was baked from: Bevy draws both, without a window, on a driver of Vulkan.

mod camera;

use bevy::mesh::VertexAttributeValues;
use bevy::prelude::*;
use bevy::render::storage::ShaderBuffer;
use camera::{HEIGHT, Picture, View, WIDTH, draw};
use nearfield::Family;
use nearfield_bevy::FieldAsset;
use nearfield_bevy::material::{FieldMaterial, FieldSurface, field_box};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

/// The command line of this repository, which bakes. Says aloud if it is not built.
fn baker() -> Option<PathBuf> {
    let repository = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let built = ["release", "debug"].map(|profile| repository.join("target").join(profile).join("nearfield"));
    let found = built.into_iter().find(|path| path.is_file());
    missing_unless(found.is_some(), "the command line is not built: cargo build --package nearfield-bake");
    found
}

fn has_vulkan() -> bool {
    let listed = fs::read_dir("/usr/share/vulkan/icd.d").is_ok_and(|mut drivers| drivers.next().is_some());
    let found = listed || env::var_os("VK_ICD_FILENAMES").is_some() || env::var_os("VK_DRIVER_FILES").is_some();
    missing_unless(found, "there is no driver of Vulkan; mesa-vulkan-drivers has one");
    found
}

fn missing_unless(found: bool, what: &str) {
    if !found {
        assert!(env::var("CI").as_deref() != Ok("true"), "{what}");
        eprintln!("SKIPPED: {what}");
    }
}

/// A torus as Bevy makes it, fine enough that the field is not smoother.
fn torus() -> Mesh {
    Torus { minor_radius: 0.35, major_radius: 1.0 }.mesh().minor_resolution(64).major_resolution(128).build()
}

/// A mesh in the OBJ format, rounded so that its seams close.
fn obj(mesh: &Mesh) -> String {
    let Some(VertexAttributeValues::Float32x3(positions)) = mesh.attribute(Mesh::ATTRIBUTE_POSITION) else {
        panic!("positions of three numbers")
    };
    let mut text = String::new();
    for [x, y, z] in positions {
        writeln!(text, "v {x:.5} {y:.5} {z:.5}").expect("a string takes all");
    }
    let corners: Vec<usize> = mesh.indices().expect("a mesh of triangles").iter().map(|index| index + 1).collect();
    for [a, b, c] in corners.as_chunks().0 {
        writeln!(text, "f {a} {b} {c}").expect("a string takes all");
    }
    text
}

fn bake(baker: &Path, folder: &Path, arguments: &[&str]) -> FieldAsset {
    let [mesh, field] = ["torus.obj", "torus.nfd"].map(|name| folder.join(name));
    fs::write(&mesh, obj(&torus())).expect("the mesh");
    let status =
        Command::new(baker).arg("bake").arg(mesh).arg("-o").arg(&field).arg("--quiet").args(arguments).status();
    assert!(status.expect("the command line starts").success(), "{arguments:?}");
    FieldAsset::new(fs::read(field).expect("the field")).expect("it is sound")
}

/// Moved, turned and scaled.
fn place() -> Transform {
    Transform::from_xyz(0.2, -0.1, 0.3)
        .with_rotation(Quat::from_euler(EulerRot::XYZ, 0.9, 0.4, 0.2))
        .with_scale(Vec3::splat(1.2))
}

fn clay() -> StandardMaterial {
    StandardMaterial {
        base_color: Color::srgb(0.8, 0.5, 0.3),
        perceptual_roughness: 0.8,
        ..StandardMaterial::default()
    }
}

/// A box that goes through the hole of the torus and its side: what is before what shows in the picture.
fn add_box(world: &mut World) {
    let mesh = world.resource_mut::<Assets<Mesh>>().add(Cuboid::new(2.2, 0.4, 1.1));
    let material =
        world.resource_mut::<Assets<StandardMaterial>>().add(StandardMaterial::from(Color::srgb(0.2, 0.4, 0.8)));
    world.spawn((Mesh3d(mesh), MeshMaterial3d(material), Transform::from_xyz(0.9, -0.2, 0.8)));
}

fn add_mesh(world: &mut World) {
    let mesh = world.resource_mut::<Assets<Mesh>>().add(torus());
    let material = world.resource_mut::<Assets<StandardMaterial>>().add(clay());
    world.spawn((Mesh3d(mesh), MeshMaterial3d(material), place()));
}

fn add_field(world: &mut World, asset: &FieldAsset) {
    let mesh = world.resource_mut::<Assets<Mesh>>().add(field_box(asset));
    let extension = FieldSurface::new(asset, &mut world.resource_mut::<Assets<ShaderBuffer>>());
    let material = world.resource_mut::<Assets<FieldMaterial>>().add(FieldMaterial { base: clay(), extension });
    world.spawn((Mesh3d(mesh), MeshMaterial3d(material), place()));
}

/// Mean difference of the channels, of 255, and the share of pixels with one of more than 32.
fn difference(one: &Picture, other: &Picture) -> (f64, f64) {
    let of = |(a, b): (&[u8; 3], &[u8; 3])| [0, 1, 2].map(|channel| f64::from(a[channel].abs_diff(b[channel])));
    let pairs: Vec<_> = one.iter().zip(other).filter(|pair| *pair.0 != one[0] || *pair.1 != other[0]).map(of).collect();
    assert!(pairs.len() > (WIDTH * HEIGHT / 5) as usize, "only {} pixels of more than background", pairs.len());
    let count = pairs.len() as f64;
    let far = pairs.iter().filter(|channels| channels.iter().any(|&channel| channel > 32.0)).count();
    (pairs.iter().flatten().sum::<f64>() / (3.0 * count), far as f64 / count)
}

#[test]
fn a_field_looks_as_its_mesh() {
    let (Some(baker), true) = (baker(), has_vulkan()) else { return };
    let folder = tempfile::tempdir().expect("a folder");
    let with_mesh = |world: &mut World| {
        add_box(world);
        add_mesh(world);
    };
    let meshes = [View::Perspective, View::Orthographic].map(|view| draw(view, with_mesh));
    let (without, _) = difference(&meshes[0], &draw(View::Perspective, add_box));
    assert!(without > 10.0, "the torus shows: {without}");

    for (family, view, arguments) in [
        (Family::Polynomial, View::Perspective, &["--error", "1e-4"][..]),
        (Family::Polynomial, View::Orthographic, &["--error", "1e-4"]),
        (Family::Octree, View::Perspective, &["--error", "1e-4", "--interpolant", "tricubic"]),
        (Family::Grid, View::Perspective, &["--layout", "grid", "--resolution", "64"]),
    ] {
        let asset = bake(&baker, folder.path(), arguments);
        assert_eq!(asset.field().header().family, family);
        let with_field = |world: &mut World| {
            add_box(world);
            add_field(world, &asset);
        };
        let (mean, far) = difference(&meshes[view as usize], &draw(view, with_field));
        println!("{family:?}, {view:?}: {mean:.3} of 255 from the mesh, {:.2} % of the pixels far", 100.0 * far);
        assert!(mean < 1.0 && far < 0.005, "{family:?}, {view:?}: {mean}, {far}");
    }
}

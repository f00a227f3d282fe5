//! Meshes of shapes whose signed distance has a formula.

use glam::DVec3;
use nearfield_bake::import::TriangleSoup;
use nearfield_bake::mesh::CheckedMesh;
use std::f64::consts::PI;

/// A mesh and the formula of what it approximates.
pub(crate) struct Shape {
    /// For messages.
    pub(crate) name: &'static str,
    /// The mesh.
    pub(crate) mesh: CheckedMesh,
    /// Signed distance to the shape itself.
    pub(crate) distance: Box<dyn Fn(DVec3) -> f64>,
    /// How far the mesh is from the shape, at most.
    pub(crate) chord_error: f64,
}

/// One of each.
pub(crate) fn all() -> Vec<Shape> {
    vec![
        cuboid("box", DVec3::new(1.0, 0.6, 0.3), 6),
        cuboid("plate", DVec3::new(0.5, 0.5, 1e-3), 8),
        cuboid("plate of a hundred-thousandth", DVec3::new(0.5, 0.5, 1e-5), 8),
        sphere(),
        torus(),
        capsule(),
        two_boxes(),
    ]
}

/// A sphere of radius 1.
pub(crate) fn sphere() -> Shape {
    let soup = surface([48, 96], [false, true], |[u, v]| spherical(PI * u, 2.0 * PI * v));
    Shape { name: "sphere", mesh: checked(soup), distance: Box::new(|p| p.length() - 1.0), chord_error: 2.2e-3 }
}

/// A box around the origin, its faces cut into squares.
pub(crate) fn cuboid(name: &'static str, half: DVec3, cuts: u32) -> Shape {
    Shape {
        name,
        mesh: checked(cuboid_soup(half, DVec3::ZERO, cuts)),
        distance: Box::new(move |p| distance_to_cuboid(p, half)),
        chord_error: 0.0,
    }
}

/// Two boxes apart.
pub(crate) fn two_boxes() -> Shape {
    let (half, small, far) = (DVec3::splat(0.5), DVec3::splat(0.3), DVec3::new(2.0, 0.0, 0.0));
    let mut soup = cuboid_soup(half, DVec3::ZERO, 3);
    append(&mut soup, cuboid_soup(small, far, 1));
    Shape {
        name: "two boxes",
        mesh: checked(soup),
        distance: Box::new(move |p| distance_to_cuboid(p, half).min(distance_to_cuboid(p - far, small))),
        chord_error: 0.0,
    }
}

fn torus() -> Shape {
    let (around, tube) = (1.0, 0.35);
    let soup = surface([96, 48], [true, true], |[u, v]| {
        let (u, v) = (2.0 * PI * u, 2.0 * PI * v);
        let radius = around + tube * v.cos();
        DVec3::new(radius * u.cos(), radius * u.sin(), tube * v.sin())
    });
    let distance = move |p: DVec3| (p.truncate().length() - around).hypot(p.z) - tube;
    Shape { name: "torus", mesh: checked(soup), distance: Box::new(distance), chord_error: 3e-3 }
}

fn capsule() -> Shape {
    let (radius, half_length) = (0.4, 0.7);
    // An even number of rings, and the middle one stretched into the cylinder.
    let soup = surface([41, 64], [false, true], |[u, v]| {
        let ring = (u * 41.0).round();
        let (ring, end) = if ring <= 20.0 { (ring, 1.0) } else { (ring - 1.0, -1.0) };
        radius * spherical(PI * ring / 40.0, 2.0 * PI * v) + end * half_length * DVec3::Z
    });
    let distance = move |p: DVec3| p.distance(DVec3::Z * p.z.clamp(-half_length, half_length)) - radius;
    Shape { name: "capsule", mesh: checked(soup), distance: Box::new(distance), chord_error: 2e-3 }
}

fn spherical(polar: f64, azimuth: f64) -> DVec3 {
    // The poles are one point each, whatever the sine of π is.
    if polar == 0.0 || polar == PI {
        return DVec3::Z * polar.cos();
    }
    DVec3::new(polar.sin() * azimuth.cos(), polar.sin() * azimuth.sin(), polar.cos())
}

/// A grid of squares over the unit square, bent into a surface; where it `wraps` the last vertices
/// are the first.
fn surface(counts: [u32; 2], wraps: [bool; 2], position: impl Fn([f64; 2]) -> DVec3) -> TriangleSoup {
    let [columns, rows] = [0, 1].map(|k| counts[k] + u32::from(!wraps[k]));
    let mut soup = TriangleSoup::default();
    for column in 0..columns {
        for row in 0..rows {
            soup.positions
                .push(position([f64::from(column) / f64::from(counts[0]), f64::from(row) / f64::from(counts[1])]));
        }
    }
    for column in 0..counts[0] {
        for row in 0..counts[1] {
            let vertex = |c: u32, r: u32| (c % columns) * rows + r % rows;
            let [a, b] = [vertex(column, row), vertex(column + 1, row)];
            let [c, d] = [vertex(column, row + 1), vertex(column + 1, row + 1)];
            soup.triangles.extend([[a, b, c], [c, b, d]]);
        }
    }
    soup
}

fn cuboid_soup(half: DVec3, centre: DVec3, cuts: u32) -> TriangleSoup {
    let mut soup = TriangleSoup::default();
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            append(
                &mut soup,
                surface([cuts; 2], [false; 2], |[u, v]| {
                    let (u, v) = if side > 0.0 { (u, v) } else { (v, u) };
                    let mut corner = [0.0; 3];
                    corner[axis] = side;
                    corner[(axis + 1) % 3] = 2.0 * u - 1.0;
                    corner[(axis + 2) % 3] = 2.0 * v - 1.0;
                    centre + half * DVec3::from_array(corner)
                }),
            );
        }
    }
    soup
}

fn distance_to_cuboid(point: DVec3, half: DVec3) -> f64 {
    let outside = point.abs() - half;
    outside.max(DVec3::ZERO).length() + outside.max_element().min(0.0)
}

fn append(soup: &mut TriangleSoup, other: TriangleSoup) {
    let base = soup.positions.len() as u32;
    soup.positions.extend(other.positions);
    soup.triangles.extend(other.triangles.iter().map(|triangle| triangle.map(|vertex| base + vertex)));
}

fn checked(soup: TriangleSoup) -> CheckedMesh {
    CheckedMesh::new(soup).expect("a shape has an area")
}

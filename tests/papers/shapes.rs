//! What is measured: the meshes and formulas of the papers, or what stands in for them.

use glam::DVec3;
use nearfield_bake::distance::{SignChoice, SignedDistance};
use nearfield_bake::field_function::{FieldFunction, Sample};
use nearfield_bake::import;
use nearfield_bake::mesh::CheckedMesh;
use std::path::Path;

/// A mesh within [-1, 1]³.
pub(crate) struct MeshShape {
    pub(crate) name: &'static str,
    /// Where it came from, in words.
    pub(crate) origin: &'static str,
    pub(crate) mesh: CheckedMesh,
    pub(crate) distance: SignedDistance,
}

pub(crate) struct Shapes {
    pub(crate) bunny: MeshShape,
    pub(crate) armadillo: MeshShape,
    /// Where the papers have a dragon.
    pub(crate) horse: MeshShape,
    /// An open room of sheets; there is no stand-in.
    pub(crate) sponza: Option<MeshShape>,
}

impl Shapes {
    pub(crate) fn read(folder: Option<&Path>) -> Self {
        let find = |name, file: &str, origin| {
            let path = folder.map(|folder| folder.join(file)).filter(|path| path.exists());
            let spot = Path::new(env!("CARGO_MANIFEST_DIR")).join("meshes/spot.ply");
            let (path, origin) = path.map_or((spot, "Spot, a stand-in"), |path| (path, origin));
            MeshShape::new(name, origin, &path)
        };
        Self {
            bunny: find("bunny", "stanford-bunny.obj", "the Stanford bunny of 69 451 triangles"),
            sponza: folder
                .map(|folder| folder.join("sponza.obj"))
                .filter(|path| path.exists())
                .map(|path| MeshShape::new("sponza", "Crytek's Sponza", &path)),
            horse: find("horse", "horse.ply", "the horse of 96 966 triangles, closed, of slender limbs"),
            armadillo: find("armadillo", "armadillo.obj", "an Armadillo of 86 482 triangles"),
        }
    }
}

impl MeshShape {
    fn new(name: &'static str, origin: &'static str, path: &Path) -> Self {
        let mut soup = import::read(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let bounds = nearfield_bake::geometry::Aabb::around(soup.positions.iter().copied());
        let (centre, scale) = (bounds.centre(), 2.0 / bounds.size().max_element());
        for position in &mut soup.positions {
            *position = (*position - centre) * scale;
        }
        let mesh = CheckedMesh::new(soup).expect("a mesh");
        let distance = SignedDistance::choose(&mesh, SignChoice::Auto).0;
        Self { name, origin, mesh, distance }
    }
}

/// A formula and its gradient.
pub(crate) struct Formula(pub(crate) fn(DVec3) -> Sample);

impl FieldFunction for Formula {
    fn sample(&self, point: DVec3) -> Sample {
        (self.0)(point)
    }
}

pub(crate) fn sphere(point: DVec3) -> Sample {
    Sample { distance: point.length() - 0.7, gradient: point.normalize_or(DVec3::X) }
}

pub(crate) fn torus(point: DVec3) -> Sample {
    let ring = point.with_y(0.0).normalize_or(DVec3::X) * 0.65;
    let offset = point - ring;
    Sample { distance: offset.length() - 0.3, gradient: offset.normalize_or(DVec3::Y) }
}

fn cuboid(point: DVec3, half: DVec3) -> Sample {
    let beyond = point.abs() - half;
    let sign = DVec3::ONE.copysign(point);
    if beyond.max_element() > 0.0 {
        let outside = beyond.max(DVec3::ZERO);
        return Sample { distance: outside.length(), gradient: outside.normalize() * sign };
    }
    let axis = DVec3::AXES.into_iter().max_by(|a, b| beyond.dot(*a).total_cmp(&beyond.dot(*b)));
    Sample { distance: beyond.max_element(), gradient: axis.unwrap_or(DVec3::X) * sign }
}

fn union(a: Sample, b: Sample) -> Sample {
    if a.distance <= b.distance { a } else { b }
}

/// A box with a ball on it and a torus around it.
pub(crate) fn scene_1(point: DVec3) -> Sample {
    let ball = point - DVec3::new(0.3, 0.55, 0.2);
    let ball = Sample { distance: ball.length() - 0.3, gradient: ball.normalize_or(DVec3::X) };
    union(union(cuboid(point + DVec3::Y * 0.2, DVec3::new(0.5, 0.35, 0.4)), ball), torus(point))
}

/// A ring of twelve small boxes around two crossed beams.
pub(crate) fn scene_2(point: DVec3) -> Sample {
    let beams = union(cuboid(point, DVec3::new(0.9, 0.08, 0.08)), cuboid(point, DVec3::new(0.08, 0.9, 0.08)));
    const RING: [[f64; 2]; 12] = [
        [0.7, 0.0],
        [0.606, 0.35],
        [0.35, 0.606],
        [0.0, 0.7],
        [-0.35, 0.606],
        [-0.606, 0.35],
        [-0.7, 0.0],
        [-0.606, -0.35],
        [-0.35, -0.606],
        [0.0, -0.7],
        [0.35, -0.606],
        [0.606, -0.35],
    ];
    let ring = RING.map(|[x, z]| cuboid(point - DVec3::new(x, 0.0, z), DVec3::new(0.1, 0.2, 0.06)));
    ring.into_iter().fold(beams, union)
}

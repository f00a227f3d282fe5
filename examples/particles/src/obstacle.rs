//! What particles collide with: a baked field, or the mesh that it was baked from.

use nearfield::{Aabb, Field};
use parry3d::math::Vector;
use parry3d::query::PointQuery;
use parry3d::shape::{TriMesh, TriMeshFlags};
use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{DefaultElement, Property};
use std::error::Error;
use std::fs::File;
use std::io::BufReader;
use std::path::Path;

/// A solid.
pub trait Obstacle {
    /// A box that holds it.
    fn bounds(&self) -> Aabb;

    /// How much its distance changes at most over a unit of length.
    fn steepest(&self) -> f32;

    /// Signed distances, negative inside, and their gradients, at points of the box.
    fn ask(&self, points: &[[f32; 3]], distances: &mut [f32], gradients: &mut [[f32; 3]]);
}

impl Obstacle for Field<'_> {
    fn bounds(&self) -> Aabb {
        self.header().bounds
    }

    fn steepest(&self) -> f32 {
        self.header().lipschitz
    }

    fn ask(&self, points: &[[f32; 3]], distances: &mut [f32], gradients: &mut [[f32; 3]]) {
        self.distances_and_gradients(points, distances, gradients);
    }
}

/// A mesh, with the closest triangle by the tree of bounding boxes of parry3d and the sign by its pseudonormals.
pub struct Exact {
    mesh: TriMesh,
    bounds: Aabb,
}

impl Exact {
    /// The mesh of a file, to be asked in the same box as its field.
    pub fn read(path: &Path, bounds: Aabb) -> Result<Self, Box<dyn Error>> {
        let ply = Parser::<DefaultElement>::new().read_ply(&mut BufReader::new(File::open(path)?))?;
        let elements = |name: &str| ply.payload.get(name).ok_or("not a mesh");
        let coordinate = |vertex: &DefaultElement, axis: &str| match vertex.get(axis) {
            Some(Property::Float(number)) => Ok(*number),
            _ => Err("coordinates are not floats"),
        };
        let point = |vertex| {
            let [x, y, z] = ["x", "y", "z"].map(|axis| coordinate(vertex, axis));
            Ok::<_, &str>(Vector::new(x?, y?, z?))
        };
        let vertices = elements("vertex")?.iter().map(point).collect::<Result<_, _>>()?;
        let triangle = |face: &DefaultElement| match face.get("vertex_indices") {
            Some(Property::ListInt(corners)) if corners.len() == 3 => {
                Ok([0, 1, 2].map(|corner: usize| corners[corner] as u32))
            }
            _ => Err("faces are not triangles"),
        };
        let triangles = elements("face")?.iter().map(triangle).collect::<Result<_, _>>()?;
        Ok(Self { mesh: TriMesh::with_flags(vertices, triangles, TriMeshFlags::ORIENTED)?, bounds })
    }

    /// Signed distance and gradient at a point.
    pub fn distance_and_gradient(&self, point: [f32; 3]) -> (f32, [f32; 3]) {
        let point = Vector::from(point);
        let closest = self.mesh.project_local_point(point, false);
        let away = point - closest.point;
        let (distance, sign) = (away.length(), if closest.is_inside { -1.0 } else { 1.0 });
        (sign * distance, (away * (sign / distance.max(f32::MIN_POSITIVE))).to_array())
    }
}

impl Obstacle for Exact {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn steepest(&self) -> f32 {
        1.0
    }

    fn ask(&self, points: &[[f32; 3]], distances: &mut [f32], gradients: &mut [[f32; 3]]) {
        for ((&point, distance), gradient) in points.iter().zip(distances).zip(gradients) {
            (*distance, *gradient) = self.distance_and_gradient(point);
        }
    }
}

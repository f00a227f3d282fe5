//! The other crates, behind one door.

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use bvh::point_query::PointDistance;
use glam::DVec3;
use nalgebra::Point3;
use nearfield_bake::mesh::CheckedMesh;
use parry3d::math::Vector;
use parry3d::query::PointQuery;
use parry3d::shape::{TriMesh, TriMeshFlags, Triangle};

/// A crate that tells how far a mesh is.
pub trait Peer {
    /// Name for the table.
    fn name(&self) -> &'static str;
    /// Whether its distances are negative inside.
    fn is_signed(&self) -> bool;
    /// Distance to the mesh, mesh units.
    fn distance(&self, point: DVec3) -> f64;
}

fn vector(point: DVec3) -> Vector {
    Vector::new(point.x as f32, point.y as f32, point.z as f32)
}

/// parry3d: a bounding volume hierarchy of boxes, pseudonormals.
pub struct Parry {
    mesh: TriMesh,
    is_signed: bool,
}

impl Parry {
    /// The closest point alone.
    pub fn unsigned(mesh: &CheckedMesh) -> Option<Self> {
        Self::new(mesh, false)
    }

    /// With the sign; none if it takes no such mesh.
    pub fn signed(mesh: &CheckedMesh) -> Option<Self> {
        Self::new(mesh, true)
    }

    fn new(mesh: &CheckedMesh, is_signed: bool) -> Option<Self> {
        let positions = mesh.positions.iter().map(|&position| vector(position)).collect();
        let flags = if is_signed { TriMeshFlags::ORIENTED } else { TriMeshFlags::empty() };
        let mesh = TriMesh::with_flags(positions, mesh.triangles.clone(), flags).ok()?;
        Some(Self { mesh, is_signed })
    }
}

impl Peer for Parry {
    fn name(&self) -> &'static str {
        "parry3d 0.31.1"
    }

    fn is_signed(&self) -> bool {
        self.is_signed
    }

    fn distance(&self, point: DVec3) -> f64 {
        let point = vector(point);
        let found = self.mesh.project_local_point(point, false);
        let distance = f64::from((found.point - point).length());
        if self.is_signed && found.is_inside { -distance } else { distance }
    }
}

/// bvh, with the triangles of parry3d.
pub struct BvhCrate {
    tree: Bvh<f32, 3>,
    triangles: Vec<Leaf>,
}

struct Leaf {
    triangle: Triangle,
    node: usize,
}

impl Bounded<f32, 3> for Leaf {
    fn aabb(&self) -> Aabb<f32, 3> {
        let corners = [self.triangle.a, self.triangle.b, self.triangle.c];
        corners.iter().fold(Aabb::empty(), |aabb, corner| aabb.grow(&Point3::new(corner.x, corner.y, corner.z)))
    }
}

impl BHShape<f32, 3> for Leaf {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl PointDistance<f32, 3> for Leaf {
    fn distance_squared(&self, query: Point3<f32>) -> f32 {
        let query = Vector::new(query.x, query.y, query.z);
        (self.triangle.project_local_point(query, false).point - query).length_squared()
    }
}

impl BvhCrate {
    pub fn new(mesh: &CheckedMesh) -> Self {
        let leaf = |triangle| {
            let [a, b, c] = mesh.corners(triangle).map(vector);
            Leaf { triangle: Triangle::new(a, b, c), node: 0 }
        };
        let mut triangles: Vec<Leaf> = (0..mesh.triangles.len()).map(leaf).collect();
        Self { tree: Bvh::build(&mut triangles), triangles }
    }
}

impl Peer for BvhCrate {
    fn name(&self) -> &'static str {
        "bvh 0.13.0"
    }

    fn is_signed(&self) -> bool {
        false
    }

    fn distance(&self, point: DVec3) -> f64 {
        let query = vector(point);
        let nearest = self.tree.nearest_to(Point3::new(query.x, query.y, query.z), &self.triangles);
        nearest.map_or(f64::INFINITY, |(_, distance)| distance.into())
    }
}

//! A field back to triangles, by surface nets (Gibson 1998).

use fast_surface_nets::ndshape::{RuntimeShape, Shape};
use fast_surface_nets::{SurfaceNetsBuffer, surface_nets};
use glam::Vec3;
use nearfield::Field;
use rayon::prelude::*;

/// Triangles around everything where the distance is below an offset.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Isosurface {
    /// Mesh units, mesh frame.
    pub positions: Vec<[f32; 3]>,
    /// Unit normals at the positions, outward.
    pub normals: Vec<[f32; 3]>,
    /// Three indices a triangle, counter-clockwise from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// The surface where the distance is `offset`, from a lattice of `resolution` cells along the box's longest side.
///
/// Vertices are moved onto the surface along the gradient, by less than a cell. Sharp edges are rounded, parts thinner
/// than a cell are lost, and what lies outside the field's box is cut off, open.
pub fn isosurface(field: &Field<'_>, offset: f32, resolution: u32) -> Isosurface {
    let bounds = field.header().bounds;
    let (min, max) = (Vec3::from_array(bounds.min), Vec3::from_array(bounds.max));
    let cell = (max - min).max_element() / resolution as f32;
    let counts = ((max - min) / cell).ceil().to_array().map(|count| count as u32 + 1);

    // The lattice.
    let shape = RuntimeShape::<u32, 3>::new(counts);
    let place = |index: u32| min + cell * Vec3::from_array(shape.delinearize(index).map(|step| step as f32));
    let distances: Vec<f32> =
        (0..shape.size()).into_par_iter().map(|index| field.distance(place(index).to_array()) - offset).collect();

    // Its surface.
    let mut buffer = SurfaceNetsBuffer::default();
    surface_nets(&distances, &shape, [0; 3], counts.map(|count| count - 1), &mut buffer);

    // Onto the field's own.
    let onto = |position: &[f32; 3]| {
        let start = min + cell * Vec3::from_array(*position);
        let mut point = start;
        for _ in 0..3 {
            let (distance, gradient) = field.distance_and_gradient(point.to_array());
            let gradient = Vec3::from_array(gradient);
            point -= gradient * ((distance - offset) / gradient.length_squared().max(0.25));
        }
        // Near a kink the steps may run away: then the lattice knows better.
        let point = if point.distance(start) < cell { point } else { start };
        let (_, gradient) = field.distance_and_gradient(point.to_array());
        (point.to_array(), Vec3::from_array(gradient).normalize_or_zero().to_array())
    };
    let (positions, normals) = buffer.positions.par_iter().map(onto).unzip();
    let triangles = buffer.indices.chunks_exact(3).map(|corners| [corners[0], corners[1], corners[2]]).collect();
    Isosurface { positions, normals, triangles }
}

impl Isosurface {
    /// Binary little-endian PLY, with normals.
    pub fn to_ply(&self) -> Vec<u8> {
        let mut bytes = format!(
            "ply\nformat binary_little_endian 1.0\nelement vertex {}\n\
             property float x\nproperty float y\nproperty float z\n\
             property float nx\nproperty float ny\nproperty float nz\n\
             element face {}\nproperty list uchar uint vertex_indices\nend_header\n",
            self.positions.len(),
            self.triangles.len()
        )
        .into_bytes();
        for (position, normal) in self.positions.iter().zip(&self.normals) {
            bytes.extend(position.iter().chain(normal).flat_map(|number| number.to_le_bytes()));
        }
        for triangle in &self.triangles {
            bytes.push(3);
            bytes.extend(triangle.iter().flat_map(|vertex| vertex.to_le_bytes()));
        }
        bytes
    }

    /// Wavefront OBJ, with normals.
    pub fn to_obj(&self) -> Vec<u8> {
        let mut text = String::new();
        for [x, y, z] in &self.positions {
            text += &format!("v {x} {y} {z}\n");
        }
        for [x, y, z] in &self.normals {
            text += &format!("vn {x} {y} {z}\n");
        }
        for triangle in &self.triangles {
            let [a, b, c] = triangle.map(|vertex| vertex + 1);
            text += &format!("f {a}//{a} {b}//{b} {c}//{c}\n");
        }
        text.into_bytes()
    }

    /// Binary STL.
    pub fn to_stl(&self) -> Vec<u8> {
        let mut bytes = vec![0; 80];
        bytes.extend((self.triangles.len() as u32).to_le_bytes());
        for triangle in &self.triangles {
            let corners = triangle.map(|vertex| Vec3::from_array(self.positions[vertex as usize]));
            let normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize_or_zero();
            for vector in [normal].into_iter().chain(corners) {
                bytes.extend(vector.to_array().into_iter().flat_map(f32::to_le_bytes));
            }
            bytes.extend([0; 2]);
        }
        bytes
    }
}

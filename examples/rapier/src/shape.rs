//! What parry asks of every shape.

use crate::mass::mass_properties;
use nearfield::{Field, Raycast};
use rapier3d::math::{Pose, Real, Vector};
use rapier3d::parry::bounding_volume::{Aabb, BoundingSphere};
use rapier3d::parry::mass_properties::MassProperties;
use rapier3d::parry::query::{PointProjection, PointQuery, Ray, RayCast, RayIntersection};
use rapier3d::parry::shape::{FeatureId, Shape, ShapeType, TypedShape};
use std::f32::consts::FRAC_PI_4;

/// Most steps of a ray on its way out of the inside, as many as the reader takes on the way in.
const MAX_STEPS: usize = 512;

/// The inside of a field: a solid.
///
/// The file stays for as long as the program runs: embed it, or leak it once. Copies share it.
#[derive(Clone, Copy, Debug)]
pub struct FieldShape {
    field: Field<'static>,
}

impl FieldShape {
    /// The solid inside of a field, in the field's frame.
    pub fn new(field: Field<'static>) -> Self {
        Self { field }
    }

    /// The field.
    pub fn field(&self) -> &Field<'static> {
        &self.field
    }

    /// Where a ray leaves the inside: sphere tracing (Hart 1996) with the distance to the outside.
    fn way_out(&self, ray: &Ray, length: Real) -> Option<RayIntersection> {
        let direction = ray.dir.normalize();
        let header = self.field.header();
        let sides = Vector::from(header.bounds.max) - Vector::from(header.bounds.min);
        let near = sides.max_element() * 1e-6;

        let mut along = 0.0;
        for _ in 0..MAX_STEPS {
            let point = ray.origin + direction * along;
            let depth = -self.field.distance(point.into());
            if depth <= near {
                // Seen from within, the surface faces the ray.
                let normal = -Vector::from(self.field.normal(point.into()));
                return Some(RayIntersection::new(along / ray.dir.length(), normal, FeatureId::Unknown));
            }
            along += depth / header.lipschitz.max(1.0);
            if along > length {
                return None;
            }
        }
        None
    }
}

impl Shape for FieldShape {
    /// The box of the field, which is that of the mesh and the baker's margin around it.
    fn compute_local_aabb(&self) -> Aabb {
        let bounds = self.field.header().bounds;
        Aabb::new(bounds.min.into(), bounds.max.into())
    }

    fn compute_local_bounding_sphere(&self) -> BoundingSphere {
        self.compute_local_aabb().bounding_sphere()
    }

    fn clone_dyn(&self) -> Box<dyn Shape> {
        Box::new(*self)
    }

    /// None: bake the scaled mesh.
    fn scale_dyn(&self, _scale: Vector, _subdivisions: u32) -> Option<Box<dyn Shape>> {
        None
    }

    fn mass_properties(&self, density: Real) -> MassProperties {
        mass_properties(&self.field, density)
    }

    fn shape_type(&self) -> ShapeType {
        ShapeType::Custom
    }

    fn as_typed_shape(&self) -> TypedShape<'_> {
        TypedShape::Custom(self)
    }

    fn ccd_thickness(&self) -> Real {
        self.compute_local_aabb().half_extents().min_element()
    }

    fn ccd_angular_thickness(&self) -> Real {
        FRAC_PI_4
    }

    fn compute_aabb(&self, position: &Pose) -> Aabb {
        self.compute_local_aabb().transform_by(position)
    }
}

impl PointQuery for FieldShape {
    /// The end of a descent to the surface, near the closest point wherever the field is smooth.
    fn project_local_point(&self, point: Vector, solid: bool) -> PointProjection {
        let is_inside = self.contains_local_point(point);
        if is_inside && solid {
            return PointProjection::new(true, point);
        }
        PointProjection::new(is_inside, self.field.closest_point(point.into()).point.into())
    }

    fn project_local_point_and_get_feature(&self, point: Vector) -> (PointProjection, FeatureId) {
        (self.project_local_point(point, false), FeatureId::Unknown)
    }

    /// The field itself: nearer the truth than the length of a projection.
    fn distance_to_local_point(&self, point: Vector, solid: bool) -> Real {
        let distance = self.field.distance(point.into());
        if solid { distance.max(0.0) } else { distance }
    }

    fn contains_local_point(&self, point: Vector) -> bool {
        self.field.distance(point.into()) <= 0.0
    }
}

impl RayCast for FieldShape {
    fn cast_local_ray_and_get_normal(&self, ray: &Ray, most: Real, solid: bool) -> Option<RayIntersection> {
        let speed = ray.dir.length();
        if self.contains_local_point(ray.origin) {
            return if solid {
                Some(RayIntersection::new(0.0, Vector::ZERO, FeatureId::Unknown))
            } else {
                self.way_out(ray, most * speed)
            };
        }

        match self.field.raycast(ray.origin.into(), ray.dir.into(), most * speed, 0.0) {
            Raycast::Hit(hit) => {
                Some(RayIntersection::new(hit.distance / speed, hit.normal.into(), FeatureId::Unknown))
            }
            Raycast::Miss { .. } | Raycast::OutOfSteps { .. } => None,
        }
    }
}

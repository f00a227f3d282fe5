//! Which pairs of shapes this crate answers for.

use crate::contact::{Rounded, Touch, touches};
use crate::shape::FieldShape;
use rapier3d::math::{Pose, Real, Vector};
use rapier3d::parry::query::details::{ContactManifoldsWorkspace, NormalConstraints, ShapeCastOptions};
use rapier3d::parry::query::{
    ClosestPoints, Contact, ContactManifold, NonlinearRigidMotion, PersistentQueryDispatcher, QueryDispatcher,
    ShapeCastHit, ShapeDistance, ShapeIntersection, TrackedContact, TypedWorkspaceData, Unsupported, WorkspaceData,
};
use rapier3d::parry::shape::{PackedFeatureId, Shape};

/// Answers for pairs of a [`FieldShape`] and a ball or a capsule.
///
/// Chain it before the `DefaultQueryDispatcher`, which answers for all others.
#[derive(Clone, Copy, Debug, Default)]
pub struct FieldDispatcher;

/// A pair in the order field, other.
struct Pair<'a> {
    field: &'a FieldShape,
    other: Rounded,
    /// Takes the other's frame to the field's.
    pose: Pose,
    /// Whether the field was the second shape.
    flipped: bool,
}

impl<'a> Pair<'a> {
    fn of(pos12: &Pose, first: &'a dyn Shape, second: &'a dyn Shape) -> Result<Self, Unsupported> {
        let pair =
            |field: &'a dyn Shape, other: &'a dyn Shape| Some((field.as_shape::<FieldShape>()?, Rounded::of(other)?));
        if let Some((field, other)) = pair(first, second) {
            return Ok(Self { field, other, pose: *pos12, flipped: false });
        }
        let (field, other) = pair(second, first).ok_or(Unsupported)?;
        Ok(Self { field, other, pose: pos12.inverse(), flipped: true })
    }

    fn touches(&self, reach: Real) -> impl Iterator<Item = Touch> {
        touches(self.field.field(), &self.other, &self.pose, reach)
    }

    fn deepest(&self, reach: Real) -> Option<Touch> {
        self.touches(reach).min_by(|first, second| first.distance.total_cmp(&second.distance))
    }

    /// The direction out of the other shape, in its frame.
    fn other_normal(&self, touch: &Touch) -> Vector {
        self.pose.rotation.inverse() * -touch.normal
    }
}

impl QueryDispatcher for FieldDispatcher {
    fn intersection_test(
        &self,
        pos12: &Pose,
        g1: &dyn Shape,
        g2: &dyn Shape,
    ) -> Result<ShapeIntersection, Unsupported> {
        let pair = Pair::of(pos12, g1, g2)?;
        Ok(pair.touches(0.0).next().is_some().into())
    }

    fn distance(&self, pos12: &Pose, g1: &dyn Shape, g2: &dyn Shape) -> Result<ShapeDistance, Unsupported> {
        let deepest = Pair::of(pos12, g1, g2)?.deepest(Real::MAX).ok_or(Unsupported)?;
        Ok(deepest.distance.max(0.0).into())
    }

    fn contact(
        &self,
        pos12: &Pose,
        g1: &dyn Shape,
        g2: &dyn Shape,
        prediction: Real,
    ) -> Result<Option<Contact>, Unsupported> {
        let pair = Pair::of(pos12, g1, g2)?;
        Ok(pair.deepest(prediction).map(|touch| {
            let normal = pair.other_normal(&touch);
            let contact = Contact::new(touch.on_field, touch.on_other, touch.normal, normal, touch.distance);
            if pair.flipped { contact.flipped() } else { contact }
        }))
    }

    fn closest_points(&self, _: &Pose, _: &dyn Shape, _: &dyn Shape, _: Real) -> Result<ClosestPoints, Unsupported> {
        Err(Unsupported)
    }

    fn cast_shapes(
        &self,
        _: &Pose,
        _: Vector,
        _: &dyn Shape,
        _: &dyn Shape,
        _: ShapeCastOptions,
    ) -> Result<Option<ShapeCastHit>, Unsupported> {
        Err(Unsupported)
    }

    fn cast_shapes_nonlinear(
        &self,
        _: &NonlinearRigidMotion,
        _: &dyn Shape,
        _: &NonlinearRigidMotion,
        _: &dyn Shape,
        _: Real,
        _: Real,
        _: bool,
    ) -> Result<Option<ShapeCastHit>, Unsupported> {
        Err(Unsupported)
    }
}

impl<ManifoldData, ContactData> PersistentQueryDispatcher<ManifoldData, ContactData> for FieldDispatcher
where
    ManifoldData: Default + Clone,
    ContactData: Default + Copy,
{
    /// One manifold of one point for each touch: each has a normal of its own.
    fn contact_manifolds(
        &self,
        pos12: &Pose,
        g1: &dyn Shape,
        g2: &dyn Shape,
        prediction: Real,
        manifolds: &mut Vec<ContactManifold<ManifoldData, ContactData>>,
        workspace: &mut Option<ContactManifoldsWorkspace>,
    ) -> Result<(), Unsupported> {
        let pair = Pair::of(pos12, g1, g2)?;
        let mut count = 0;
        for touch in pair.touches(prediction) {
            if count == manifolds.len() {
                manifolds.push(ContactManifold::new());
            }
            fill(&mut manifolds[count], &touch, pair.other_normal(&touch), pair.flipped);
            count += 1;
        }
        manifolds.truncate(count);
        workspace.get_or_insert_with(|| Several.into());
        Ok(())
    }

    fn contact_manifold_convex_convex(
        &self,
        _: &Pose,
        _: &dyn Shape,
        _: &dyn Shape,
        _: Option<&dyn NormalConstraints>,
        _: Option<&dyn NormalConstraints>,
        _: Real,
        _: &mut ContactManifold<ManifoldData, ContactData>,
    ) -> Result<(), Unsupported> {
        Err(Unsupported)
    }
}

/// Tells rapier that the number of manifolds changes from step to step, as for the triangles of a mesh. It holds nothing.
#[derive(Clone, Copy)]
struct Several;

impl WorkspaceData for Several {
    fn as_typed_workspace_data(&self) -> TypedWorkspaceData<'_> {
        TypedWorkspaceData::Custom
    }

    fn clone_dyn(&self) -> Box<dyn WorkspaceData> {
        Box::new(*self)
    }
}

/// Puts a touch into a manifold, and keeps what the solver stored there in the last step.
fn fill<ManifoldData, ContactData: Default + Copy>(
    manifold: &mut ContactManifold<ManifoldData, ContactData>,
    touch: &Touch,
    other_normal: Vector,
    flipped: bool,
) {
    let anywhere = PackedFeatureId::UNKNOWN;
    let Touch { on_field, on_other, normal, distance } = *touch;
    let contact = TrackedContact::flipped(on_field, on_other, anywhere, anywhere, distance, flipped);
    match manifold.points.first_mut() {
        Some(point) => point.copy_geometry_from(contact),
        None => manifold.points.push(contact),
    }
    let [first, second] = if flipped { [other_normal, normal] } else { [normal, other_normal] };
    (manifold.local_n1, manifold.local_n2) = (first, second);
}

//! A torus around the z axis, whose distances are known: first its shape, then in a world of rapier.

use nearfield::Field;
use nearfield_bake::bake_function;
use nearfield_bake::field_function::Closure;
use nearfield_bake::geometry::Aabb;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Layout, Settings, Target};
use nearfield_rapier::{FieldDispatcher, FieldShape};
use rapier3d::math::{Pose, Real, Vector};
use rapier3d::parry::query::{
    DefaultQueryDispatcher, PersistentQueryDispatcher, PointQuery, QueryDispatcher, Ray, RayCast,
};
use rapier3d::parry::shape::{Ball, Capsule, Cuboid, Shape, SharedShape};
use rapier3d::prelude::*;
use std::f32::consts::PI;
use std::sync::LazyLock;

const MAJOR: Real = 1.0;
const MINOR: Real = 0.4;
/// Of the baked field, everywhere.
const ERROR: Real = 5e-3;

static TORUS: LazyLock<FieldShape> = LazyLock::new(|| {
    let distance = |point: glam::DVec3| {
        let around = point.truncate().length() - f64::from(MAJOR);
        (around * around + point.z * point.z).sqrt() - f64::from(MINOR)
    };
    let bounds = Aabb { min: glam::DVec3::new(-1.4, -1.4, -0.4), max: glam::DVec3::new(1.4, 1.4, 0.4) };
    let settings =
        Settings { error: Target::Relative(2e-4), samples: 10_000, layout: Layout::Octree, ..Settings::default() };
    let baked = bake_function(&Closure { distance, step: 1e-5 }, &bounds, &settings, &Silent).expect("a torus bakes");
    let field = Field::open(baked.bytes.leak()).expect("a baked field opens");
    assert!(field.contract().max_error() < ERROR, "the field is as good as the tests expect");
    FieldShape::new(field)
});

fn exact(point: Vector) -> Real {
    let around = point.truncate().length() - MAJOR;
    (around * around + point.z * point.z).sqrt() - MINOR
}

/// Points in and around the torus, in no order.
fn points() -> impl Iterator<Item = Vector> {
    let coordinate = |index: u32, base: u32| {
        // Van der Corput's sequence.
        let (mut left, mut value, mut unit) = (index, 0.0, 1.0 / base as Real);
        while left > 0 {
            value += unit * (left % base) as Real;
            (left, unit) = (left / base, unit / base as Real);
        }
        value
    };
    (1..2000).map(move |index| {
        let cube = Vector::new(coordinate(index, 2), coordinate(index, 3), coordinate(index, 5));
        (cube - 0.5) * Vector::new(3.2, 3.2, 1.4)
    })
}

#[test]
fn points_are_projected_to_the_surface() {
    for point in points() {
        let projection = TORUS.project_local_point(point, false);
        assert!(exact(projection.point).abs() < ERROR, "{point} is projected to the surface");
        // The descent need not end at the closest point, but along straight normals it does.
        let farther = (projection.point - point).length() - exact(point).abs();
        assert!(farther.abs() < 0.05, "{point} is projected to a near point: {farther} too far");
        if exact(point).abs() > ERROR {
            assert_eq!(projection.is_inside, exact(point) < 0.0, "{point}");
            assert_eq!(TORUS.contains_local_point(point), exact(point) < 0.0, "{point}");
        }
        if exact(point) < -ERROR {
            assert_eq!(TORUS.project_local_point(point, true).point, point, "a solid holds its points");
        }
    }
}

#[test]
fn rays_enter_and_leave() {
    let along = Ray::new(Vector::new(-1.6, 0.0, 0.0), Vector::new(2.0, 0.0, 0.0));
    let hit = TORUS.cast_local_ray_and_get_normal(&along, 10.0, true).expect("it hits from outside");
    assert!((hit.time_of_impact - 0.1).abs() < ERROR, "times are in lengths of the direction");
    assert!((hit.normal - Vector::NEG_X).length() < 0.05, "the normal faces the ray");
    assert!(TORUS.cast_local_ray(&along, 0.05, true).is_none(), "the ray ends before");

    let within = Ray::new(Vector::new(-1.0, 0.0, 0.0), Vector::new(0.0, 0.0, 2.0));
    assert_eq!(TORUS.cast_local_ray(&within, 10.0, true), Some(0.0), "a solid is hit at once");
    let out = TORUS.cast_local_ray_and_get_normal(&within, 10.0, false).expect("a hollow is hit from within");
    assert!((out.time_of_impact - MINOR / 2.0).abs() < ERROR);
    assert!((out.normal - Vector::NEG_Z).length() < 0.05, "the normal faces the ray from within");
    assert!(TORUS.cast_local_ray(&within, 0.1, false).is_none(), "the ray ends within");

    let through = Ray::new(Vector::new(0.0, 0.0, -0.5), Vector::Z);
    assert!(TORUS.cast_local_ray(&through, 10.0, true).is_none(), "through the hole");
}

#[test]
fn mass_and_inertia_are_those_of_a_torus() {
    let properties = TORUS.mass_properties(2.0);
    let mass = 2.0 * 2.0 * PI * PI * MAJOR * MINOR * MINOR;
    let axis = mass * (MAJOR * MAJOR + 0.75 * MINOR * MINOR);
    let across = mass * (0.5 * MAJOR * MAJOR + 0.625 * MINOR * MINOR);

    assert!((properties.mass() / mass - 1.0).abs() < 2e-3, "{} against {mass}", properties.mass());
    assert!(properties.local_com.length() < 1e-3, "its centre is at {}", properties.local_com);
    let inertia = properties.reconstruct_inertia_matrix();
    for (column, expected) in [across, across, axis].into_iter().enumerate() {
        let found = inertia.col(column)[column];
        assert!((found / expected - 1.0).abs() < 5e-3, "{found} against {expected} about axis {column}");
    }
}

#[test]
fn balls_and_capsules_touch_where_they_should() {
    let ball = Ball::new(0.25);
    for centre in points() {
        let pose = Pose::from_translation(centre);
        let contact = FieldDispatcher.contact(&pose, &*TORUS, &ball, 0.1).expect("a ball is covered");
        let expected = exact(centre) - ball.radius;
        let Some(contact) = contact else {
            assert!(expected > 0.1 - ERROR, "{centre} is {expected} away, and that is near");
            continue;
        };
        assert!((contact.dist - expected).abs() < ERROR, "{centre}: {} against {expected}", contact.dist);
        assert!(exact(contact.point1).abs() < 0.1, "{} is near the surface", contact.point1);
        assert!((contact.point2.length() - ball.radius).abs() < 1e-4, "{} is on the ball", contact.point2);

        // The pair in the other order says the same the other way round.
        let flipped = FieldDispatcher.contact(&pose.inverse(), &ball, &*TORUS, 0.1).expect("in any order");
        let flipped = flipped.expect("the same contact");
        assert_eq!(flipped.dist, contact.dist);
        assert_eq!((flipped.point1, flipped.point2), (contact.point2, contact.point1));
    }

    // A rod over the tube touches it between its ends.
    let rod = Capsule::new(Vector::new(0.2, 0.0, 0.0), Vector::new(1.8, 0.0, 0.0), 0.1);
    let pose = Pose::from_translation(Vector::new(0.0, 0.0, 0.5));
    let contact = FieldDispatcher.contact(&pose, &*TORUS, &rod, 0.05).expect("a capsule is covered");
    let contact = contact.expect("it lies on the ring");
    assert!(contact.dist.abs() < ERROR, "the deepest point is found: {}", contact.dist);
    assert!((contact.point2 - Vector::new(1.0, 0.0, -0.1)).length() < 0.1, "above the ring: {}", contact.point2);
    let gap = FieldDispatcher.distance(&pose, &*TORUS, &rod).expect("a capsule is covered");
    assert!(gap.distance < ERROR);
    let test = |z| FieldDispatcher.intersection_test(&Pose::from_translation(Vector::Z * z), &*TORUS, &rod);
    assert!(test(0.45).expect("a capsule is covered").intersecting);
    assert!(!test(0.55).expect("a capsule is covered").intersecting);

    // A rod across the ring touches it twice, at neither end.
    let rod = Capsule::new(Vector::new(-1.9, 0.0, 0.0), Vector::new(1.9, 0.0, 0.0), 0.1);
    let mut manifolds: Vec<ContactManifold> = Vec::new();
    FieldDispatcher
        .contact_manifolds(&pose, &*TORUS, &rod, 0.05, &mut manifolds, &mut None)
        .expect("a capsule is covered");
    let mut places: Vec<Real> = manifolds.iter().map(|manifold| manifold.points[0].local_p2.x).collect();
    places.sort_by(Real::total_cmp);
    assert_eq!(places.len(), 2, "{places:?}");
    assert!((places[0] + 1.0).abs() < 0.05 && (places[1] - 1.0).abs() < 0.05, "{places:?}");
}

#[test]
fn other_shapes_are_left_to_others() {
    let cube = Cuboid::new(Vector::splat(0.1));
    assert!(FieldDispatcher.contact(&Pose::IDENTITY, &*TORUS, &cube, 0.1).is_err());
    let chain = FieldDispatcher.chain(DefaultQueryDispatcher);
    let ball = Ball::new(0.1);
    assert!(chain.contact(&Pose::IDENTITY, &cube, &ball, 0.1).expect("parry knows these").is_some());
    let mut manifolds: Vec<ContactManifold> = Vec::new();
    let first = Pose::from_translation(Vector::new(1.0, 0.0, 0.45));
    chain.contact_manifolds(&first, &*TORUS, &ball, 0.1, &mut manifolds, &mut None).expect("a ball is covered");
    assert_eq!(manifolds.len(), 1, "one touch");
    let away = Pose::from_translation(Vector::new(1.0, 0.0, 0.7));
    chain.contact_manifolds(&away, &*TORUS, &ball, 0.1, &mut manifolds, &mut None).expect("a ball is covered");
    assert!(manifolds.iter().all(|manifold| manifold.points.is_empty()), "none any more");
}

/// A world with gravity along z, and what it takes to step it.
struct World {
    bodies: RigidBodySet,
    colliders: ColliderSet,
    pipeline: PhysicsPipeline,
    islands: IslandManager,
    broad_phase: DefaultBroadPhase,
    narrow_phase: NarrowPhase,
    joints: ImpulseJointSet,
    multibody_joints: MultibodyJointSet,
    ccd: CCDSolver,
    soft_bodies: SoftBodySet,
}

impl World {
    fn new() -> Self {
        Self {
            bodies: RigidBodySet::new(),
            colliders: ColliderSet::new(),
            pipeline: PhysicsPipeline::new(),
            islands: IslandManager::new(),
            broad_phase: DefaultBroadPhase::new(),
            narrow_phase: NarrowPhase::with_query_dispatcher(FieldDispatcher.chain(DefaultQueryDispatcher)),
            joints: ImpulseJointSet::new(),
            multibody_joints: MultibodyJointSet::new(),
            ccd: CCDSolver::new(),
            soft_bodies: SoftBodySet::new(),
        }
    }

    fn add(&mut self, body: RigidBodyBuilder, collider: ColliderBuilder) -> RigidBodyHandle {
        let body = self.bodies.insert(body);
        self.colliders.insert_with_parent(collider.restitution(0.0).friction(0.5), body, &mut self.bodies);
        body
    }

    fn step(&mut self, steps: usize) {
        for _ in 0..steps {
            self.pipeline.step(
                Vector::new(0.0, 0.0, -9.81),
                &IntegrationParameters::default(),
                &mut self.islands,
                &mut self.broad_phase,
                &mut self.narrow_phase,
                &mut self.bodies,
                &mut self.colliders,
                &mut self.joints,
                &mut self.multibody_joints,
                &mut self.soft_bodies,
                &mut self.ccd,
                &(),
                &(),
            );
        }
    }
}

fn torus() -> ColliderBuilder {
    ColliderBuilder::new(SharedShape::new(*TORUS))
}

#[test]
fn a_ball_comes_to_rest_in_the_hole() {
    let mut world = World::new();
    world.add(RigidBodyBuilder::fixed(), torus());
    let radius = 0.7;
    let ball = world.add(
        RigidBodyBuilder::dynamic().translation(Vector::new(0.05, 0.02, 1.2)),
        ColliderBuilder::ball(radius).density(1.0),
    );
    world.step(600);

    let ball = &world.bodies[ball];
    let centre = ball.translation();
    let expected = ((MINOR + radius) * (MINOR + radius) - MAJOR * MAJOR).sqrt();
    assert!(
        (centre - Vector::new(0.0, 0.0, expected)).length() < 0.02,
        "it rests at {centre}, not at height {expected}"
    );
    assert!(ball.linvel().length() < 0.02, "it rests: {}", ball.linvel());
    assert!(exact(centre) - radius > -0.01, "it sinks in by {}", radius - exact(centre));
}

#[test]
fn a_capsule_comes_to_rest_across_the_ring() {
    let mut world = World::new();
    world.add(RigidBodyBuilder::fixed(), torus());
    let rod = world.add(
        RigidBodyBuilder::dynamic().translation(Vector::new(0.0, 0.0, 0.8)).angular_damping(1.0),
        ColliderBuilder::capsule_x(1.4, 0.1).density(1.0),
    );
    world.step(600);

    let rod = &world.bodies[rod];
    let axis = rod.rotation() * Vector::X;
    assert!(axis.z.abs() < 0.02, "it lies level: {axis}");
    assert!((rod.translation().z - (MINOR + 0.1)).abs() < 0.02, "it lies on the ring: {}", rod.translation());
    assert!(rod.linvel().length() < 0.02 && rod.angvel().length() < 0.05, "it lies still");
}

#[test]
fn a_field_falls_onto_balls_and_lies_still() {
    let mut world = World::new();
    for turn in 0..3 {
        let angle = 2.0 * PI * turn as Real / 3.0;
        let place = Vector::new(MAJOR * angle.cos(), MAJOR * angle.sin(), 0.0);
        world.add(RigidBodyBuilder::fixed().translation(place), ColliderBuilder::ball(0.3));
    }
    let ring = world.add(
        RigidBodyBuilder::dynamic().translation(Vector::new(0.0, 0.0, 1.0)).angular_damping(1.0),
        torus().density(1.0),
    );
    let mass = 2.0 * PI * PI * MAJOR * MINOR * MINOR;
    world.step(300);

    let ring = &world.bodies[ring];
    assert!((ring.mass() / mass - 1.0).abs() < 2e-3, "it weighs what a torus does: {}", ring.mass());
    assert!((ring.translation().z - (MINOR + 0.3)).abs() < 0.02, "it lies on the balls: {}", ring.translation());
    assert!((ring.rotation() * Vector::Z).z > 0.999, "it lies level");
    assert!(ring.linvel().length() < 0.02, "it lies still: {}", ring.linvel());
}

#[test]
fn a_ray_through_the_world_meets_the_field() {
    let mut world = World::new();
    let body =
        RigidBodyBuilder::fixed().translation(Vector::new(5.0, 0.0, 0.0)).rotation(Vector::new(0.0, PI / 2.0, 0.0));
    world.add(body, torus());
    world.step(1);

    let pipeline = world.broad_phase.as_query_pipeline(
        world.narrow_phase.query_dispatcher(),
        &world.bodies,
        &world.colliders,
        QueryFilter::default(),
    );
    // The ring stands upright: its tube is above the centre.
    let ray = Ray::new(Vector::new(0.0, 0.0, MAJOR), Vector::X);
    let (_, time) = pipeline.cast_ray(&ray, 100.0, true).expect("it hits the tube");
    assert!((time - (5.0 - MINOR)).abs() < ERROR, "at {time}");
    let middle = Ray::new(Vector::ZERO, Vector::X);
    assert!(pipeline.cast_ray(&middle, 100.0, true).is_none(), "through the hole");
}

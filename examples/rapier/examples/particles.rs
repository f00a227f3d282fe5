//! Particles rain on Spot: first on her field, then on her triangles. Prints what a step costs and how deep they sink.
//!
//!     cargo run --release --manifest-path examples/rapier/Cargo.toml --example particles [PARTICLES]

use nearfield::Field;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Layout, Settings, Target};
use nearfield_rapier::{FieldDispatcher, FieldShape};
use rapier3d::math::{Real, Vector};
use rapier3d::parry::query::{DefaultQueryDispatcher, QueryDispatcher};
use rapier3d::prelude::*;
use std::env;
use std::path::Path;
use std::time::{Duration, Instant};

const RADIUS: Real = 0.01;
/// Short steps: nothing sweeps the particles from one to the next.
const STEP: Real = 1.0 / 240.0;
const STEPS: usize = 600;

fn main() {
    let particles = env::args().nth(1).map_or(4000, |count| count.parse().expect("a number of particles"));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/meshes/spot.ply");
    let soup = nearfield_bake::import::read(path).expect("Spot is in the repository");
    let mesh = CheckedMesh::new(soup).expect("Spot is a mesh");

    let settings = Settings { error: Target::Relative(1e-3), layout: Layout::Octree, ..Settings::default() };
    let bytes = nearfield_bake::bake(&mesh, &settings, &Silent).expect("Spot bakes").bytes;
    println!(
        "{particles} particles, {STEPS} steps; a field of {} bytes, {} triangles",
        bytes.len(),
        mesh.triangles.len()
    );
    let field = Field::open(bytes.leak()).expect("a baked field opens");

    let vertices = mesh.positions.iter().map(|position| position.as_vec3().to_array().into()).collect();
    let triangles = ColliderBuilder::trimesh(vertices, mesh.triangles.clone()).expect("Spot is a mesh of parry too");
    rain("field", ColliderBuilder::new(SharedShape::new(FieldShape::new(field))), &field, particles);
    rain("triangles", triangles, &field, particles);
}

/// Lets particles, which do not touch one another, fall on a collider for some seconds.
fn rain(name: &str, collider: ColliderBuilder, field: &Field<'_>, particles: usize) {
    let mut bodies = RigidBodySet::new();
    let mut colliders = ColliderSet::new();
    colliders.insert(collider);
    let bounds = field.header().bounds;
    let (min, max) = (Vector::from(bounds.min), Vector::from(bounds.max));
    let side = (particles as f64).sqrt().ceil() as usize;
    for index in 0..particles {
        let share = [index % side, index / side].map(|at| (at as Real + 0.5) / side as Real);
        let place = Vector::new(share[0], 1.0, share[1]) * (max - min) + min;
        let body = bodies.insert(RigidBodyBuilder::dynamic().translation(place));
        let groups = InteractionGroups::new(Group::GROUP_1, Group::ALL - Group::GROUP_1, InteractionTestMode::And);
        colliders.insert_with_parent(ColliderBuilder::ball(RADIUS).collision_groups(groups), body, &mut bodies);
    }

    let mut pipeline = PhysicsPipeline::new();
    let mut islands = IslandManager::new();
    let mut broad_phase = DefaultBroadPhase::new();
    let mut narrow_phase = NarrowPhase::with_query_dispatcher(FieldDispatcher.chain(DefaultQueryDispatcher));
    let (mut joints, mut multibody_joints) = (ImpulseJointSet::new(), MultibodyJointSet::new());
    let (mut ccd, mut soft_bodies) = (CCDSolver::new(), SoftBodySet::new());
    let parameters = IntegrationParameters { dt: STEP, ..IntegrationParameters::default() };

    let mut elapsed = Duration::ZERO;
    let mut sunk: Real = 0.0;
    for _ in 0..STEPS {
        let start = Instant::now();
        pipeline.step(
            Vector::new(0.0, -9.81, 0.0),
            &parameters,
            &mut islands,
            &mut broad_phase,
            &mut narrow_phase,
            &mut bodies,
            &mut colliders,
            &mut joints,
            &mut multibody_joints,
            &mut soft_bodies,
            &mut ccd,
            &(),
            &(),
        );
        elapsed += start.elapsed();
        for (_, body) in bodies.iter() {
            sunk = sunk.max(RADIUS - field.distance(body.translation().into()));
        }
    }
    let milliseconds = elapsed.as_secs_f64() * 1e3 / STEPS as f64;
    println!("{name:<10} {milliseconds:.2} ms a step, the deepest sank in by {sunk:.4} (radius {RADIUS})");
}

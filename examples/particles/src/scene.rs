//! Particles that fall on obstacles, bounce off, and start again at the top.

use crate::obstacle::Obstacle;
use nearfield::Aabb;

/// Seconds of a frame.
const FRAME: f32 = 1.0 / 60.0;
/// Share of its speed that a particle keeps when it bounces.
const BOUNCE: f32 = 0.4;

#[derive(Clone)]
struct Particle {
    position: [f32; 3],
    velocity: [f32; 3],
}

/// Particles in a box.
pub struct Scene {
    particles: Vec<Particle>,
    min: [f32; 3],
    size: [f32; 3],
    radius: f32,
    random: u32,
}

impl Scene {
    /// `count` particles spread over the box, at rest. The same at every run.
    pub fn new(count: usize, min: [f32; 3], max: [f32; 3]) -> Self {
        let size = [0, 1, 2].map(|axis: usize| max[axis] - min[axis]);
        let mut scene = Self { particles: Vec::with_capacity(count), min, size, radius: 0.002 * size[1], random: 1 };
        for _ in 0..count {
            let position = [0, 1, 2].map(|axis: usize| min[axis] + scene.share() * size[axis]);
            scene.particles.push(Particle { position, velocity: [0.0; 3] });
        }
        scene
    }

    pub fn positions(&self) -> impl Iterator<Item = [f32; 3]> {
        self.particles.iter().map(|particle| particle.position)
    }

    /// One frame: each particle asks every obstacle whose box it is in. Returns how many touched one.
    pub fn step<O: Obstacle>(&mut self, obstacles: &[O]) -> usize {
        let boxes: Vec<Aabb> = obstacles.iter().map(Obstacle::bounds).collect();
        let mut particles = std::mem::take(&mut self.particles);
        let mut bounces = 0;
        for particle in &mut particles {
            // Down is -y.
            particle.velocity[1] -= self.size[1] * FRAME;
            for (position, velocity) in particle.position.iter_mut().zip(particle.velocity) {
                *position += velocity * FRAME;
            }
            for (obstacle, bounds) in obstacles.iter().zip(&boxes) {
                if !holds(bounds, particle.position) {
                    continue;
                }
                let (distance, gradient) = obstacle.distance_and_gradient(particle.position);
                bounces += usize::from(collide(particle, distance - self.radius, gradient));
            }
            if particle.position[1] < self.min[1] {
                *particle = self.at_the_top();
            }
        }
        self.particles = particles;
        bounces
    }

    fn at_the_top(&mut self) -> Particle {
        let (x, z) = (self.share(), self.share());
        let [min_x, min_y, min_z] = self.min;
        let [width, height, depth] = self.size;
        Particle { position: [min_x + x * width, min_y + height, min_z + z * depth], velocity: [0.0; 3] }
    }

    /// A number from 0 to 1.
    fn share(&mut self) -> f32 {
        self.random = self.random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (self.random >> 8) as f32 / (1 << 24) as f32
    }
}

fn holds(bounds: &Aabb, point: [f32; 3]) -> bool {
    (0..3).all(|axis| (bounds.min[axis]..=bounds.max[axis]).contains(&point[axis]))
}

/// Pushes a particle out of an obstacle and turns its velocity round. Whether it had touched it.
fn collide(particle: &mut Particle, distance: f32, gradient: [f32; 3]) -> bool {
    if distance >= 0.0 {
        return false;
    }
    for (position, slope) in particle.position.iter_mut().zip(gradient) {
        *position -= distance * slope;
    }
    let inward: f32 = particle.velocity.iter().zip(gradient).map(|(velocity, slope)| velocity * slope).sum();
    if inward < 0.0 {
        for (velocity, slope) in particle.velocity.iter_mut().zip(gradient) {
            *velocity -= (1.0 + BOUNCE) * inward * slope;
        }
    }
    true
}

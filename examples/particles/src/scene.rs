//! Particles that fall on obstacles, bounce off, and start again at the top.

use crate::obstacle::Obstacle;
use nearfield::Aabb;

/// Seconds of a frame.
const FRAME: f32 = 1.0 / 60.0;
/// Share of its speed that a particle keeps when it bounces.
const BOUNCE: f32 = 0.4;

/// When a particle asks an obstacle whose box it is in.
#[derive(Clone, Copy, PartialEq)]
pub enum Asking {
    /// In every frame.
    Always,
    /// When it has moved so far since the last answer that it may touch.
    WhenNear,
}

/// Most obstacles of a scene.
const OBSTACLES: usize = 2;

#[derive(Clone)]
struct Particle {
    position: [f32; 3],
    velocity: [f32; 3],
    /// How far it may move before it can touch each obstacle.
    clear: [f32; OBSTACLES],
}

/// What particles ask an obstacle in one frame, all at once, and the answers.
#[derive(Default)]
struct Questions {
    particles: Vec<usize>,
    points: Vec<[f32; 3]>,
    distances: Vec<f32>,
    gradients: Vec<[f32; 3]>,
}

/// Particles in a box.
pub struct Scene {
    particles: Vec<Particle>,
    questions: Questions,
    asking: Asking,
    min: [f32; 3],
    size: [f32; 3],
    radius: f32,
    random: u32,
}

impl Scene {
    /// `count` particles spread over the box, at rest. The same at every run.
    pub fn new(count: usize, min: [f32; 3], max: [f32; 3], asking: Asking) -> Self {
        let size = [0, 1, 2].map(|axis: usize| max[axis] - min[axis]);
        let (particles, questions) = (Vec::with_capacity(count), Questions::default());
        let mut scene = Self { particles, questions, asking, min, size, radius: 0.002 * size[1], random: 1 };
        for _ in 0..count {
            let position = [0, 1, 2].map(|axis: usize| min[axis] + scene.share() * size[axis]);
            scene.particles.push(Particle { position, velocity: [0.0; 3], clear: [0.0; OBSTACLES] });
        }
        scene
    }

    pub fn positions(&self) -> impl Iterator<Item = [f32; 3]> {
        self.particles.iter().map(|particle| particle.position)
    }

    /// One frame. Returns how many particles asked an obstacle, and how many touched one.
    pub fn step<O: Obstacle>(&mut self, obstacles: &[O; OBSTACLES]) -> [usize; 2] {
        self.fall();
        let counts = [0, 1].map(|index: usize| self.meet(&obstacles[index], index));
        for index in 0..self.particles.len() {
            if self.particles[index].position[1] < self.min[1] {
                self.particles[index] = self.at_the_top();
            }
        }
        [counts[0][0] + counts[1][0], counts[0][1] + counts[1][1]]
    }

    fn fall(&mut self) {
        for particle in &mut self.particles {
            // Down is -y.
            particle.velocity[1] -= self.size[1] * FRAME;
            for (position, velocity) in particle.position.iter_mut().zip(particle.velocity) {
                *position += velocity * FRAME;
            }
            let [x, y, z] = particle.velocity;
            let way = (x * x + y * y + z * z).sqrt() * FRAME;
            particle.clear = particle.clear.map(|clear| clear - way);
        }
    }

    /// Particles in the box of an obstacle ask it, and bounce. Returns how many asked, and how many touched.
    fn meet<O: Obstacle>(&mut self, obstacle: &O, index: usize) -> [usize; 2] {
        let (bounds, steepest) = (obstacle.bounds(), obstacle.steepest());
        let Questions { particles, points, distances, gradients } = &mut self.questions;
        particles.clear();
        points.clear();
        for (number, particle) in self.particles.iter().enumerate() {
            let may_touch = particle.clear[index] <= 0.0 || self.asking == Asking::Always;
            if may_touch && holds(&bounds, particle.position) {
                particles.push(number);
                points.push(particle.position);
            }
        }
        distances.resize(points.len(), 0.0);
        gradients.resize(points.len(), [0.0; 3]);
        obstacle.ask(points, distances, gradients);

        let mut touched = 0;
        for ((&number, &distance), &gradient) in particles.iter().zip(&*distances).zip(&*gradients) {
            let particle = &mut self.particles[number];
            let room = distance - self.radius;
            // A little less, for the rounding of the way.
            particle.clear[index] = 0.999 * room / steepest;
            if collide(particle, room, gradient) {
                particle.clear = [0.0; OBSTACLES];
                touched += 1;
            }
        }
        [points.len(), touched]
    }

    fn at_the_top(&mut self) -> Particle {
        let (x, z) = (self.share(), self.share());
        let [min_x, min_y, min_z] = self.min;
        let [width, height, depth] = self.size;
        Particle {
            position: [min_x + x * width, min_y + height, min_z + z * depth],
            velocity: [0.0; 3],
            clear: [0.0; OBSTACLES],
        }
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

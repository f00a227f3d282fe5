//! A mesh, and the points at which all its fields are measured.

use cpu_time::ThreadTime;
use glam::DVec3;
use nearfield_bake::distance::{SignChoice, SignedDistance};
use nearfield_bake::field_function::FieldFunction;
use nearfield_bake::import;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::random::Draws;
use nearfield_bake::verify::BAND;
use std::hint::black_box;
use std::path::Path;

/// Points uniform in the box, and again of the band.
pub(crate) const POINTS: u64 = 100_000;

/// A mesh, its exact distance, and points with their exact distances.
pub(crate) struct Subject {
    pub(crate) mesh: CheckedMesh,
    pub(crate) distance: SignedDistance,
    uniform: Probes,
    band: Probes,
}

struct Probes {
    points: Vec<[f32; 3]>,
    exact: Vec<f64>,
}

/// Errors relative to the diagonal.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Errors {
    pub(crate) rmse: f64,
    pub(crate) p99: f64,
    pub(crate) max: f64,
}

/// What a field is worth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Figures {
    pub(crate) uniform: Errors,
    pub(crate) band: Errors,
    /// Thread CPU time of a distance at a random point of the box.
    pub(crate) nanoseconds: f64,
}

impl Subject {
    pub(crate) fn read(name: &str, path: &Path) -> Self {
        let soup = import::read(path).unwrap_or_else(|error| panic!("{name}: {error}"));
        let mesh = CheckedMesh::new(soup).expect("a mesh");
        let distance = SignedDistance::choose(&mesh, SignChoice::Auto).0;

        let uniform = Probes::new(
            &distance,
            (0..POINTS).map(|index| {
                let mut draws = Draws::new(0, 1, index);
                mesh.bounds.min + mesh.bounds.size() * DVec3::new(draws.unit(), draws.unit(), draws.unit())
            }),
        );
        // Feet of the points on the surface, moved by up to the band in a random direction.
        let reach = BAND * mesh.bounds.diagonal();
        let band = uniform.points.iter().zip(&uniform.exact).enumerate().map(|(index, (&point, &exact))| {
            let point = glam::Vec3::from(point).as_dvec3();
            let mut draws = Draws::new(0, 2, index as u64);
            point - distance.sample(point).gradient * exact + draws.direction() * (reach * draws.unit())
        });
        let band = Probes::new(&distance, band);
        Self { uniform, band, mesh, distance }
    }

    /// Measures a field that answers distances.
    pub(crate) fn measure(&self, field: impl Fn([f32; 3]) -> f32) -> Figures {
        let mut times = [0; 5].map(|_: i32| {
            let start = ThreadTime::now();
            black_box(self.uniform.points.iter().map(|&point| field(point)).sum::<f32>());
            start.elapsed().as_secs_f64()
        });
        times.sort_unstable_by(f64::total_cmp);
        let answers: Vec<f32> = self.points().map(field).collect();
        self.figures(&answers, times[2] * 1e9 / POINTS as f64)
    }

    /// The points uniform in the box, then those of the band.
    pub(crate) fn points(&self) -> impl Iterator<Item = [f32; 3]> {
        self.uniform.points.iter().chain(&self.band.points).copied()
    }

    /// What a field with these answers at the [`points`](Self::points) is worth.
    pub(crate) fn figures(&self, answers: &[f32], nanoseconds: f64) -> Figures {
        let diagonal = self.mesh.bounds.diagonal();
        let (uniform, band) = answers.split_at(self.uniform.points.len());
        Figures { uniform: self.uniform.errors(uniform, diagonal), band: self.band.errors(band, diagonal), nanoseconds }
    }
}

impl Probes {
    fn new(distance: &SignedDistance, points: impl Iterator<Item = DVec3>) -> Self {
        let points: Vec<[f32; 3]> = points.map(|point| point.as_vec3().to_array()).collect();
        let rounded: Vec<DVec3> = points.iter().map(|&point| glam::Vec3::from(point).as_dvec3()).collect();
        let exact = distance.sample_all(&rounded).into_iter().map(|sample| sample.distance).collect();
        Self { points, exact }
    }

    fn errors(&self, answers: &[f32], diagonal: f64) -> Errors {
        let pairs = answers.iter().zip(&self.exact);
        let mut errors: Vec<f64> = pairs.map(|(&answer, exact)| (f64::from(answer) - exact).abs() / diagonal).collect();
        errors.sort_unstable_by(f64::total_cmp);
        let count = errors.len();
        Errors {
            rmse: (errors.iter().map(|error| error * error).sum::<f64>() / count as f64).sqrt(),
            p99: errors[(99 * count).div_ceil(100) - 1],
            max: errors[count - 1],
        }
    }
}

//! A small mesh bakes, and its field is as good as it says.

use crate::oracle;
use glam::DVec3;
use nearfield::Field;
use nearfield_bake::bake;
use nearfield_bake::distance::SignChoice;
use nearfield_bake::import::TriangleSoup;
use nearfield_bake::mesh::CheckedMesh;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{
    Continuity, FineGrid, GridSettings, Interpolant, Layout, PolynomialSettings, Precision, Profile, RangeScope,
    Reconstruction, Resolution, Sampling, Settings, Target, Termination,
};

/// Fresh points a field is asked at.
const POINTS: u32 = 128;
/// Points of the contract. A fresh point exceeds their maximum once in as many.
const CONTRACT_POINTS: u32 = 1000;
/// Fresh points that may exceed the maximum: more come once in 10¹³ fields.
const MOST_WORSE: usize = 10;

/// Bytes as small numbers, zero when there are no more.
struct Numbers<'a>(std::slice::Iter<'a, u8>);

impl Numbers<'_> {
    fn next(&mut self) -> u8 {
        self.0.next().copied().unwrap_or(0)
    }

    fn below(&mut self, end: u8) -> u8 {
        self.next() % end
    }

    fn one_of<T: Copy>(&mut self, choices: &[T]) -> T {
        choices[usize::from(self.next()) % choices.len()]
    }

    fn point(&mut self) -> DVec3 {
        DVec3::from([0; 3].map(|_| f64::from(self.next() as i8) / 16.0))
    }
}

/// Settings and a mesh of at most 16 triangles from bytes: the bake succeeds, its file is valid, and the distances agree
/// with the nearest triangle within the contract.
pub fn bake_small(bytes: &[u8]) {
    let mut numbers = Numbers(bytes.iter());
    let settings = settings(&mut numbers);
    if settings.check().is_err() {
        return;
    }
    let Some(mesh) = mesh(&mut numbers) else { return };
    let baked = bake(&mesh, &settings, &Silent).expect("a small mesh bakes");
    let field = Field::open(&baked.bytes).expect("a field");
    assert_eq!(field.validate(), Ok(()));

    let contract = field.contract();
    let diagonal = mesh.bounds.diagonal();
    let bound = f64::from(contract.uniform.max) * (1.0 + 1e-4) + 1e-6 * diagonal;
    let (mut state, mut worse) = (1_u64, 0);
    let mut unit = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 40) as f64 / (1 << 24) as f64
    };
    for _ in 0..POINTS {
        let place = DVec3::new(unit(), unit(), unit());
        let point = (mesh.bounds.min + place * mesh.bounds.size()).as_vec3();
        let distance = f64::from(field.distance(point.to_array()));
        let exact = oracle::distance(&mesh, point.as_dvec3());
        // The oracle knows no sign, and a wrong one is an error that only grows.
        worse += usize::from((distance.abs() - exact).abs() > bound);
    }
    assert!(worse <= MOST_WORSE, "{worse} of {POINTS} points are worse than {bound:.2e}: {settings:?}");
}

fn settings(numbers: &mut Numbers<'_>) -> Settings {
    let layout = match numbers.below(3) {
        0 => Layout::Octree,
        1 => Layout::Polynomial(polynomials(numbers)),
        _ => Layout::Grid(grid(numbers)),
    };
    let start_depth = numbers.below(4);
    Settings {
        max_bytes: None,
        layout,
        error: Target::Relative((f64::from(numbers.next()) + 1.0) / 2000.0),
        interpolant: numbers.one_of(&[Interpolant::Trilinear, Interpolant::Tricubic]),
        termination: numbers.one_of(&[
            Termination::Trapezoid,
            Termination::Simpson,
            Termination::ByDistance,
            Termination::MaxError,
        ]),
        continuity: numbers.one_of(&[Continuity::None, Continuity::C0, Continuity::C1]),
        precision: numbers.one_of(&[Precision::Packed32, Precision::F16, Precision::F32]),
        start_depth,
        max_depth: (start_depth + numbers.below(4)).min(5),
        margin: f64::from(numbers.next()) / 256.0,
        sign: numbers.one_of(&[SignChoice::Auto, SignChoice::Pseudonormal, SignChoice::Winding]),
        samples: CONTRACT_POINTS,
    }
}

fn polynomials(numbers: &mut Numbers<'_>) -> PolynomialSettings {
    PolynomialSettings {
        max_error: None,
        profile: numbers.one_of(&[Profile::Uniform, Profile::Surface]),
        overlap: f64::from(numbers.below(65)) / 256.0,
    }
}

fn grid(numbers: &mut Numbers<'_>) -> GridSettings {
    let fine = FineGrid {
        count: 2 + numbers.below(4),
        extent: (f64::from(numbers.below(16)) + 1.0) / 16.0,
        falloff: f64::from(numbers.below(4)),
        normalized: numbers.below(2) == 1,
    };
    let mut samples = || 2 + u16::from(numbers.below(8));
    let resolution = [samples(), samples(), samples()];
    GridSettings {
        resolution: numbers.one_of(&[Resolution::Longest(resolution[0]), Resolution::Each(resolution)]),
        order: numbers.below(4),
        reconstruction: numbers.one_of(&[
            Reconstruction::Nearest,
            Reconstruction::Linear,
            Reconstruction::Half,
            Reconstruction::Blend,
            Reconstruction::Hermite,
        ]),
        sampling: numbers.one_of(&[Sampling::Taylor, Sampling::LeastSquares(fine), Sampling::Fitted]),
        range: numbers.one_of(&[RangeScope::File, RangeScope::Brick]),
    }
}

/// Triangles of a few vertices, moved and scaled.
fn mesh(numbers: &mut Numbers<'_>) -> Option<CheckedMesh> {
    let scale = f64::from(numbers.next() as i8 / 4).exp2();
    let offset = numbers.point() * scale;
    let vertices = 3 + numbers.below(8);
    let positions = (0..vertices).map(|_| numbers.point() * scale + offset).collect();
    let triangles = (0..1 + numbers.below(16)).map(|_| [0; 3].map(|_| u32::from(numbers.below(vertices)))).collect();
    CheckedMesh::new(TriangleSoup { positions, triangles }).ok()
}

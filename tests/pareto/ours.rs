//! Our own fields, through their files and the shipping reader.

use crate::subject::Subject;
use crate::{Family, Kind, Measured};
use nearfield::Field;
use nearfield_bake::bake;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{
    GridSettings, Layout, PolynomialSettings, Precision, Profile, RangeScope, Reconstruction, Resolution, Sampling,
    Settings, Target,
};
use nearfield_bake::verify::BAND;

const TARGETS: [f64; 5] = [4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4];
const RESOLUTIONS: [u16; 5] = [16, 32, 48, 64, 96];

/// Name, order, reconstruction and precision.
const GRIDS: [(&str, u8, Reconstruction, Precision); 4] = [
    ("our grid, 16 bits", 0, Reconstruction::Linear, Precision::Packed32),
    ("our grid, f16", 0, Reconstruction::Linear, Precision::F16),
    ("our grid, half", 1, Reconstruction::Half, Precision::Packed32),
    ("our grid, hermite", 1, Reconstruction::Hermite, Precision::Packed32),
];

pub(crate) fn families(subject: &Subject) -> Vec<Family> {
    let profiles = [("polynomials", Profile::Uniform), ("polynomials, surface", Profile::Surface)];
    let octrees = profiles.map(|(name, profile)| {
        let fields = TARGETS.map(|target| {
            let polynomial = PolynomialSettings { profile, ..PolynomialSettings::default() };
            let settings = Settings {
                layout: Layout::Polynomial(polynomial),
                error: Target::Relative(target),
                ..Settings::default()
            };
            measured(subject, format!("{target:.1e}"), settings)
        });
        Family { name, kind: Kind::Everywhere, fields: fields.into() }
    });
    let grids = GRIDS.map(|(name, order, reconstruction, precision)| {
        let fields = RESOLUTIONS.map(|samples| {
            let grid = GridSettings {
                resolution: Resolution::Longest(samples),
                order,
                reconstruction,
                sampling: Sampling::Taylor,
                range: RangeScope::Brick,
            };
            // The box of the dense grids.
            let margin = BAND * subject.mesh.bounds.diagonal() / subject.mesh.bounds.size().max_element();
            let settings = Settings { layout: Layout::Grid(grid), precision, margin, ..Settings::default() };
            measured(subject, samples.to_string(), settings)
        });
        Family { name, kind: Kind::Everywhere, fields: fields.into() }
    });
    octrees.into_iter().chain(grids).collect()
}

fn measured(subject: &Subject, setting: String, settings: Settings) -> Measured {
    // The contract's own measurement is not looked at.
    let settings = Settings { samples: 100, ..settings };
    let baked = bake(&subject.mesh, &settings, &Silent).expect("the mesh bakes");
    let field = Field::open(&baked.bytes).expect("a field");
    Measured { setting, bytes: baked.bytes.len(), figures: subject.measure(|point| field.distance(point)) }
}

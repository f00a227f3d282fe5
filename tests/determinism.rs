use crate::shapes;
use nearfield_bake::bake;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Continuity, Interpolant, Layout, Precision, Settings, Target};

fn bytes_with(threads: usize, settings: &Settings) -> Vec<u8> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
    pool.install(|| bake(&shapes::read("bob_small.ply"), settings, &Silent).expect("the mesh bakes").bytes)
}

#[test]
fn one_two_and_eight_threads_give_the_same_bytes() {
    let quick = Settings {
        error: Target::Relative(1e-3),
        max_depth: 7,
        samples: 10_000,
        layout: Layout::Octree,
        ..Settings::default()
    };
    for settings in [
        quick,
        Settings { continuity: Continuity::None, precision: Precision::F16, ..quick },
        Settings {
            interpolant: Interpolant::Trilinear,
            continuity: Continuity::C0,
            precision: Precision::F32,
            ..quick
        },
    ] {
        let bytes = bytes_with(1, &settings);
        for threads in [2, 8] {
            assert!(bytes_with(threads, &settings) == bytes, "{threads} threads, {settings:?}");
        }
    }
}

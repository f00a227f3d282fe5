//! Grids that every reader must refuse, each for one reason (§11).

use super::grid::{BLEND, BRICK, Grid, HALF, HERMITE, LINEAR, Like, NEAREST, WHOLE};
use super::invalid::{above, below, two_to};
use super::samples::{F16, F32, PACKED32};
use super::writer::File;

/// Names, reasons and files.
pub(super) fn all() -> Vec<(String, &'static str, File)> {
    let mut vectors = Vectors::default();
    sections(&mut vectors);
    parameters(&mut vectors);
    scale(&mut vectors);
    lengths(&mut vectors);
    sample_data(&mut vectors);
    vectors.0
}

#[derive(Default)]
struct Vectors(Vec<(String, &'static str, File)>);

impl Vectors {
    fn file(&mut self, name: &str, error: &'static str, change: impl FnOnce(&mut File)) {
        let mut file = grid(1, PACKED32).file();
        change(&mut file);
        self.0.push((format!("grid_{name}"), error, file));
    }

    /// A change of the grid. The box stays.
    fn grid(&mut self, name: &str, error: &'static str, change: impl FnOnce(&mut Grid)) {
        self.changed(name, error, grid(1, PACKED32), change);
    }

    fn changed(&mut self, name: &str, error: &'static str, mut grid: Grid, change: impl FnOnce(&mut Grid)) {
        let file = grid.file();
        change(&mut grid);
        self.0.push((format!("grid_{name}"), error, File { sections: grid.file().sections, ..file }));
    }
}

fn grid(order: u8, precision: u32) -> Grid {
    Grid::new(Like { resolution: [3; 3], order, reconstruction: LINEAR, precision, range: WHOLE }, 40)
}

/// §4.
fn sections(vectors: &mut Vectors) {
    for (index, name) in ["grid", "samp", "base"].into_iter().enumerate() {
        vectors.file(&format!("section_{name}_missing"), "SectionMissing", |file| drop(file.sections.remove(index)));
    }
    vectors.file("that_is_called_an_octree", "SectionMissing", |file| file.family = 2);
    vectors.file("without_sections", "SectionMissing", |file| file.sections.clear());
}

/// §11.1, §11.2.
fn parameters(vectors: &mut Vectors) {
    vectors.file("parameters_short", "GridLength", |file| file.sections[0].1.truncate(24));
    vectors.file("parameters_long", "GridLength", |file| file.sections[0].1.extend([0; 4]));
    vectors.file("parameters_empty", "GridLength", |file| file.sections[0].1.clear());
    for (axis, name) in ["x", "y", "z"].into_iter().enumerate() {
        vectors.grid(&format!("no_samples_in_{name}"), "GridResolution", |grid| grid.resolution[axis] = 0);
        vectors.grid(&format!("one_sample_in_{name}"), "GridResolution", |grid| grid.resolution[axis] = 1);
        vectors.file(&format!("box_not_the_samples_in_{name}"), "GridBounds", |file| file.box_max[axis] += 0.01);
        vectors.grid(&format!("spacing_of_another_box_in_{name}"), "GridBounds", |grid| grid.spacing[axis] *= 1.001);
    }
    for byte in 0..2 {
        vectors.grid(&format!("reserved_byte_{byte}_of_parameters"), "Reserved", |grid| grid.reserved[byte] = 1);
    }
    vectors.grid("order_4", "GridReconstruction", |grid| grid.order = 4);
    vectors.grid("order_255", "GridReconstruction", |grid| grid.order = 255);
    vectors.grid("reconstruction_5", "GridReconstruction", |grid| grid.reconstruction = 5);
    vectors.grid("reconstruction_255", "GridReconstruction", |grid| grid.reconstruction = 255);
    for (name, reconstruction, order) in
        [("half", HALF, 0), ("blend", BLEND, 0), ("hermite", HERMITE, 0), ("hermite", HERMITE, 3)]
    {
        let name = format!("{name}_order_{order}");
        vectors.changed(&name, "GridReconstruction", grid(order, F16), |grid| grid.reconstruction = reconstruction);
    }
    vectors.grid("precision_3", "GridPrecision", |grid| grid.precision = 3);
    vectors.grid("precision_255", "GridPrecision", |grid| grid.precision = 255);
    vectors.grid("range_2", "GridPrecision", |grid| grid.range = 2);
    vectors.changed("bricks_of_f32", "GridPrecision", grid(1, F32), |grid| grid.range = BRICK);
}

/// §11.1.
fn scale(vectors: &mut Vectors) {
    let wrong = [
        ("nan", f32::NAN),
        ("zero", 0.0),
        ("negative", -0.5),
        ("infinite", f32::INFINITY),
        ("too_large", above(two_to(60))),
    ];
    for (name, number) in wrong {
        for (axis, axis_name) in ["x", "y", "z"].into_iter().enumerate() {
            let name = format!("spacing_{axis_name}_{name}");
            vectors.grid(&name, "GridScale", |grid| grid.spacing[axis] = number);
        }
        vectors.grid(&format!("quantum_{name}"), "GridScale", |grid| grid.quantum = number);
        vectors.changed(&format!("quantum_of_f32_{name}"), "GridScale", grid(1, F32), |grid| grid.quantum = number);
    }
    vectors.grid("quantum_too_small", "GridScale", |grid| grid.quantum = below(two_to(-80)));
    let fine = |spacing| Grid { box_min: [0.0; 3], spacing, ..grid(1, PACKED32) }.file();
    vectors.file("spacing_too_small", "GridScale", |file| *file = fine([below(two_to(-40)), two_to(-39), two_to(-39)]));
    vectors.file("spacings_too_far_apart", "GridScale", |file| *file = fine([above(1024.0), 1.0, 2.0]));
}

/// §11.2, §11.3.
fn lengths(vectors: &mut Vectors) {
    for (order, precision, name) in [
        (0, PACKED32, "order_0_packed32"),
        (1, PACKED32, "order_1_packed32"),
        (2, PACKED32, "order_2_packed32"),
        (3, F16, "order_3_f16"),
        (3, F32, "order_3_f32"),
    ] {
        let like = Grid::new(Like { order, ..like(precision) }, 41);
        vectors.changed(&format!("{name}_cut"), "GridResolution", like.clone(), |grid| {
            grid.samples.pop();
        });
        vectors.changed(&format!("{name}_too_long"), "GridSamples", like, |grid| grid.samples.push(0));
    }
    vectors.grid("no_samples", "GridResolution", |grid| grid.samples.clear());
    vectors.grid("no_bases", "GridResolution", |grid| grid.bases = Some(Vec::new()));
    vectors.grid("two_bases", "GridSamples", |grid| grid.bases = Some(vec![-2000; 2]));
    let bricks = Grid::new(Like { resolution: [5, 2, 2], range: BRICK, ..like(PACKED32) }, 42);
    vectors.changed("fewer_bases_than_bricks", "GridResolution", bricks.clone(), |grid| grid.bases = Some(vec![0]));
    vectors.changed("more_bases_than_bricks", "GridSamples", bricks.clone(), |grid| grid.bases = Some(vec![0; 3]));
    vectors.changed("base_too_low", "BlockBase", bricks.clone(), |grid| {
        grid.bases = Some(vec![0, -(1 << 27) - 1]);
    });
    vectors.changed("base_too_high", "BlockBase", bricks, |grid| {
        grid.bases = Some(vec![0, (1 << 27) - (1 << 12) + 1]);
    });
}

fn like(precision: u32) -> Like {
    Like { resolution: [2; 3], order: 1, reconstruction: NEAREST, precision, range: WHOLE }
}

/// §11.3.
fn sample_data(vectors: &mut Vectors) {
    vectors.grid("gradient_x_1023", "GradientCode", |grid| grid.samples[3] |= 0x3FF);
    vectors.grid("gradient_y_1023", "GradientCode", |grid| grid.samples[26] |= 0x3FF << 10);
    for bit in [16, 31] {
        let name = format!("reserved_bit_{bit}_after_last_sample");
        vectors.changed(&name, "Reserved", grid(0, PACKED32), |grid| {
            *grid.samples.last_mut().expect("samples") |= 1 << bit;
        });
    }

    // The first half of a sample, and the last of all.
    for (name, half) in [("nan", 0x7E00), ("infinite", 0x7C00), ("minus_infinite", 0xFC00)] {
        let second = Grid::new(Like { order: 2, ..like(PACKED32) }, 43);
        vectors.changed(&format!("second_degree_{name}"), "SampleValue", second, |grid| {
            grid.samples[1] = grid.samples[1] & !0xFFFF | half;
        });
        vectors.changed(&format!("gradient_{name}"), "SampleValue", Grid::new(like(F16), 43), |grid| {
            grid.samples[0] = grid.samples[0] & 0xFFFF | half << 16;
        });
        let third = Grid::new(Like { order: 3, ..like(F16) }, 43);
        vectors.changed(&format!("third_degree_{name}"), "SampleValue", third, |grid| {
            grid.samples[79] = grid.samples[79] & 0xFFFF | half << 16;
        });
    }
    let wrong = [("nan", f32::NAN), ("infinite", f32::INFINITY), ("too_large", above(two_to(60)))];
    for (name, number) in wrong {
        for (place, word) in [("distance", 0), ("last_coefficient", 31)] {
            vectors.changed(&format!("f32_{place}_{name}"), "SampleValue", Grid::new(like(F32), 44), |grid| {
                grid.samples[word] = number.to_bits();
            });
        }
    }
}

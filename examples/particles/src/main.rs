//! 100 000 particles fall on a shape and a plate: `nearfield-particles SHAPE.nfd SHAPE.ply PLATE.nfd PLATE.ply`. Prints the
//! processor time of a frame with baked fields and with exact distances, after it has seen that both say the same.

mod obstacle;
mod scene;

use cpu_time::ThreadTime;
use nearfield::Field;
use obstacle::{Exact, Obstacle};
use scene::{Asking, Scene};
use std::error::Error;
use std::path::Path;
use std::{env, fs};

const PARTICLES: usize = 100_000;
const FRAMES: usize = 60;

fn main() -> Result<(), Box<dyn Error>> {
    let paths: Vec<String> = env::args().skip(1).collect();
    let [shape, shape_mesh, plate, plate_mesh] = &paths[..] else {
        return Err("usage: nearfield-particles SHAPE.nfd SHAPE.ply PLATE.nfd PLATE.ply".into());
    };
    let (shape, plate) = (fs::read(shape)?, fs::read(plate)?);
    let fields = [Field::open(&shape)?, Field::open(&plate)?];
    let read = |mesh: &str, field: &Field<'_>| Exact::read(Path::new(mesh), field.header().bounds);
    let exact = [read(shape_mesh, &fields[0])?, read(plate_mesh, &fields[1])?];

    let bounds = fields[0].header().bounds;
    let scene = |asking| Scene::new(PARTICLES, bounds.min, bounds.max, asking);
    for (field, exact) in fields.iter().zip(&exact) {
        compare(field, exact, &scene(Asking::Always));
    }
    report("baked", scene, &fields);
    report("exact", scene, &exact);
    Ok(())
}

/// Panics unless a field is what its contract says, as far as a particle cares.
fn compare(field: &Field<'_>, exact: &Exact, scene: &Scene) {
    let bound = field.contract().max_error();
    let bounds = field.header().bounds;
    let is_inside = |point: &[f32; 3]| (0..3).all(|axis| (bounds.min[axis]..=bounds.max[axis]).contains(&point[axis]));
    let errors = scene.positions().filter(is_inside).map(|point| {
        let (truth, _) = exact.distance_and_gradient(point);
        (field.distance(point) - truth).abs()
    });
    let errors: Vec<f32> = errors.collect();
    let beyond = errors.iter().filter(|&&error| error > bound).count();
    // The largest error was measured at other points: a few may exceed it.
    assert!(beyond * 1000 <= errors.len(), "{beyond} of {} are farther off than {bound}", errors.len());
    println!("{} points inside the field, {beyond} farther off than its largest measured error, {bound}", errors.len());
}

/// Both ways to ask, of which the second must not miss a contact.
fn report<O: Obstacle>(name: &str, scene: impl Fn(Asking) -> Scene, obstacles: &[O; 2]) {
    let contacts = [("always", Asking::Always), ("when near", Asking::WhenNear)].map(|(way, asking)| {
        let mut scene = scene(asking);
        let mut milliseconds = Vec::with_capacity(FRAMES);
        let [mut questions, mut contacts] = [0; 2];
        for _ in 0..FRAMES {
            let start = ThreadTime::now();
            let [asked, touched] = scene.step(obstacles);
            milliseconds.push(start.elapsed().as_secs_f64() * 1e3);
            questions += asked;
            contacts += touched;
        }
        milliseconds.sort_by(f64::total_cmp);
        let (least, median) = (milliseconds[0], milliseconds[FRAMES / 2]);
        let (questions, each) = (questions / FRAMES, contacts / FRAMES);
        println!(
            "{name}, asked {way}: {median:.2} ms a frame, at best {least:.2}; {questions} questions and {each} contacts a frame"
        );
        contacts
    });
    assert_eq!(contacts[0], contacts[1], "a particle that asked too late missed a contact");
}

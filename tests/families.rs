use crate::support::numbers::Numbers;
use crate::vectors::{folder, names, read};
use glam::DVec3;
use nearfield::{Aabb, Continuity, Error, Family, Field, Instance, NotASimilarity, Representation};
use std::collections::BTreeSet;
use std::{env, fs};

/// Points of a box and around it.
fn points(bounds: Aabb) -> Vec<[f32; 3]> {
    let mut numbers = Numbers::new(11);
    let [min, max] = [bounds.min, bounds.max].map(|corner| DVec3::from(corner.map(f64::from)));
    let place = |part: DVec3| (min + part * (max - min)).as_vec3().to_array();
    (0..40).map(|_| place(numbers.point(DVec3::splat(-0.2), DVec3::splat(1.2)))).collect()
}

/// A reader that knows one family alone gives the bits of the one that knows all.
fn agree<'a, R: Representation<'a>>(name: &str, one: &Field<'a, R>, any: &Field<'a>) {
    assert_eq!(one.validate(), Ok(()), "{name}");
    let points = points(any.header().bounds);
    let (mut values, mut distances) = (vec![0.0; points.len()], vec![0.0; points.len()]);
    let mut gradients = vec![[0.0; 3]; points.len()];
    assert_eq!(one.distances(&points, &mut values), points.len());
    assert_eq!(one.distances_and_gradients(&points, &mut distances, &mut gradients), points.len());

    let mut cursor = one.cursor();
    for (index, &point) in points.iter().enumerate() {
        let (distance, gradient) = any.distance_and_gradient(point);
        let place = format!("{name} at {point:?}");
        let (alone, gradient_alone) = one.distance_and_gradient(point);
        for answer in [alone, one.distance(point), values[index], distances[index], cursor.distance(point)] {
            assert_eq!(answer.to_bits(), distance.to_bits(), "{place}");
        }
        for answer in [gradient_alone, gradients[index], cursor.distance_and_gradient(point).1] {
            assert_eq!(answer.map(f32::to_bits), gradient.map(f32::to_bits), "{place}");
        }
        assert_eq!(one.clearance(point).to_bits(), any.clearance(point).to_bits(), "{place}");
    }
}

#[test]
fn a_reader_of_one_family_answers_as_one_of_all_and_refuses_the_others() {
    let mut seen = BTreeSet::new();
    for name in names(&folder("valid")) {
        let bytes = read(&folder("valid"), &name);
        let field = Field::open(&bytes).expect("a field");
        let opened = [
            Field::open_grid(&bytes).map(|one| agree(&name, &one, &field)),
            Field::open_octree(&bytes).map(|one| agree(&name, &one, &field)),
            Field::open_polynomial_octree(&bytes).map(|one| agree(&name, &one, &field)),
        ];
        let family = field.header().family;
        let own = [Family::Grid, Family::Octree, Family::Polynomial].map(|other| other == family);
        assert_eq!(opened, own.map(|is_own| if is_own { Ok(()) } else { Err(Error::Family) }), "{name}");
        seen.insert(format!("{family:?}"));
    }
    assert_eq!(seen.len(), 3, "a family without a vector");
}

/// What an octree of polynomials says of itself holds for its leaves.
#[test]
fn polynomial_octrees_are_as_they_say() {
    let mut blended = BTreeSet::new();
    for name in names(&folder("valid")) {
        let bytes = read(&folder("valid"), &name);
        let Ok(field) = Field::open_polynomial_octree(&bytes) else { continue };
        let octree = field.representation();
        let finest = 1_u32 << octree.depth();
        assert_eq!(octree.lattice(), octree.root_cells().map(|cells| cells * finest), "{name}");

        // Each inner node has eight children, and the roots have no parent.
        let leaves: Vec<_> = octree.leaves().collect();
        let roots: u32 = octree.root_cells().into_iter().product();
        assert_eq!(leaves.len(), octree.leaf_count() as usize, "{name}");
        assert_eq!(leaves.len(), roots as usize + 7 * octree.inner_count(), "{name}");

        let Aabb { min, max } = octree.bounds();
        assert_eq!(octree.bounds(), field.header().bounds, "{name}");
        for leaf in leaves {
            let level = octree.depth() - leaf.edge.trailing_zeros() as u8;
            let edge = octree.edge(level);
            assert_eq!(octree.edge(octree.depth()) * leaf.edge as f32, edge, "{name}");
            let centre = [0, 1, 2].map(|axis: usize| {
                let part = (leaf.cell[axis] as f32 + 0.5 * leaf.edge as f32) / octree.lattice()[axis] as f32;
                min[axis] + part * (max[axis] - min[axis])
            });
            let (distance, _) = octree.unblended(centre).expect("a point of the box");
            let (expected, _) = octree.evaluate(&leaf, [0.5; 3]);
            assert!((distance - expected).abs() <= 1e-5 * edge.max(expected.abs()), "{name} at {centre:?}");
        }
        assert_eq!(
            octree.unblended([0, 1, 2].map(|axis: usize| 2.0 * max[axis] - min[axis])),
            None,
            "{name}: outside the box"
        );

        let is_blended = octree.overlap() > 0.0;
        assert_eq!(octree.continuity(), if is_blended { Continuity::C1 } else { Continuity::None }, "{name}");
        blended.insert(is_blended);
    }
    assert_eq!(blended.len(), 2, "octrees that blend, and that do not");
}

/// What a user reads: a rule without a capital at the start or a full stop at the end, and none twice.
#[test]
fn errors_are_sentences_to_put_into_others() {
    let mut texts = BTreeSet::new();
    for name in names(&folder("invalid")) {
        let bytes = read(&folder("invalid"), &name);
        let error = Field::open(&bytes).and_then(|field| field.validate()).expect_err("an error");
        texts.insert((error.to_string(), format!("{error:?}")));
    }
    let variants: BTreeSet<_> = texts.iter().map(|(_, variant)| variant).collect();
    let sentences: BTreeSet<_> = texts.iter().map(|(text, _)| text).collect();
    assert_eq!(variants.len(), texts.len());
    assert_eq!(sentences.len(), texts.len(), "two errors say the same");

    let other = NotASimilarity.to_string();
    for text in sentences.into_iter().chain([&other]) {
        assert!(text.starts_with(char::is_lowercase) && !text.ends_with('.'), "{text:?}");
        assert!(text.split_whitespace().count() > 3, "{text:?}");
    }
}

/// The package for JavaScript has the words beside its modules, which give the number of an error alone.
#[test]
fn the_words_of_errors_in_javascript_are_those_of_the_reader() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../runtime/wasm/ts/rules.ts");
    let head = "\
/** What a file may break, by its name in SPEC.md §13: the words, in the order of the numbers that `open` gives, from 1. */
// Written by `NEARFIELD_WRITE_RULES=1 cargo test --package conformance javascript` from the reader's own.
export const RULES = {
";
    let rules: String = Error::ALL.iter().map(|error| format!("  {error:?}: {:?},\n", error.text())).collect();
    let expected = format!("{head}{rules}}} as const;\n");
    if env::var_os("NEARFIELD_WRITE_RULES").is_some() {
        fs::write(path, &expected).expect("the words");
    }
    let numbers: Vec<usize> = Error::ALL.iter().map(|&error| error as usize).collect();
    assert_eq!(numbers, (0..Error::ALL.len()).collect::<Vec<_>>(), "the order is that of the numbers");
    assert_eq!(fs::read_to_string(path).expect("the words"), expected, "stale: the file says how to write it");
}

#[test]
fn an_instance_is_of_its_field_and_as_large_as_its_axes() {
    let name = names(&folder("valid")).into_iter().next().expect("a vector");
    let bytes = read(&folder("valid"), &name);
    let field = Field::open(&bytes).expect("a field");
    let axes = [[0.0, 3.0, 0.0], [-3.0, 0.0, 0.0], [0.0, 0.0, 3.0]];
    let instance = Instance::new(field, axes, [1.0, 2.0, 3.0]).expect("a similarity");
    assert_eq!(instance.scale(), 3.0);
    assert_eq!(instance.field().header(), field.header());
    for [x, y, z] in points(field.header().bounds) {
        let point = [1.0 - 3.0 * y, 2.0 + 3.0 * x, 3.0 + 3.0 * z];
        let expected = 3.0 * field.distance([x, y, z]);
        let distance = instance.distance(point);
        assert!((distance - expected).abs() <= 1e-4 * (1.0 + expected.abs()), "{distance} is not {expected}");
    }
    assert_eq!(Instance::new(field, [axes[0]; 3], [0.0; 3]).err(), Some(NotASimilarity));
    assert_eq!(Instance::new(field, axes, [f32::NAN, 0.0, 0.0]).err(), Some(NotASimilarity));
}

use crate::shapes;
use nearfield::{Error, Field};
use nearfield_bake::bake;
use nearfield_bake::progress::Silent;
use nearfield_bake::settings::{Layout, Settings, Target};

fn small_file() -> Vec<u8> {
    let error = Target::Relative(0.02);
    let settings =
        Settings { error, start_depth: 1, max_depth: 3, samples: 1_000, layout: Layout::Octree, ..Settings::default() };
    let bytes = bake(&shapes::cuboid(), &settings, &Silent).expect("the mesh bakes").bytes;
    assert!((1_000..20_000).contains(&bytes.len()), "{} bytes: too few to tell, or too many to try", bytes.len());
    bytes
}

fn check(bytes: &[u8]) -> Result<(), Error> {
    Field::open(bytes)?.validate()
}

#[test]
fn every_truncation_is_refused_at_the_door() {
    let bytes = small_file();
    assert_eq!(check(&bytes), Ok(()));

    for length in 0..bytes.len() {
        assert!(Field::open(&bytes[..length]).is_err(), "{length} of {} bytes", bytes.len());
    }
}

#[test]
fn a_trailing_byte_is_refused_at_the_door() {
    let mut bytes = small_file();
    bytes.push(0);

    assert_eq!(Field::open(&bytes).err(), Some(Error::FileLength));
}

#[test]
fn every_flipped_bit_is_found() {
    let mut bytes = small_file();
    for bit in 0..8 * bytes.len() {
        let mask = 1 << (bit % 8);
        bytes[bit / 8] ^= mask;
        assert!(check(&bytes).is_err(), "bit {bit}");
        bytes[bit / 8] ^= mask;
    }
    assert_eq!(check(&bytes), Ok(()));
}

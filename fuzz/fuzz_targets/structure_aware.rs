#![no_main]

use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use nearfield_fuzz::structure::{Choices, mutate, repair};

fuzz_target!(|bytes: &[u8]| nearfield_fuzz::structure_aware(bytes));

fuzz_mutator!(|bytes: &mut [u8], length: usize, capacity: usize, seed: u32| {
    let mut choices = Choices::new(seed);
    let length = match choices.below(4) {
        0 => fuzzer_mutate(bytes, length, capacity),
        _ => mutate(bytes, length, &mut choices),
    };
    repair(&mut bytes[..length]);
    length
});

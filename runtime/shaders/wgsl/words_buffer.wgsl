// The bytes of a file, as they are, in a storage buffer.

@group(0) @binding(0) var<storage, read> words: array<u32>;

// Little-endian word of the file; 0 beyond its end.
fn word(index: u32) -> u32 {
    if index < arrayLength(&words) {
        return words[index];
    }
    return 0u;
}

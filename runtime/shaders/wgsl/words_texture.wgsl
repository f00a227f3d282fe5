// The bytes of a file, as they are, in a texture of four words a texel, row after row: for WebGL2, which has no storage
// buffers. Texels after the last one are zero.

@group(0) @binding(0) var words: texture_2d<u32>;

// Little-endian word of the file; 0 beyond its end.
fn word(index: u32) -> u32 {
    let size = textureDimensions(words);
    let texel = index / 4u;
    let row = texel / size.x;
    if row >= size.y {
        return 0u;
    }
    return textureLoad(words, vec2<i32>(vec2(texel - row * size.x, row)), 0)[index & 3u];
}

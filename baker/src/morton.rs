//! The Morton curve through a cubic lattice: neighbours along it are mostly neighbours in space.

use glam::UVec3;

/// Bits of each coordinate.
pub const BITS: u32 = 21;

/// Interleaves the bits of three coordinates below 2²¹, x lowest.
pub fn encode(vertex: UVec3) -> u64 {
    let spread = |t: u32| {
        let t = u64::from(t);
        let t = (t | t << 32) & 0x001f_0000_0000_ffff;
        let t = (t | t << 16) & 0x001f_0000_ff00_00ff;
        let t = (t | t << 8) & 0x100f_00f0_0f00_f00f;
        let t = (t | t << 4) & 0x10c3_0c30_c30c_30c3;
        (t | t << 2) & 0x1249_2492_4924_9249
    };
    spread(vertex.x) | spread(vertex.y) << 1 | spread(vertex.z) << 2
}

/// The inverse of [`encode`].
pub fn decode(code: u64) -> UVec3 {
    let gather = |code: u64| {
        let t = code & 0x1249_2492_4924_9249;
        let t = (t | t >> 2) & 0x10c3_0c30_c30c_30c3;
        let t = (t | t >> 4) & 0x100f_00f0_0f00_f00f;
        let t = (t | t >> 8) & 0x001f_0000_ff00_00ff;
        let t = (t | t >> 16) & 0x001f_0000_0000_ffff;
        (t | t >> 32) as u32 & 0x001f_ffff
    };
    UVec3::new(gather(code), gather(code >> 1), gather(code >> 2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn codes_are_reversible_and_ordered_by_octants() {
        for v in [UVec3::ZERO, UVec3::new(1, 2, 3), UVec3::splat((1 << BITS) - 1), UVec3::new(1 << 20, 7, 12345)] {
            assert_eq!(decode(encode(v)), v);
        }
        assert!(encode(UVec3::new(7, 7, 7)) < encode(UVec3::new(8, 0, 0)));
    }
}

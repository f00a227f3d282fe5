//! What crosses by value.

/// A point, direction or gradient.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearfieldVector {
    /// Along the x axis of the mesh.
    pub x: f32,
    /// Along its y axis.
    pub y: f32,
    /// Along its z axis.
    pub z: f32,
}

/// A distance and its gradient.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearfieldSample {
    /// Signed distance, mesh units, negative inside.
    pub distance: f32,
    /// Where the distance grows and how fast; its length is near 1, but not normalized.
    pub gradient: NearfieldVector,
}

impl NearfieldVector {
    pub(crate) const NAN: Self = Self { x: f32::NAN, y: f32::NAN, z: f32::NAN };
}

impl NearfieldSample {
    pub(crate) const NAN: Self = Self { distance: f32::NAN, gradient: NearfieldVector::NAN };
}

impl From<NearfieldVector> for [f32; 3] {
    fn from(vector: NearfieldVector) -> Self {
        // Taken apart it would be written one by one and read together, for which processors wait.
        // SAFETY: three numbers one after the other, either way.
        unsafe { core::mem::transmute(vector) }
    }
}

impl From<[f32; 3]> for NearfieldVector {
    fn from([x, y, z]: [f32; 3]) -> Self {
        Self { x, y, z }
    }
}

impl From<(f32, [f32; 3])> for NearfieldSample {
    fn from((distance, gradient): (f32, [f32; 3])) -> Self {
        Self { distance, gradient: gradient.into() }
    }
}

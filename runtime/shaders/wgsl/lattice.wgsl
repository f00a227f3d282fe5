// What octrees share.

// Number of the child that holds a finest cell, of a node whose children have edges of 2 to the power of `shift`.
fn octant_of(cell: vec3<u32>, shift: u32) -> u32 {
    let half = (cell >> vec3(shift)) & vec3(1u);
    return half.x | (half.y << 1u) | (half.z << 2u);
}

// Number of the root cell that holds a finest cell.
fn root_of(field: Field, cell: vec3<u32>) -> u32 {
    let root = cell >> vec3(field.depth);
    return root.x + field.counts.x * (root.y + field.counts.y * root.z);
}

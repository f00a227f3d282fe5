//! Writes a bumpy sphere of about as many triangles as asked for: `make_sphere TRIANGLES OUT.ply`.
//!
//! An icosahedron whose faces are divided into n² triangles each, with three octaves of waves on it; binary PLY.

use glam::DVec3;
use std::error::Error;
use std::fs::File;
use std::io::{BufWriter, Write};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().collect();
    let [_, triangles, path] = arguments.as_slice() else { return Err("usage: make_sphere TRIANGLES OUT.ply".into()) };
    let divisions = (triangles.parse::<f64>()? / 20.0).sqrt().round().max(1.0) as u32;
    let (corners, faces) = icosahedron();

    // Each face has vertices of its own; those on its sides are the same to the last bit as its neighbours', so that they
    // weld.
    let per_face = (divisions + 1) * (divisions + 2) / 2;
    let mut out = BufWriter::new(File::create(path)?);
    write!(
        out,
        "ply\nformat binary_little_endian 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n\
         element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        20 * per_face,
        20 * divisions * divisions
    )?;
    for face in faces {
        for row in 0..=divisions {
            for column in 0..=divisions - row {
                // The sum is taken in the order of the corners, whatever the face.
                let mut shares = [(face[0], divisions - row - column), (face[1], column), (face[2], row)];
                shares.sort_unstable();
                let point: DVec3 = shares.into_iter().map(|(corner, share)| corners[corner] * f64::from(share)).sum();
                for coordinate in bumpy(point.normalize()).to_array() {
                    out.write_all(&(coordinate as f32).to_le_bytes())?;
                }
            }
        }
    }
    for face in 0..20 {
        let start = |row: u32| face * per_face + row * (2 * divisions + 3 - row) / 2;
        for row in 0..divisions {
            for column in 0..divisions - row {
                let [a, b] = [start(row) + column, start(row + 1) + column];
                write_triangle(&mut out, [a, a + 1, b])?;
                if column + 1 < divisions - row {
                    write_triangle(&mut out, [a + 1, b + 1, b])?;
                }
            }
        }
    }
    out.flush()?;
    Ok(())
}

fn write_triangle(out: &mut impl Write, corners: [u32; 3]) -> std::io::Result<()> {
    out.write_all(&[3])?;
    corners.iter().try_for_each(|corner| out.write_all(&corner.to_le_bytes()))
}

fn bumpy(direction: DVec3) -> DVec3 {
    let wave = |frequency: f64, phase: f64| {
        libm::sin(frequency * direction.x + phase)
            * libm::sin(frequency * direction.y + 2.0 * phase)
            * libm::sin(frequency * direction.z + 3.0 * phase)
    };
    direction * (1.0 + 0.1 * wave(5.0, 0.3) + 0.02 * wave(23.0, 1.1) + 0.004 * wave(101.0, 2.3))
}

fn icosahedron() -> ([DVec3; 12], [[usize; 3]; 20]) {
    let golden = 0.5 * (1.0 + 5.0f64.sqrt());
    let mut corners = [DVec3::ZERO; 12];
    for (index, corner) in corners.iter_mut().enumerate() {
        let (one, long) = (if index & 1 == 0 { -1.0 } else { 1.0 }, if index & 2 == 0 { -golden } else { golden });
        *corner = [DVec3::new(0.0, one, long), DVec3::new(one, long, 0.0), DVec3::new(long, 0.0, one)][index / 4];
    }
    // Three corners that are each other's neighbours are a face; it is wound to face outward.
    let mut faces = [[0; 3]; 20];
    let near = |a: usize, b: usize| corners[a].distance_squared(corners[b]) < 4.5;
    let triples = (0..12).flat_map(|a| (a + 1..12).flat_map(move |b| (b + 1..12).map(move |c| [a, b, c])));
    let found = triples.filter(|&[a, b, c]| near(a, b) && near(b, c) && near(c, a));
    for (face, [a, b, c]) in faces.iter_mut().zip(found) {
        let faces_outward = corners[a].dot(corners[b].cross(corners[c])) > 0.0;
        *face = if faces_outward { [a, b, c] } else { [a, c, b] };
    }
    (corners, faces)
}

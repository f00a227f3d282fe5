//! Mass, centre and inertia of the inside of a field.

use nearfield::Field;
use rapier3d::math::{Matrix, Real, Vector};
use rapier3d::parry::mass_properties::MassProperties;

/// Cells along each side of the field's box: 262 144 queries, once a shape.
const CELLS: u16 = 64;

/// Sums cells, of which those at the surface count in part.
pub(crate) fn mass_properties(field: &Field<'_>, density: Real) -> MassProperties {
    let bounds = field.header().bounds;
    let origin = Vector::from(bounds.min);
    let cell = (Vector::from(bounds.max) - origin) / Real::from(CELLS);
    let width = cell.element_sum() / 3.0;

    // Sums in f64: many small numbers.
    let (mut volume, mut first, mut second) = (0.0_f64, [0.0_f64; 3], [[0.0_f64; 3]; 3]);
    for (x, y, z) in cells() {
        let centre = origin + cell * (Vector::new(x, y, z) + 0.5);
        // A ramp of half a cell: a wider one weighs what is curved too heavy, a steeper one counts single cells.
        let inside = f64::from((0.5 - 2.0 * field.distance(centre.into()) / width).clamp(0.0, 1.0));
        if inside == 0.0 {
            continue;
        }
        let at = centre.to_array().map(f64::from);
        volume += inside;
        for row in 0..3 {
            first[row] += inside * at[row];
            for column in 0..3 {
                second[row][column] += inside * at[row] * at[column];
            }
        }
    }
    if volume == 0.0 {
        return MassProperties::default();
    }

    // Second moments about the centre of mass, and from them the inertia.
    let centre = first.map(|sum| sum / volume);
    let cell_mass = f64::from(density) * f64::from(cell.x) * f64::from(cell.y) * f64::from(cell.z);
    let moment = |row: usize, column: usize| cell_mass * (second[row][column] - volume * centre[row] * centre[column]);
    let trace = moment(0, 0) + moment(1, 1) + moment(2, 2);
    let inertia = |row: usize, column: usize| {
        let diagonal = if row == column { trace } else { 0.0 };
        (diagonal - moment(row, column)) as Real
    };
    let columns = [0, 1, 2].map(|column| Vector::new(inertia(0, column), inertia(1, column), inertia(2, column)));

    let centre = Vector::from(centre.map(|coordinate| coordinate as Real));
    let inertia = Matrix::from_cols(columns[0], columns[1], columns[2]);
    MassProperties::with_inertia_matrix(centre, (cell_mass * volume) as Real, inertia)
}

fn cells() -> impl Iterator<Item = (Real, Real, Real)> {
    let along = || (0..CELLS).map(Real::from);
    along().flat_map(move |z| along().flat_map(move |y| along().map(move |x| (x, y, z))))
}

//! The surface of a box as a grid.

use std::collections::BTreeMap;

/// The triangles of a box with these numbers of squares along its axes, counter-clockwise seen from outside. `vertex`
/// makes the vertex at a place of the grid, and returns its number; it is called once for each place.
pub(crate) fn box_triangles(
    squares: [usize; 3],
    mut vertex: impl FnMut([usize; 3]) -> u32,
) -> Vec<[u32; 3]> {
    let mut numbers: BTreeMap<[usize; 3], u32> = BTreeMap::new();
    let mut triangles = Vec::new();
    for (axis, end) in (0..3).flat_map(|axis| [(axis, 0), (axis, squares[axis])]) {
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        for (i, j) in (0..squares[u]).flat_map(|i| (0..squares[v]).map(move |j| (i, j))) {
            let mut quad = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| {
                let mut place = [end; 3];
                (place[u], place[v]) = (i, j);
                *numbers.entry(place).or_insert_with(|| vertex(place))
            });
            if end == 0 {
                quad.reverse();
            }
            // Diagonals run towards the middle of a side, so that all corners are alike.
            if (2 * i < squares[u]) != (2 * j < squares[v]) {
                quad.rotate_left(1);
            }
            let [a, b, c, d] = quad;
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    triangles
}

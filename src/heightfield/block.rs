//! The block of ground under a pavement: a sheet with a rim, walls and a bottom.

use crate::order::lesser;
use crate::solid::Surface;
use glam::Vec3;

/// Colour of the cut faces at the top and at the bottom, relative to the mean colour of the ground along the
/// edges.
const CUT: [f32; 2] = [1.0, 0.75];

/// A sheet of `n` squares a side with a plain rim around it, `by` wide, of the mean colour and height of its edges. The
/// result has `n` + 4 squares a side, of which two rings are the rim and a seam without area.
pub(super) fn widened(sheet: &Surface, n: usize, by: f32) -> Surface {
    let (height, colour) = mean_edge(sheet, n);
    let wide = n + 4;
    let moved = |k: usize| match k {
        0 => -by,
        k if k == wide => by,
        _ => 0.0,
    };
    let mut rimmed = Surface::default();
    for place in grid(wide + 1) {
        let [i, j] = place.map(|k| k.clamp(2, n + 2) - 2);
        let source = j * (n + 1) + i;
        let mut p = sheet.positions[source];
        if !place.iter().all(|k| (1..wide).contains(k)) {
            let [x, y] = place.map(moved);
            p = Vec3::new(p.x + x, p.y + y, height);
        }
        let is_own = place.iter().all(|k| (2..=n + 2).contains(k));
        let (colour, normal) = match is_own {
            true => (sheet.colours[source], sheet.normals[source]),
            false => (colour, Vec3::Z),
        };
        rimmed.positions.push(p);
        rimmed.colours.push(colour);
        rimmed.normals.push(normal);
    }
    rimmed.triangles = rimmed_triangles(n);
    rimmed
}

/// The mean height and colour along the edges of a sheet.
fn mean_edge(sheet: &Surface, n: usize) -> (f32, [u8; 3]) {
    let places = grid(n + 1).enumerate();
    let on_edge = places.filter(|(_, place)| place.iter().any(|k| [0, n].contains(k)));
    let edge: Vec<usize> = on_edge.map(|(k, _)| k).collect();
    let count = edge.len() as f32;
    let height = edge.iter().map(|&k| sheet.positions[k].z).sum::<f32>() / count;
    let colours = edge
        .iter()
        .map(|&k| Vec3::from(sheet.colours[k].map(f32::from)));
    let colour = (colours.sum::<Vec3>() / count).to_array();
    (height, colour.map(|v| v as u8))
}

/// The triangles of a sheet of `n` squares a side with its rim. The seam has none.
fn rimmed_triangles(n: usize) -> Vec<[u32; 3]> {
    let row = n + 5;
    let is_flat = |k: &usize| [1, n + 2, n + 4].contains(k);
    let squares = grid(row).filter(|place| !place.iter().any(is_flat));
    let halves = squares.flat_map(|[i, j]| {
        let a = (j * row + i) as u32;
        let c = a + row as u32;
        [[a, a + 1, c + 1], [a, c + 1, c]]
    });
    halves.collect()
}

/// The columns and rows of a square grid, row by row.
fn grid(side: usize) -> impl Iterator<Item = [usize; 2]> {
    (0..side).flat_map(move |j| (0..side).map(move |i| [i, j]))
}

/// Turns a sheet with `n` squares a side into a block: adds walls along its edges and a bottom.
pub(super) fn cut_off(sheet: &mut Surface, n: usize, thick: f32) {
    let row = n + 1;
    // The four sides, clockwise on screen seen from above: the wall's normal, and the grid points along it.
    let sides: [(Vec3, &dyn Fn(usize) -> usize); 4] = [
        (Vec3::NEG_Y, &|k| k),
        (Vec3::X, &|k| k * row + n),
        (Vec3::Y, &|k| n * row + n - k),
        (Vec3::NEG_X, &|k| (n - k) * row),
    ];
    // Each wall has one colour: single grains of sand would make streaks.
    let mut mean = Vec3::ZERO;
    for (_, place) in &sides {
        let colours = (0..n).map(|k| sheet.colours[place(k)]);
        mean += colours.map(|c| Vec3::from(c.map(f32::from))).sum::<Vec3>() / (4 * n) as f32;
    }
    let cut = CUT.map(|part| (mean * part).to_array().map(|v| v as u8));
    for (normal, place) in sides {
        let first = sheet.positions.len() as u32;
        for k in 0..=n {
            let p = sheet.positions[place(k)];
            for (z, colour) in [(p.z, cut[0]), (-thick, cut[1])] {
                sheet.positions.push(Vec3::new(p.x, p.y, lesser(z, p.z)));
                sheet.normals.push(normal);
                sheet.colours.push(colour);
            }
        }
        for k in 0..n as u32 {
            let [a, b, c, d] = [0, 1, 2, 3].map(|v| first + 2 * k + v);
            sheet.triangles.extend([[a, b, c], [b, d, c]]);
        }
    }
    let first = sheet.positions.len() as u32;
    for place in [0, n, n * row, n * row + n] {
        let p = sheet.positions[place];
        sheet.positions.push(Vec3::new(p.x, p.y, -thick));
        sheet.normals.push(Vec3::NEG_Z);
        sheet.colours.push(cut[1]);
    }
    let [a, b, c, d] = [0, 1, 2, 3].map(|v| first + v);
    sheet.triangles.extend([[a, c, b], [b, c, d]]);
}

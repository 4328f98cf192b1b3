//! Heights at the points of a square grid over the picture, coarser or finer than its pixels, and the ground
//! between and under the stones as a sheet on such a grid.

use super::{GROUND, Planes};
use crate::order::{greater, lesser};
use crate::solid::{Surface, normals};
use glam::Vec3;
use std::ops::Range;

/// Search radius for the ground around a grid point, in pixels: pixels beside a stone show some of the stone,
/// too.
const AROUND: f32 = 1.5;

/// The columns, or rows, within `reach` pixels of grid line `k` of `n` squares a side. On a tile they
/// continue beyond its edges.
fn around(planes: &Planes, n: usize, k: usize, reach: f32) -> Range<i32> {
    let side = planes.side as i32;
    let middle = match planes.tile && k == n {
        true => 0.0,
        false => k as f32 * side as f32 / n as f32,
    };
    let (from, to) = (
        (middle - reach).floor() as i32,
        (middle + reach).ceil() as i32,
    );
    match planes.tile {
        true => from..to,
        false => lesser(greater(from, 0), side - 1)..lesser(to, side),
    }
}

/// The mean heights around the points of a grid row, in picture units above the base level. The grid has `n`
/// squares a side, so a row has `n` + 1 points; the first and the last of a tile are equal.
pub fn means(planes: &Planes, n: usize, row: usize) -> Vec<f32> {
    let side = planes.side as i32;
    let half = greater(0.5 * side as f32 / n as f32, 0.5);
    let wrapped = |v: i32| v.rem_euclid(side) as usize;
    let mean = |column: usize| {
        let (mut sum, mut count) = (0.0, 0.0);
        for y in around(planes, n, row, half).map(wrapped) {
            for x in around(planes, n, column, half).map(wrapped) {
                sum += planes.bump[y * planes.side + x];
                count += 1.0;
            }
        }
        sum / greater(count, 1.0)
    };
    (0..=n).map(mean).collect()
}

/// The ground as a sheet of `n` by `n` squares over the whole picture. Under stones it is flat, below their
/// base, and has the colour of the ground beside them.
pub fn ground(planes: &Planes, n: usize) -> Surface {
    let mut sheet = GroundSheet::new(n);
    while !sheet.advance(planes) {}
    sheet.finish(planes)
}

/// The sheet of [`ground`], in progress, row by row.
pub(super) struct GroundSheet {
    n: usize,
    row: usize,
    /// The last colour of the ground found.
    colour: [u8; 3],
    sheet: Surface,
}

impl GroundSheet {
    /// For a grid of `n` squares along a side.
    pub fn new(n: usize) -> Self {
        Self {
            n,
            row: 0,
            colour: [128; 3],
            sheet: Surface::default(),
        }
    }

    /// Makes the next row of points; true after the last one.
    pub fn advance(&mut self, planes: &Planes) -> bool {
        let (n, j, sheet) = (self.n, self.row, &mut self.sheet);
        let half = greater(0.5 * planes.side as f32 / n as f32, AROUND);
        let unit = planes.side as f32 / (n * planes.pixel_scale) as f32;
        let rows = around(planes, n, j, half);
        for i in 0..=n {
            let mut height = planes.ground;
            if let Some(bare) = bare(planes, around(planes, n, i, half), rows.clone()) {
                (height, self.colour) = bare;
            }
            let place = Vec3::new(i as f32 * unit, j as f32 * unit, height);
            sheet.positions.push(place);
            sheet.colours.push(self.colour);
            if i < n && j < n {
                let a = (j * (n + 1) + i) as u32;
                let c = a + n as u32 + 1;
                sheet.triangles.extend([[a, a + 1, c + 1], [a, c + 1, c]]);
            }
        }
        self.row += 1;
        self.row > n
    }

    /// The finished sheet.
    pub fn finish(self, planes: &Planes) -> Surface {
        let (n, mut sheet) = (self.n, self.sheet);
        sheet.normals = normals(&sheet.positions, &sheet.triangles);
        if planes.tile {
            // Opposite edges of a tile get equal normals: first the ends of all columns, then those of all rows.
            for (apart, step) in [(n * (n + 1), 1), (n, n + 1)] {
                for a in (0..=n).map(|k| k * step) {
                    let mean = (sheet.normals[a] + sheet.normals[a + apart]).normalize_or(Vec3::Z);
                    (sheet.normals[a], sheet.normals[a + apart]) = (mean, mean);
                }
            }
        }
        sheet
    }
}

/// The height of the lowest ground pixel in these columns and rows, and the colour of the last one, as the lowest may
/// be darker than others. `None` if there is no ground.
fn bare(planes: &Planes, columns: Range<i32>, rows: Range<i32>) -> Option<(f32, [u8; 3])> {
    let side = planes.side as i32;
    let mut found: Option<(f32, [u8; 3])> = None;
    for y in rows {
        for x in columns.clone() {
            let at = (y.rem_euclid(side) * side + x.rem_euclid(side)) as usize;
            if planes.id[at] == GROUND {
                let low = found.map_or(f32::MAX, |(low, _)| low);
                found = Some((lesser(low, planes.bump[at]), planes.colour[at]));
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ground of height 1 with a stone of height 9 at the centre.
    fn planes(tile: bool) -> Planes {
        let mut planes = Planes::new(16);
        planes.tile = tile;
        for at in 0..256 {
            let stone = (4..12).contains(&(at % 16)) && (4..12).contains(&(at / 16));
            planes.id[at] = u32::from(stone);
            planes.bump[at] = if stone {
                9.0
            } else {
                1.0 + (at % 16) as f32 / 64.0
            };
            planes.colour[at] = if stone { [200; 3] } else { [50, 40, 30] };
        }
        planes.ground = 1.5;
        planes
    }

    #[test]
    fn the_ground_knows_no_stones() {
        for tile in [false, true] {
            let sheet = ground(&planes(tile), 8);
            assert_eq!((sheet.positions.len(), sheet.triangles.len()), (81, 128));
            assert!(sheet.positions.iter().all(|p| (1.0..=1.5).contains(&p.z)));
            assert_eq!(sheet.positions[40], Vec3::new(8.0, 8.0, 1.5));
            assert!(sheet.colours.iter().all(|&c| c == [50, 40, 30]));
            assert!(sheet.normals.iter().all(|n| n.z > 0.8));
        }
    }

    #[test]
    fn a_tile_goes_on() {
        let planes = planes(true);
        let sheet = ground(&planes, 5);
        for k in 0..6 {
            assert_eq!(sheet.positions[6 * k].z, sheet.positions[6 * k + 5].z);
            assert_eq!(sheet.positions[k].z, sheet.positions[30 + k].z);
            assert_eq!(sheet.normals[6 * k], sheet.normals[6 * k + 5]);
        }
        for n in [3, 16, 40] {
            let row = means(&planes, n, n / 2);
            assert_eq!((row.len(), row[0]), (n + 1, row[n]));
            assert!(row.iter().all(|h| (1.0..=9.0).contains(h)));
        }
    }
}

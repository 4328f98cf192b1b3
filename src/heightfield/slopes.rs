//! Slopes of the bump plane.

use super::Planes;

/// The pixels before and after one of `n`; at an end the pixel itself, or on a tile the one at the other end.
pub(crate) fn beside(k: usize, n: usize, tile: bool) -> [usize; 2] {
    if tile {
        [(k + n - 1) % n, (k + 1) % n]
    } else {
        [k.saturating_sub(1), (k + 1).min(n - 1)]
    }
}

/// Rise of the surface to the right and downwards along a row of the bump plane; both lists are as long as
/// the row.
pub(crate) fn row_slopes(planes: &Planes, y: usize, to: &mut [Vec<f32>; 2]) {
    let side = planes.side;
    let row = |y: usize| &planes.bump[y * side..][..side];
    let [above, below] = beside(y, side, planes.tile);
    let rows = [row(above), row(y), row(below)];
    slopes(rows, planes.pixel_scale as f32, planes.tile, to);
}

/// Like [`row_slopes`], without the fine relief: the mean of central differences over up to `reach` pixels to each
/// side.
pub(crate) fn smooth_row_slopes(planes: &Planes, y: usize, reach: usize, to: &mut [Vec<f32>; 2]) {
    let (side, tile) = (planes.side, planes.tile);
    let moved = |k: usize, by: usize| match tile {
        true => [(k + side - by % side) % side, (k + by) % side],
        false => [k.saturating_sub(by), (k + by).min(side - 1)],
    };
    let row = |y: usize| &planes.bump[y * side..][..side];
    let [across, down] = to;
    across.fill(0.0);
    down.fill(0.0);
    for by in 1..=reach {
        let part = planes.pixel_scale as f32 / (2 * by * reach) as f32;
        let [above, below] = moved(y, by).map(row);
        for (x, (across, down)) in across.iter_mut().zip(&mut *down).enumerate() {
            let [left, right] = moved(x, by);
            // The mean of both rows also smooths across.
            *across += (above[right] - above[left] + below[right] - below[left]) * (0.5 * part);
            *down += (below[left] - above[left] + below[right] - above[right]) * (0.5 * part);
        }
    }
}

/// Rise of the surface to the right and downwards, from the rows above, here and below, which have
/// `pixel_scale` pixels for each picture unit. Central differences, smoothed across with the weights 1, 4, 1
/// (Sobel's are 1, 2, 1): otherwise rims would show the steps of pixels.
fn slopes(rows: [&[f32]; 3], pixel_scale: f32, tile: bool, slopes: &mut [Vec<f32>; 2]) {
    let [up, row, down] = rows;
    let n = row.len();
    let [across, fall] = slopes.each_mut().map(|slope| &mut slope[..n]);
    let rise = pixel_scale * (1.0 / 12.0);
    let at = |[left, x, right]: [usize; 3]| {
        let across = |row: &[f32]| row[right] - row[left];
        let along = |x: usize| down[x] - up[x];
        (
            (across(up) + 4.0 * across(row) + across(down)) * rise,
            (along(left) + 4.0 * along(x) + along(right)) * rise,
        )
    };
    for x in [0, n - 1] {
        let [left, right] = beside(x, n, tile);
        (across[x], fall[x]) = at([left, x, right]);
    }
    for x in 1..n - 1 {
        (across[x], fall[x]) = at([x - 1, x, x + 1]);
    }
}

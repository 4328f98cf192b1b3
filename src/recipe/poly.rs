//! The free polygon as rows of points, one for each ring.

use super::rows::{self, POINTS, STEPS};
use crate::domain::{MAX_POINTS, Outline};
use crate::notice::Notice;
use glam::DVec2;

fn map(outline: &Outline, f: impl Fn(DVec2) -> DVec2) -> Outline {
    let ring = |ring: &Vec<DVec2>| ring.iter().map(|&p| f(p)).collect();
    Outline {
        rings: outline.rings.iter().map(ring).collect(),
        lines: outline.lines.iter().map(ring).collect(),
    }
}

/// Moves every point to the nearest point of the grid.
pub fn snap(outline: &Outline, side: f64) -> Outline {
    map(outline, |p| (p * STEPS / side).round() * side / STEPS)
}

/// The same polygon in a picture of another side; exact for points of the grid.
pub fn resize(outline: &Outline, from: f64, to: f64) -> Outline {
    map(outline, |p| (p * STEPS / from).round() * to / STEPS)
}

/// The row of points that lie on the grid.
pub fn row(points: &[DVec2], side: f64) -> Vec<i64> {
    let steps = |p: &DVec2| (*p * STEPS / side).round().to_array();
    points.iter().flat_map(steps).map(|x| x as i64).collect()
}

/// The points of a row.
pub fn points(row: &[i64], side: f64) -> Vec<DVec2> {
    let point = |pair: &[i64]| DVec2::new(pair[0] as f64, pair[1] as f64) * side / STEPS;
    row.chunks_exact(2).map(point).collect()
}

/// The text of a polygon whose points lie on the grid.
pub fn encode(outline: &Outline, side: f64) -> String {
    let rows: Vec<Vec<i64>> = outline.rings.iter().map(|ring| row(ring, side)).collect();
    rows::encode(&rows, POINTS)
}

/// Reads what [`encode`] writes.
///
/// # Errors
/// A part of a sentence that says why the text is no polygon.
pub fn decode(text: &str, side: f64) -> Result<Outline, Notice> {
    let rows = rows::decode(text, POINTS, MAX_POINTS)?;
    Ok(Outline {
        rings: rows.iter().map(|row| points(row, side)).collect(),
        ..Outline::default()
    })
}

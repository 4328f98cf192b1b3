//! Painted items: turns rows of a recipe into strokes and spots, and a place in space into the numbers of a row.

use super::SurfaceEngine;
use crate::recipe::BOX_STEPS;
use crate::surface_field::{Stroke, SurfaceSpot};
use crate::surface_stones::Fit;
use crate::trimesh::{Search, TriMesh};
use glam::DVec3;

/// The strokes in these rows. Their width is `reach` times the longest side of the mesh's bounding box.
pub(super) fn strokes(
    mesh: &TriMesh,
    search: &Search,
    rows: &[Vec<i64>],
    reach: f64,
) -> Vec<Stroke> {
    let width = (reach * BOX_STEPS).round() as i64;
    let stroke = |row: &Vec<i64>| {
        let row: Vec<i64> = std::iter::once(width).chain(row.iter().copied()).collect();
        Stroke::from_row(mesh, search, &row)
    };
    rows.iter().filter_map(stroke).collect()
}

/// The spots in these rows: x, y and z, radius, value. Lengths are in longest sides of the mesh's bounding box.
pub(super) fn spots(mesh: &TriMesh, search: &Search, rows: &[[f64; 5]]) -> Vec<SurfaceSpot> {
    let (low, side) = mesh.bounding_cube();
    let spot = |&[x, y, z, radius, value]: &[f64; 5]| SurfaceSpot {
        at: search.closest(mesh, low + DVec3::new(x, y, z) * side),
        radius: radius * side,
        value,
    };
    rows.iter().map(spot).collect()
}

/// The place in space for three whole numbers of a row.
fn place(mesh: &TriMesh, numbers: [i64; 3]) -> DVec3 {
    let (low, side) = mesh.bounding_cube();
    low + DVec3::from(numbers.map(|n| n as f64)) * (side / BOX_STEPS)
}

/// The three whole numbers by which rows hold a place in space.
fn numbers(mesh: &TriMesh, p: DVec3) -> [i64; 3] {
    let (low, side) = mesh.bounding_cube();
    ((p - low) / side * BOX_STEPS)
        .round()
        .to_array()
        .map(|x| x as i64)
}

impl SurfaceEngine {
    /// The place of the model at a pixel of the last finished frame, as in rows of strokes and spots; `None` beside
    /// the model.
    pub(super) fn traced_place(&self, x: usize, y: usize) -> Option<[i64; 3]> {
        let seen = self.picture.place_at(x, y)?.as_dvec3();
        let built = self.made.last_built()?;
        let fit = Fit::new(&built.whole);
        Some(numbers(&built.mesh, seen / fit.scale + fit.middle))
    }

    /// The pixel of a row's place in the last finished frame; `None` if the place is not visible there.
    pub(super) fn traced_pixel(&self, numbers: [i64; 3]) -> Option<[f64; 2]> {
        let built = self.made.last_built()?;
        let fit = Fit::new(&built.whole);
        self.picture
            .pixel_of(fit.place(place(&built.mesh, numbers)))
    }
}

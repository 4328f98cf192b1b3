//! The grid lines of a plan, for drawing.

use super::face_grid::{NEAR, edges, fixed_lines, joints, place};
use super::whole::{Plan, is_of_opening};
use crate::building::{Building, FaceId};

/// A line of a face's grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridLine {
    /// The face.
    pub face: FaceId,
    /// Whether it lies between two rows; else it lies between two columns.
    pub is_row: bool,
    /// Whether s is constant along it; else t is.
    pub is_of_s: bool,
    /// The constant s or t (metres).
    pub at: f64,
    /// Whether a corner or a springing of an opening lies on it.
    pub is_opening: bool,
}

/// All lines of a plan: for each face those of s, then those of t, rising.
pub fn grid_lines(building: &Building, plan: &Plan) -> Vec<GridLine> {
    building
        .face_ids()
        .flat_map(|face| {
            let grid = plan.grid(face);
            let openings = opening_places(building, face);
            let of = move |is_of_s: bool, lines: &[f64], openings: &[f64]| -> Vec<GridLine> {
                let is_near =
                    |at: f64| openings.iter().any(|place| (place - at).abs() < 2.0 * NEAR);
                let line = |&at: &f64| GridLine {
                    face,
                    is_row: is_of_s == grid.are_rows_along_s(),
                    is_of_s,
                    at,
                    is_opening: is_near(at),
                };
                lines.iter().map(line).collect()
            };
            [
                of(true, &grid.s, &openings[0]),
                of(false, &grid.t, &openings[1]),
            ]
            .concat()
        })
        .collect()
}

/// The s and the t of the ends and springings of a face's edges at openings (metres).
fn opening_places(building: &Building, id: FaceId) -> [Vec<f64>; 2] {
    let face = building.face(id);
    let own = edges(face).filter(|&edge| is_of_opening(building, edge));
    let places = own.flat_map(|edge| joints(building, edge));
    let places: Vec<_> = places.map(|(p, _)| place(face, p)).collect();
    [
        places.iter().map(|place| place.x).collect(),
        places.iter().map(|place| place.y).collect(),
    ]
}

impl Plan {
    /// The parts of walls in which a column more or less has removed a conflict: the wall, and the interval of s
    /// (metres).
    pub fn changed(&self, building: &Building) -> Vec<(FaceId, [f64; 2])> {
        let part = |change: &super::Change| {
            let face = FaceId(change.wall);
            let [fixed, _] = fixed_lines(building, face, self.module.half);
            let from = change.interval as usize;
            (face, [fixed[from], fixed[from + 1]])
        };
        self.changes.iter().map(part).collect()
    }
}

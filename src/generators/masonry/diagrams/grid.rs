//! The plan: the lines of all faces' grids (Legakis, Dorsey, Gortler 2001, Feature-based cellular texturing for
//! architectural models, section 5.1).

use super::plates::{Plates, Sheet};
use super::{MAP, faces};
use crate::building::FaceId;
use crate::masonry::footprint::Footprint;
use crate::masonry::laying::Laying;
use crate::masonry::plan::{GridLine, grid_lines};
use crate::scene::Scene;
use crate::surface_stones::Fit;
use glam::DVec2;
use std::collections::BTreeSet;

/// The colours of lines between columns, of lines between rows, and of those at openings.
const COLUMNS: [u8; 3] = [220, 124, 24];
const ROWS: [u8; 3] = [44, 92, 160];
const OPENINGS: [u8; 3] = [206, 44, 66];
/// Half the width of a line, and of a line at an opening, in modules (half bricks).
const HALF: f64 = 0.08;
const WIDE: f64 = 0.13;
/// The distance between two levels of lines, and of the first one from the face (metres).
const HEIGHT: f64 = 1e-3;

/// The lines of all faces that the pattern reaches.
pub(in crate::generators::masonry) fn lines(laying: &Laying) -> Vec<GridLine> {
    let faces: BTreeSet<FaceId> = laying.textured_faces().collect();
    let mut lines = grid_lines(laying.building(), laying.plan());
    lines.retain(|line| faces.contains(&line.face));
    lines
}

/// Adds the lines of all faces; the id of a body is that of its face.
pub(super) fn add(scene: &mut Scene, laying: &Laying, fit: Fit) {
    let lines = lines(laying);
    for (id, number) in faces(laying) {
        let face = laying.building().face(id);
        let sheet = Sheet::new(face);
        let mut plates = Plates::new(face, fit);
        let bounds = face.bounds();
        for line in lines.iter().filter(|line| line.face == id) {
            let (colour, level) = look(line);
            let part = if line.is_opening { WIDE } else { HALF };
            let ribbon = ribbon(line, bounds, part * laying.plan().module.half);
            for part in ribbon.iter().flat_map(|ribbon| sheet.within(ribbon)) {
                plates.add(&part, HEIGHT * level, colour);
            }
        }
        plates.finish(scene, (number, MAP));
    }
}

/// The colour of a line, and its level from 1: lines on a higher level hide those below.
fn look(line: &GridLine) -> ([u8; 3], f64) {
    match (line.is_opening, line.is_row) {
        (true, _) => (OPENINGS, 3.0),
        (false, true) => (ROWS, 2.0),
        (false, false) => (COLUMNS, 1.0),
    }
}

/// The ribbon along a line within bounds.
fn ribbon(line: &GridLine, [low, high]: [DVec2; 2], half: f64) -> Option<Footprint> {
    let (from, to) = (line.at - half, line.at + half);
    match line.is_of_s {
        true => Footprint::rectangle(DVec2::new(from, low.y), DVec2::new(to, high.y)),
        false => Footprint::rectangle(DVec2::new(low.x, from), DVec2::new(high.x, to)),
    }
}

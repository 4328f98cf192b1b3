//! Parity: which way the bricks of upright edges point, and the phases of walls (Legakis, Dorsey, Gortler 2001,
//! Feature-based cellular texturing for architectural models, section 5.2).

use super::plates::{Plates, Sheet};
use super::{MAP, faces, id_of};
use crate::building::{EdgeId, FaceId};
use crate::masonry::footprint::Footprint;
use crate::masonry::laying::{Feature, Laying};
use crate::masonry::plan::is_wall;
use crate::scene::Scene;
use crate::surface_stones::Fit;
use glam::DVec2;

/// The colours of walls of either phase.
const PHASES: [[u8; 3]; 2] = [[186, 202, 220], [232, 214, 176]];
/// The colour of columns that were added or removed.
const CHANGED: [u8; 3] = [206, 132, 190];
/// The colours of stretchers and headers, and of both at a conflict.
const MARKS: [[u8; 3]; 2] = [[34, 96, 112], [246, 244, 236]];
const CONFLICT: [[u8; 3]; 2] = [[200, 36, 40], [244, 150, 140]];
/// How far plates of walls, of changed columns and of marks lie before the face (metres).
const LEVELS: [f64; 3] = [1e-3, 2e-3, 4e-3];
/// The margin of a mark on each side, as a share of the shorter side of its place.
const FREE: f64 = 0.12;
/// Half the width of the ribbon along an edge in conflict, in modules (half bricks).
const RIBBON: f64 = 0.25;

/// Adds walls in the colours of their phases, and a mark for each row at both sides of each upright edge. The ids of
/// bodies are those of faces and edges.
pub(super) fn add(scene: &mut Scene, laying: &Laying, fit: Fit) {
    add_walls(scene, laying, fit);
    let conflicts = &laying.plan().conflicts;
    for pointing in laying.pointings() {
        let colours = match conflicts.contains(&pointing.edge) {
            true => CONFLICT,
            false => MARKS,
        };
        let id = id_of(laying, Feature::Edge(pointing.edge));
        for ((face, place), colour) in pointing.sides.iter().zip(colours) {
            let mut plates = Plates::new(laying.building().face(*face), fit);
            if let Some(mark) = shrunk(place) {
                plates.add(&mark, LEVELS[2], colour);
            }
            plates.finish(scene, (id, MAP));
        }
    }
    for &edge in conflicts {
        add_ribbons(scene, laying, fit, edge);
    }
}

fn add_walls(scene: &mut Scene, laying: &Laying, fit: Fit) {
    let changed = laying.plan().changed(laying.building());
    for (id, number) in faces(laying) {
        let face = laying.building().face(id);
        if !is_wall(face) {
            continue;
        }
        let sheet = Sheet::new(face);
        let mut plates = Plates::new(face, fit);
        let colour = PHASES[usize::from(laying.plan().grid(id).phase)];
        for part in sheet.parts() {
            plates.add(part, LEVELS[0], colour);
        }
        let [low, high] = face.bounds();
        for [from, to] in changed
            .iter()
            .filter(|(wall, _)| *wall == id)
            .map(|(_, ends)| *ends)
        {
            let strip = Footprint::rectangle(DVec2::new(from, low.y), DVec2::new(to, high.y));
            for part in strip.iter().flat_map(|strip| sheet.within(strip)) {
                plates.add(&part, LEVELS[1], CHANGED);
            }
        }
        plates.finish(scene, (number, MAP));
    }
}

/// The mark of a row: its place without the margin.
fn shrunk(place: &Footprint) -> Option<Footprint> {
    let [low, high] = place.bounds();
    let by = FREE * (high - low).min_element();
    Footprint::rectangle(low + by, high - by)
}

/// Adds ribbons along both sides of an edge.
fn add_ribbons(scene: &mut Scene, laying: &Laying, fit: Fit, id: EdgeId) {
    let edge = laying.building().edge(id);
    let half = RIBBON * laying.plan().module.half;
    let number = id_of(laying, Feature::Edge(id));
    for face in edge.faces.iter().flatten() {
        if let Some(ribbon) = ribbon(laying, *face, id, half) {
            let face = laying.building().face(*face);
            let mut plates = Plates::new(face, fit);
            for part in Sheet::new(face).within(&ribbon) {
                plates.add(&part, LEVELS[1], CONFLICT[0]);
            }
            plates.finish(scene, (number, MAP));
        }
    }
}

/// The ribbon that reaches `half` metres to both sides of an upright edge, in a wall's (s, t).
fn ribbon(laying: &Laying, face: FaceId, id: EdgeId, half: f64) -> Option<Footprint> {
    let edge = laying.building().edge(id);
    let surface = &laying.building().face(face).surface;
    let ends = [0.0, edge.length()].map(|at| surface.project(edge.path.point(at)).truncate());
    let (low, high) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
    Footprint::rectangle(low - DVec2::X * half, high + DVec2::X * half)
}
